// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_sampling.h"

namespace fixrad {

Status hemicube_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                     FormFactorRow& row) {
  ViewCursor& at = work.at;
  if (at.next == 0) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    make_view(scene, sample.eye, backs_in(sample), work);
    make_grids(scene, sample.eye, work);
    make_depths(scene, sample.eye, work);  // before they are turned from side to side
    at.next = 1;
    spend(work);
  }
  VisibleSpans visible(scene, sample.eye, work);
  RowWriter writer(row, sample.weight, at.sum);
  for (int done = at.done(); done < 3 << table.resolution_log2; ++done, ++at.next, spend(work)) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    const SideRow place = side_row(table, done);
    enter_side_row(scene, table, place, work);
    const RowSample part = {table, place.side == kTop, place.first, place.row - place.first,
                            !sample.back_faces};
    if (!sample_row(scene, part, work, visible, writer)) {
      return end_view(work, Status::span_pool_full);
    }
  }
  return end_view(work, Status::ok);
}

}  // namespace fixrad
