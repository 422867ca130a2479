// SPDX-License-Identifier: MIT
#include "lib/elements/eye_points.h"

namespace fixrad {
namespace {

// Offset of sub-cell i of `level` from the middle of a cell: axis * ((2 i + 1) / level - 1) / 2 / cells, in
// quarters of a grid unit, rounded towards zero so that opposite eyes stay opposite.
int32_t along(int32_t axis, int i, int level, int cells) {
  return axis * kEyeScale * (2 * i + 1 - level) / (2 * level * cells);
}

// Keeps an eye where load() has seen its neighbours: axes that do not fit their face must not lead off the
// grid.
int32_t on_grid(int32_t a) {
  return a < 0 ? 0 : (a > 0xffff ? 0xffff : a);
}

Vec3 sub_cell(const Face& face, const Vec3& centre, int level, int i, int j) {
  const Vec3 u = vec(face.axis_u);
  const Vec3 v = vec(face.axis_v);
  return {on_grid(centre.x + along(u.x, i, level, face.cells_u) + along(v.x, j, level, face.cells_v)),
          on_grid(centre.y + along(u.y, i, level, face.cells_u) + along(v.y, j, level, face.cells_v)),
          on_grid(centre.z + along(u.z, i, level, face.cells_u) + along(v.z, j, level, face.cells_v))};
}

bool is_whole_cell(const Element& element, const Face& face) {
  return element.area / 16 * 16 >= face.cell_area / 16 * 15 && element.area / 17 <= face.cell_area / 16;
}

}  // namespace

EyeSource element_source(const Scene& scene, uint16_t element) {
  return {SourceKind::element, flash_read(scene.elements, element).face, element, 1};
}

EyeSource patch_source(const Scene& scene, uint16_t patch) {
  const Patch p = flash_read(scene.patches, patch);
  return {SourceKind::patch, p.face, p.first_element, p.element_count};
}

EyeSource face_source(const Scene& scene, uint16_t first) {
  const uint16_t face = flash_at(scene.elements, first).face;
  uint16_t end = static_cast<uint16_t>(first + 1);
  while (end < scene.element_count && flash_at(scene.elements, end).face == face) {
    ++end;
  }
  return {SourceKind::face, face, first, static_cast<uint16_t>(end - first)};
}

unsigned level_for(uint32_t wanted) {
  unsigned level = 1;
  while (level < kFinestLevel && level * level < wanted) {
    ++level;
  }
  return level;
}

EyeCandidate eye_candidate(const Scene& scene, uint16_t id, unsigned level, unsigned index) {
  const Element element = flash_read(scene.elements, id);
  const Face face = flash_read(scene.faces, element.face);
  if (level == 1 || !is_whole_cell(element, face)) {
    return {vec(element.eye), index == 0};
  }
  const int n = static_cast<int>(level), i = static_cast<int>(index);
  return {sub_cell(face, vec(element.eye), n, i % n, i / n), true};
}

}  // namespace fixrad
