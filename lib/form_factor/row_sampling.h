// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/engine.h"
#include "lib/form_factor/spans.h"

namespace fixrad {

/// Resolves what is visible on one row of the current band. False if the span pool is full.
bool find_visible(const Scene& scene, const BandRow& row, Workspace& work, VisibleSpans& visible);

/// Samples row first + i of a cut of the hemisphere, of the current band, which begins at row `first`, into
/// `writer`; work.at.sum is the running sum of all rows before and is moved on. `visible`: of the view. False
/// if the span pool is full.
struct RowSample {
  const DeltaTable& table;
  bool is_top;  ///< of a hemicube
  int first, i;
  bool is_closed;  ///< no row shows nothing
};
bool sample_row(const Scene& scene, const RowSample& sample, Workspace& work, VisibleSpans& visible,
                RowWriter& writer);

/// A row's place on a hemicube, whose rows come side by side, bottom up; a side's rows begin at the horizon.
struct SideRow {
  int side, row;
  int first;  ///< row of its band
  bool begins_side;

  bool begins_band() const { return row == first; }
};

/// Row `done` (0 .. 3 R - 1) in that order.
SideRow side_row(const DeltaTable& table, int done);

/// Turns the view to the side and enters the band where the row is the first of one.
void enter_side_row(const Scene& scene, const DeltaTable& table, const SideRow& at, Workspace& work);

}  // namespace fixrad
