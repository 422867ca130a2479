// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "lib/form_factor/cell_polygon.h"
#include "lib/form_factor/view.h"

namespace fixrad::host {

/// Area-averaged form factors between the input faces of a scene from the core's contour formula, without
/// elements: exact over the receiver, by a converged rule over the points of the smaller of the two.
class ClosedFormFactors {
 public:
  /// `device` holds the same faces as `scene`, in the same order; both must outlive the object.
  ClosedFormFactors(const PreparedScene& scene, const DeviceScene& device);

  /// F from input face i to j (of the file; with two-sided faces the mean over both sides). Nothing if some
  /// face may stand between them. Error: about 1e-4 of F, from the rule over the smaller face, plus the
  /// grid's rounding. Cost: some hundred contours a pair, up to 16,384 for pairs that touch or nearly do.
  std::optional<double> factor(std::uint32_t i, std::uint32_t j);

 private:
  // A convex piece of an input face.
  struct Part {
    std::uint32_t face;  // of the device
    Polygon polygon;
    double area;  // grid units squared
  };

  bool is_free(const Part& from, const Part& to);
  double exchange_area(const Part& a, const Part& b) const;
  double mean_factor(const Part& from, const Part& to, int points) const;

  const DeviceScene& device_;
  Scene scene_;
  std::vector<std::vector<Part>> parts_;  // [file faces]
  std::vector<FaceView> views_;
  Workspace work_ = {};
};

}  // namespace fixrad::host
