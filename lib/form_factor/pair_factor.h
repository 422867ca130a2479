// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/area_points.h"
#include "lib/form_factor/contour.h"
#include "lib/form_factor/ray_blockers.h"

namespace fixrad {

/// A flat part of a face, seen as a source of light: its polygon lifted off the face by half a grid unit, as
/// eye points are, and points evenly spread over it.
class AreaSource {
 public:
  static constexpr int kPoints = 4;

  /// The element of `face` that has these cells. Cost: element_polygon().
  AreaSource(const Scene& scene, const Face& face, const ElementCells& cells);
  AreaSource(const AreaSource&) = delete;
  AreaSource& operator=(const AreaSource&) = delete;

  const Polygon& polygon() const { return polygon_; }

  /// Point `i` of kPoints: Gauss's rule of two points along both coordinates. 1/64 grid unit.
  Vec3 point(int i) const;

  /// Mean over these points of the form factor to `target`, Q1.30; points that see its back count as 0. Cost:
  /// kPoints contour_factor().
  int32_t factor(const Polygon& target) const;

  /// How many of 2^`log2` rays to `target` are not blocked; `pair` names the pair. Cost: as many
  /// RayBlockers::is_blocked().
  uint32_t free_rays(const Polygon& target, int log2, uint32_t pair, RayBlockers& blockers) const;

 private:
  Vec3 normal_;  // Q1.30
  Polygon polygon_;
  AreaPoints points_;
};

}  // namespace fixrad
