// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "host_sim/reference/twin_delta_table.h"
#include "host_sim/reference/twin_recorder.h"
#include "host_sim/reference/twin_spans.h"

namespace fixrad::host {

/// A row of form factors in double: what was added sums to the weight of the eyes that added it.
struct TwinFormFactors {
  std::vector<double> share;  ///< [elements]
  double escaped = 0;         ///< hits nothing
  double back = 0;            ///< the nearest hit is a back face
};

enum class TwinEngine { rows, pixels, lunes };

/// The core's engines in double: what an eye sees of the hemisphere above it, along rows of a hemicube, in
/// its pixels or along lunes. Tables are made when an eye first asks for them, and kept.
class TwinHemisphere {
 public:
  /// `scene` must outlive the object.
  TwinHemisphere(const TwinScene& scene, TwinEngine engine);

  /// Adds the form factors from one eye point, eye.sample.weight / kRowOne in all.
  void add(const RecordedEye& eye, TwinFormFactors& row);

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

  const TwinDeltaTable& hemicube_table(int resolution);

  void add_hemicube_rows(const RecordedEye& eye, TwinFormFactors& row);
  void add_lunes(const RecordedEye& eye, TwinFormFactors& row);
  void sample_row(int r, const TwinRow& at, bool is_closed, Sink sink);
  void find_visible(int r, const TwinRow& at);
  void write_row(const TwinRow& at, bool is_closed, Sink& sink) const;
  std::uint32_t covering_view(std::uint32_t i, std::uint32_t previous, bool is_closed) const;

  void add_pixels(const RecordedEye& eye, TwinFormFactors& row);
  void draw_face(int side, int size, TwinFaceView& seen);
  static void draw(Item* items, int size, const TwinRow& at, const TwinFaceView& seen, std::uint32_t slot,
                   TwinInterval part);
  void write_pixels(int side, const TwinDeltaTable& table, int size, double weight,
                    TwinFormFactors& row) const;

  const TwinScene& scene_;
  TwinEngine engine_;
  std::map<int, TwinDeltaTable> tables_;  // of hemicubes, by R
  TwinView view_;
  TwinSpans visible_;
  std::vector<Item> items_;  // [R][R], pixels only
};

}  // namespace fixrad::host
