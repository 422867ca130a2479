// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/engine.h"
#include "lib/form_factor/spans.h"

namespace fixrad {

/// Resolves what is visible on one row of the current band. False if the span pool is full.
bool find_visible(const Scene& scene, const BandRow& row, Workspace& work, VisibleSpans& visible);

/// Samples the rows first .. first + count - 1 of a cut of the hemisphere, the current band, into `writer`;
/// `base` is the running sum of all rows before and is moved on. False if the span pool is full.
struct BandSample {
  const DeltaTable& table;
  const EyePoint& eye;
  bool is_top;  ///< of a hemicube
  int first, count;
  bool is_closed;  ///< no row shows nothing
};
bool sample_band(const Scene& scene, const BandSample& band, Workspace& work, uint32_t& base,
                 RowWriter& writer);

}  // namespace fixrad
