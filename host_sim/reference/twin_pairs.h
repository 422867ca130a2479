// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/reference/twin_hemisphere.h"
#include "lib/form_factor/ray_pairs.h"

namespace fixrad::host {

/// The core's engines by pairs in double: contour_row() and ray_row() with exact normals and arcs. Polygons
/// of elements are the core's integers, the input of both, and so is which rays are blocked, which the core
/// decides without rounding.
class TwinPairs {
 public:
  /// Both scenes are the same, and must outlive the object with their tables.
  TwinPairs(const Scene& scene, const TwinScene& twin);

  /// Adds the form factors from one eye point, eye.sample.weight / kRowOne in all.
  void add_contours(const RecordedEye& eye, TwinFormFactors& row) const;
  void add_rays(const RecordedEye& eye, TwinFormFactors& row);

 private:
  double factor(const Vec3& point, std::uint32_t from_face, const Polygon& polygon) const;
  double mean_factor(const AreaSource& source, std::uint32_t from_face, const Polygon& target) const;
  bool shows_front(std::uint32_t face, const EyePoint& eye) const;
  double lost_share(const RecordedEye& eye);
  double add_ray_face(std::uint32_t f, const RecordedEye& eye, RayPairs& pairs, TwinFormFactors& row);

  Scene scene_;
  const TwinScene& twin_;
  TwinHemisphere lunes_;
  std::vector<FaceView> views_;
  Workspace work_ = {};
};

}  // namespace fixrad::host
