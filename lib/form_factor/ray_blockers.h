// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/cell_polygon.h"
#include "lib/form_factor/view.h"

namespace fixrad {

/// Faces that can stand between a source and a target, found before any ray is cast: those that lie before
/// both and whose plane separates a part of the one from a part of the other. In a convex room there is none,
/// and no ray is needed. No other structure: scenes for small memories have tens of faces.
///
/// A ray ends on surfaces, so whatever comes within a grid unit of an end does not block there. Uses
/// work.views as memory for two lists of faces; both face and target must outlive the queries.
class RayBlockers {
 public:
  RayBlockers(const Scene& scene, Workspace& work) : scene_(scene), work_(work) {}

  /// Rays start on `source`, a part of face `face`. Cost: 6 products a corner of the scene.
  void enter_source(uint16_t face, const Polygon& source);

  /// Rays end on face `face`. Cost: up to 6 products a corner of the faces before the source, and 3 for each
  /// of them and corner of source and target.
  void enter_target(uint16_t face);

  /// Whether nothing can stand between.
  bool is_free() const { return target_count_ == 0; }

  /// Whether a ray (1/64 grid unit) from the source to the target is blocked. Exact in integers: a ray
  /// through an edge that two faces share meets one of them, whatever is rounded. The face that blocked the
  /// last ray is asked first. Cost: 6 products a face, and up to 9 wide ones a corner of a face whose plane
  /// it meets.
  bool is_blocked(const Vec3& from, const Vec3& to);

 private:
  bool blocks(uint16_t face, const Vec3& from, const Vec3& to) const;

  const Scene& scene_;
  Workspace& work_;
  const Polygon* source_ = nullptr;
  uint16_t source_face_ = 0;
  uint16_t source_count_ = 0;  // faces before the source: views[].face
  uint16_t target_count_ = 0;  // of them, those that can block: views[].first_corner
};

}  // namespace fixrad
