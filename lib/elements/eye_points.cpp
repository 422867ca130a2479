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

EyeSource patch_source(const Scene& scene, uint16_t patch) {
  const Patch p = flash_read(scene.patches, patch);
  return {p.face, p.first_element, p.element_count, false, p.is_clear != 0, {p.eye[0], p.eye[1], p.eye[2]}};
}

EyeSource element_source(const Scene& scene, uint16_t element) {
  const Element e = flash_read(scene.elements, element);
  const bool is_clear = flash_read(scene.patches, e.patch).is_clear != 0;
  return {e.face, element, 1, true, is_clear, {e.eye[0], e.eye[1], e.eye[2]}};
}

uint16_t source_element(const Scene& scene, const EyeSource& source, uint16_t i) {
  return source.is_single ? source.first
                          : flash_read(scene.patch_elements, static_cast<unsigned>(source.first) + i);
}

int level_for(const EyeSource& source, uint32_t wanted) {
  if (wanted <= 1) {
    return 0;
  }
  int level = 1;
  while (level < kFinestLevel && candidate_count(source, level) < wanted &&
         candidate_count(source, level + 1) <= kMaxEyes) {
    ++level;
  }
  return level;
}

EyeCandidate eye_candidate(const Scene& scene, const EyeSource& source, int level, uint16_t index) {
  if (level == 0) {
    return {vec(source.centre), source_element(scene, source, 0), 1};
  }
  const unsigned per_element = static_cast<unsigned>(level * level);
  const uint16_t id = source_element(scene, source, static_cast<uint16_t>(index / per_element));
  const Element element = flash_read(scene.elements, id);
  const int sub = static_cast<int>(index % per_element);
  const Face face = flash_read(scene.faces, source.face);
  if (level == 1 || !is_whole_cell(element, face)) {
    return {vec(element.eye), id, static_cast<uint8_t>(sub == 0 ? per_element : 0)};
  }
  return {sub_cell(face, vec(element.eye), level, sub % level, sub / level), id, 1};
}

}  // namespace fixrad
