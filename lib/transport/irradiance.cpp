// SPDX-License-Identifier: MIT
#include "lib/transport/irradiance.h"

#include "lib/transport/shooting.h"

namespace fixrad {

Status gather_irradiance(State& state, const DeltaTable& table, DirectLight direct, const EyePoint& eye,
                         bool is_clear, const Radiosity* ambient, Irradiance& irradiance) {
  abandon_shot(state);
  clear(state.row);
  const EyeSample sample = {eye, kRowOne, !state.is_closed, is_clear};
  const Status status = state.settings.engine(state.scene, table, sample, state.work, state.row);
  if (status != Status::ok) {
    return status;
  }
  if (direct != nullptr) {
    direct(state.scene, eye, state.work, state.row);
  }
  uint64_t sum[kMaxChannels] = {0, 0, 0};
  irradiance.seen = kRowOne - state.row.escaped - state.row.back;
  for (uint16_t j = 0; j < state.row.count; ++j) {
    const uint32_t share = state.row.share[j];
    for (int c = 0; share != 0 && c < state.scene.channels; ++c) {
      sum[c] += wide_product(share, element_radiosity(state, j, c, ambient[c]).raw);
    }
    state.row.share[j] = 0;
  }
  for (int c = 0; c < kMaxChannels; ++c) {
    irradiance.of[c] = Radiosity::from_raw(narrow<uint32_t>(sum[c] / kRowOne, Place::irradiance));
  }
  state.row.escaped = state.row.back = 0;
  return Status::ok;
}

}  // namespace fixrad
