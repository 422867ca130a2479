// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_sampling.h"

namespace fixrad {
namespace {

uint32_t hidden_on_row(const VisibleSpans& visible, const DeltaRow& delta, bool nothing_hides,
                       const Workspace& work) {
  uint32_t sum = 0;
  for (uint16_t i = 0; i < visible.count(); ++i) {
    const uint16_t view = visible.view(i);
    if (view == kNothing ? nothing_hides : work.views[view].is_back) {
      const Interval part = visible.part(i);
      sum += delta.sum_to(part.end) - delta.sum_to(part.begin);
    }
  }
  return sum;
}

}  // namespace

Status hidden_share(const Scene& scene, const DeltaTable& table, const EyePoint& eye, bool nothing_hides,
                    Workspace& work, uint32_t& share) {
  make_view(scene, eye, Backs::all, work);
  VisibleSpans visible(scene, eye, work);
  const int size = 1 << table.resolution_log2;
  uint32_t hidden = 0;
  uint32_t all = 0;
  for (int first = 0; first < size; first += kBandRows) {
    const int count = band_count(table, first);
    enter_band(scene, table, first, count, work);
    for (int i = 0; i < count; ++i) {
      const BandRow row = band_row(table, first, i);
      if (!find_visible(scene, row, work, visible)) {
        return Status::span_pool_full;
      }
      const DeltaRow delta = delta_row(table, true, first + i);
      hidden += hidden_on_row(visible, delta, nothing_hides, work);
      all += 2 * delta.half_total;
    }
  }
  // cppcheck-suppress zerodiv  ; a table has rows, and each a sum
  share = static_cast<uint32_t>(static_cast<uint64_t>(hidden) * kRowOne / all);
  return Status::ok;
}

}  // namespace fixrad
