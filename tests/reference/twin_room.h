// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/scene/scene.h"

namespace fixrad::host {

/// A hand-made scene in the core's records, of parallelograms. Owns the tables that scene() points at.
class TwinRoom {
 public:
  /// Returns the material's index. Each channel: reflectance in [0, 1), emission in [0, 1] of a common unit.
  std::uint16_t add_material(std::array<double, 3> reflectance, std::array<double, 3> emission);

  /// A parallelogram from `origin` along `u` and `v` (grid units), lit side along u x v, of n x n elements; n
  /// x n / 4 patches if n is even, else one patch an element.
  void add_quad(Vec3 origin, Vec3 u, Vec3 v, unsigned n, std::uint16_t material);

  /// Six quads seen from inside (`is_room`) or from outside; `w` along u x v.
  void add_box(Vec3 origin, Vec3 u, Vec3 v, Vec3 w, bool is_room, unsigned n, std::uint16_t material);

  /// Chooses the flux unit; call once, after everything has been added.
  Scene scene(unsigned channels = 3);

 private:
  std::uint16_t vertex_at(Vec3 p);
  void add_elements(const Face& face, std::uint16_t face_index, unsigned n);

  std::vector<Vertex> vertices_;
  std::vector<std::uint16_t> corners_;
  std::vector<Face> faces_;
  std::vector<CellRow> cell_rows_;
  std::vector<Element> elements_;
  std::vector<Patch> patches_;
  std::vector<std::uint16_t> patch_elements_;
  std::vector<Material> materials_;
};

}  // namespace fixrad::host
