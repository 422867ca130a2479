// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_sampling.h"

namespace fixrad {

Status lune_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                 FormFactorRow& row) {
  ViewCursor& at = work.at;
  if (at.next == 0) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    make_view(scene, sample.eye, backs_in(sample), work);
    make_grids(scene, sample.eye, work);
    at.next = 1;
    spend(work);
  }
  VisibleSpans visible(scene, sample.eye, work);
  RowWriter writer(row, sample.weight, at.sum);
  for (int r = at.done(); r < 1 << table.resolution_log2; ++r, ++at.next, spend(work)) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    const int i = r & (kBandRows - 1);
    if (i == 0) {
      enter_band(scene, table, r, band_count(table, r), work);
    }
    if (!sample_row(scene, {table, true, r - i, i, !sample.back_faces}, work, visible, writer)) {
      return end_view(work, Status::span_pool_full);
    }
  }
  return end_view(work, Status::ok);
}

}  // namespace fixrad
