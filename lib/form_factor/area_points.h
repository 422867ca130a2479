// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/cell_polygon.h"

namespace fixrad {

/// At most so many rays a pair; a power of two.
constexpr int kMaxRaysLog2 = 5;

/// Where one ray begins and ends: two pairs of coordinates, each UQ0.16.
struct RayCoordinates {
  uint16_t from_s, from_t, to_s, to_t;
};

/// Ray `i` of 2^`log2` between a pair of surfaces: a Hammersley set in four dimensions (i/n and the first
/// three of Sobol 1967), so each coordinate alone, and begin and end together, are stratified. `pair` names
/// the pair; its set is shifted digit by digit by a hash of it, the same everywhere. Cost: 30 exclusive ors
/// and two hashes.
RayCoordinates ray_coordinates(int i, int log2, uint32_t pair);

/// The point of a convex polygon at coordinates (s, t), UQ0.16, 1/64 grid unit: on a parallelogram along its
/// sides, else in a fan of triangles chosen by area. Equal areas get equal parts of the unit square. Of a
/// polygon without area (cuts may leave nothing of an element) it is any point on the grid. Cost: 6 wide
/// products, for other polygons 12 a corner more.
class AreaPoints {
 public:
  explicit AreaPoints(const Polygon& polygon);

  Vec3 at(uint16_t s, uint16_t t) const;

 private:
  const Polygon& polygon_;
  bool is_parallelogram_;
  uint32_t part_[Polygon::kMost - 2];  // running areas of the fan's triangles, one unit for all
};

}  // namespace fixrad
