// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/element_mesh.h"
#include "host_sim/reference/counter_random.h"
#include "host_sim/reference/polygon_sampling.h"
#include "host_sim/reference/visibility.h"

namespace fixrad::host {

/// A point on a surface and the side that is asked about.
struct SurfacePoint {
  glm::dvec3 position{0.0};  ///< scene units
  glm::dvec3 normal{0.0};    ///< unit, of the lit side
};

/// The random numbers of one vertex of a path, in [0, 1): where it goes on, and which point of which lamp it
/// asks.
struct VertexSample {
  double direction_u, direction_v, lamp_u, lamp_v, lamp;
};

/// The random numbers of a path's first two vertices, for an evenly spread set; the rest are drawn one by
/// one.
struct PathSample {
  VertexSample first;
  double lamp_u, lamp_v, lamp;  ///< of the second vertex
};

/// Estimates irradiance by paths through a scene of diffuse polygons. Queries are const and may run on any
/// number of threads.
///
/// From the point cosine-distributed paths run until Russian roulette by reflectance ends them; lamps are
/// also sampled by area at every vertex, both ways weighted by the balance heuristic (E. Veach, L. Guibas,
/// SIGGRAPH 1995), except where most surfaces emit. Unbiased. Back faces are black and block.
class PathEstimator {
 public:
  /// @param polygons  all that is lit or blocks, reflectance in [0, 1); not needed afterwards
  explicit PathEstimator(const std::vector<MeshElement>& polygons);

  /// One estimate of the irradiance at a point, W/m^2. `random` is drawn from as far as the path goes.
  /// Cost: two rays a vertex, 1 / (1 - reflectance) vertices.
  glm::dvec3 irradiance(SurfacePoint point, const PathSample& sample, CounterRandom& random) const;

 private:
  struct Surface {
    glm::dvec3 normal, centroid, reflectance, emission;
    double lamp_density;  ///< density per area with which a point of it is chosen as a lamp's
  };
  struct Lamp {
    std::uint32_t surface;
    double power;  ///< running sum
    PolygonSampler sampler;
  };

  void find_lamps(const std::vector<MeshElement>& polygons);
  glm::dvec3 from_lamp(const SurfacePoint& point, const VertexSample& sample) const;
  double share_of_path(const SurfacePoint& start, const glm::dvec3& met, const Surface& surface) const;

  std::vector<Surface> surfaces_;
  std::vector<std::uint32_t> surface_of_triangle_;
  RayScene scene_;
  std::vector<Lamp> lamps_;
  bool asks_lamps_ = false;
};

}  // namespace fixrad::host
