// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_recorder.h"

namespace fixrad::host {

Observer Recorder::observer() {
  Observer observer = {};
  observer.context = this;
  observer.on_eye = [](void* self, const DeltaTable& table, const EyeSample& sample) {
    static_cast<Recorder*>(self)->eyes_.push_back({sample, 1 << table.resolution_log2});
  };
  observer.on_shot = [](void* self, std::uint16_t patch, const Flux* amount, bool overshoots) {
    static_cast<Recorder*>(self)->take_shot(patch, amount, overshoots);
  };
  observer.on_withdraw = [](void* self) { static_cast<Recorder*>(self)->withdraw(); };
  return observer;
}

void Recorder::take_shot(std::uint16_t patch, const Flux* amount, bool overshoots) {
  RecordedShot shot = {patch, shot_eyes_, eyes_.size() - shot_eyes_, {1, 1, 1}};
  const unsigned channels = state_->scene.channels;
  for (unsigned c = 0; c < channels && overshoots; ++c) {
    const std::int32_t unshot = state_->unshot[patch * channels + c];
    shot.factor[c] = unshot > 0 ? static_cast<double>(amount[c].raw) / unshot : 1.0;
  }
  shots_.push_back(shot);
  shot_eyes_ = eyes_.size();
}

}  // namespace fixrad::host
