// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_sampling.h"

namespace fixrad {

Status lune_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                 FormFactorRow& row) {
  make_view(scene, sample.eye, backs_in(sample), work);
  make_grids(scene, sample.eye, work);
  RowWriter writer(row, sample.weight);
  const int size = 1 << table.resolution_log2;
  uint32_t base = 0;
  for (int first = 0; first < size; first += kBandRows) {
    const int count = band_count(table, first);
    enter_band(scene, table, first, count, work);
    const BandSample band = {table, sample.eye, true, first, count, !sample.back_faces};
    if (!sample_band(scene, band, work, base, writer)) {
      return Status::span_pool_full;
    }
  }
  return Status::ok;
}

}  // namespace fixrad
