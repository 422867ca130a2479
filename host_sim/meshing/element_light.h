// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "host_sim/meshing/direct_light.h"
#include "host_sim/meshing/polygon2d.h"

namespace fixrad::host {

/// The light at a point of a face, (s, t) of its frame.
struct LightSample {
  glm::dvec2 at{0.0};
  double light = 0;        ///< W/m^2
  bool is_buried = false;  ///< under something that stands there: nobody sees it
};

/// Point `i` of an evenly spread sequence on a convex polygon (R2: M. Roberts, "The unreasonable
/// effectiveness of quasirandom sequences", 2018; the unit square is folded onto the triangles of a fan).
glm::dvec2 spread_point(const Polygon2d& polygon, std::uint32_t i);

/// Whether a point lies in a convex polygon, its border included.
bool contains(const Polygon2d& polygon, glm::dvec2 p);

/// Makes those of `points` that lie on a polygon's sides its corners; whether there were any.
bool insert_on_sides(const FaceFrame& frame, Polygon2d& border, const Polygon2d& points);

/// The triangles in which a convex polygon is shown, as corner numbers: the fan whose smallest triangle is
/// largest. Corners may lie on straight sides.
std::vector<std::array<std::size_t, 3>> fan_of(const Polygon2d& polygon);

/// What counts beside light that shading does not show.
struct LightWeights {
  double flat = 0.2;    ///< light that is uneven within an element
  double sender = 0.2;  ///< light that leaves an element, times the square of its size over the scene's area
};

/// What the lamps' direct light would look like on elements: shaded between their corners, as one sees it,
/// and in one colour an element, as the solution has it. Remembers what it has looked up; the scene must
/// outlive it.
class ElementLight {
 public:
  ElementLight(const PreparedScene& scene, const LightWeights& weights);

  LightSample sample(std::uint32_t face, glm::dvec2 at) const;

  /// Sum over an element's samples of how far they are from what is shown there, W/m^2. `border`: its
  /// outline, the corners of its neighbours on it included.
  double error_of(std::uint32_t face, const Polygon2d& border, const std::vector<LightSample>& samples);

 private:
  double corner_light(std::uint32_t face, glm::dvec2 corner, glm::dvec2 inside);
  double sender_error(std::uint32_t face, const Polygon2d& border) const;
  double shading_error(std::uint32_t face, const Polygon2d& border, const std::vector<LightSample>& samples);

  const PreparedScene& scene_;
  DirectLight light_;
  LightWeights weights_;
  double scene_area_ = 0;  // square grid units
  double ambient_ = 0;     // mean irradiance by reflected light, as in a closed room, W/m^2
  std::vector<std::map<std::pair<double, double>, double>> corners_;  // [faces]: light by (s, t)
};

}  // namespace fixrad::host
