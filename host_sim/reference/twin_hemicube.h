// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/reference/twin_delta_table.h"
#include "host_sim/reference/twin_spans.h"
#include "lib/form_factor/engine.h"

namespace fixrad::host {

/// A row of form factors in double: what was added sums to the weight of the eyes that added it.
struct TwinFormFactors {
  std::vector<double> share;  ///< [elements]
  double escaped = 0;         ///< hits nothing
  double back = 0;            ///< the nearest hit is a back face
};

enum class TwinEngine { rows, pixels };

/// The core's two hemicube engines in double. Everything is allocated once.
class TwinHemicube {
 public:
  /// R as the core's tables: 8, 16, 32, 64 or 128. `scene` must outlive the object.
  TwinHemicube(const TwinScene& scene, int resolution, TwinEngine engine);

  /// Adds the form factors from one eye point, sample.weight / kRowOne in all.
  void add(const EyeSample& sample, TwinFormFactors& row);

 private:
  // One pixel: what it shows and its inverse depth.
  struct Item {
    double inverse_depth;
    std::uint32_t slot;
  };

  // Where the visible parts of one row go.
  struct Sink {
    TwinFormFactors& row;
    TwinDeltaRow delta;
    double weight;
    double sum;  // running sum of delta form factors up to the end of the last part

    double advance(double x) {
      const double before = sum;
      sum = delta.sum_to(x);
      return weight * (sum - before);
    }
  };

  void add_rows(const EyeSample& sample, TwinFormFactors& row);
  void find_visible(int r, const TwinRow& at);
  void write_row(const TwinRow& at, bool is_closed, Sink& sink) const;
  std::uint32_t covering_view(std::uint32_t i, std::uint32_t previous, bool is_closed) const;

  void add_pixels(const EyeSample& sample, TwinFormFactors& row);
  void draw_face(int side, TwinFaceView& seen);
  void draw(Item* items, const TwinRow& at, const TwinFaceView& seen, std::uint32_t slot,
            TwinInterval part) const;
  void write_pixels(int side, double weight, TwinFormFactors& row) const;

  const TwinScene& scene_;
  TwinEngine engine_;
  TwinDeltaTable table_;
  TwinView view_;
  TwinSpans visible_;
  std::vector<Item> items_;  // [R][R], pixels only
};

}  // namespace fixrad::host
