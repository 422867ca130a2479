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
  ViewCursor& at = work.at;
  if (at.next == 0) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    make_view(scene, eye, Backs::all, work);
    at.next = 1;
    spend(work);
  }
  VisibleSpans visible(scene, eye, work);
  for (int r = at.done(); r < 1 << table.resolution_log2; ++r, ++at.next, spend(work)) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    const int i = r & (kBandRows - 1);
    if (i == 0) {
      enter_band(scene, table, r, band_count(table, r), work);
    }
    if (!find_visible(scene, band_row(table, r - i, i), work, visible)) {
      return end_view(work, Status::span_pool_full);
    }
    const DeltaRow delta = delta_row(table, true, r);
    at.hidden += hidden_on_row(visible, delta, nothing_hides, work);
    at.sum += 2 * delta.half_total;
  }
  // cppcheck-suppress zerodiv  ; a table has rows, and each a sum
  share = static_cast<uint32_t>(static_cast<uint64_t>(at.hidden) * kRowOne / at.sum);
  return end_view(work, Status::ok);
}

}  // namespace fixrad
