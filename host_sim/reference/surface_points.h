// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/meshing/element_mesh.h"
#include "host_sim/reference/path_estimator.h"

namespace fixrad::host {

/// A point at which irradiance is asked for.
struct SamplePoint {
  SurfacePoint surface;
  glm::dvec3 reflectance{0.0};
  glm::dvec3 emission{0.0};
  std::uint32_t input_face = 0;
};

/// `count` points spread evenly by area (Sobol) over the polygons that reflect and, unless all do, do not
/// emit. Left out are points that nobody sees, in or under something: more than half of the directions over
/// them, cosine-weighted, meet the back of a face first. A scene gives the same points always, the first of
/// 1,000 are those of 100.
/// @return fewer than `count` only where hardly any point can be seen
/// Cost: 64 rays a point.
std::vector<SamplePoint> surface_points(const std::vector<MeshElement>& polygons, std::size_t count);

}  // namespace fixrad::host
