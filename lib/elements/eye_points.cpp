// SPDX-License-Identifier: MIT
#include "lib/elements/eye_points.h"

namespace fixrad {
namespace {

// Lengths of parts of a cell, against its own.
constexpr int32_t kWholeLength = 16;

// Offset of sub-cell i of `level` from the middle of a cell: axis * ((2 i + 1) / level - 1) / 2 / cells, in
// quarters of a grid unit, rounded towards zero so that opposite eyes stay opposite; `length` of it.
int32_t along(int32_t axis, int i, int level, int cells, int32_t length) {
  return axis * kEyeScale * (2 * i + 1 - level) / (2 * level * cells) * length / kWholeLength;
}

// Keeps an eye where load() has seen its neighbours: axes that do not fit their face must not lead off the
// grid.
int32_t on_grid(int32_t a) {
  return a < 0 ? 0 : (a > 0xffff ? 0xffff : a);
}

Vec3 sub_cell(const Face& face, const Vec3& centre, int level, int i, int j, int32_t length) {
  const Vec3 u = vec(face.axis_u);
  const Vec3 v = vec(face.axis_v);
  const auto offset = [&](int32_t along_u, int32_t along_v) {
    return along(along_u, i, level, face.cells_u, length) + along(along_v, j, level, face.cells_v, length);
  };
  return {on_grid(centre.x + offset(u.x, v.x)), on_grid(centre.y + offset(u.y, v.y)),
          on_grid(centre.z + offset(u.z, v.z))};
}

// Square root of the element's part of a whole cell, rounded down.
int32_t length_of(const Element& element, const Face& face) {
  const uint32_t cell = face.cell_area / (kWholeLength * kWholeLength);
  int32_t length = kWholeLength;
  while (length > 0 && static_cast<uint32_t>(length * length) * cell > element.area) {
    --length;
  }
  return length;
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
  const bool is_whole = is_whole_cell(element, face);
  if (level == 1 || (!is_whole && scene.roots == nullptr)) {
    return {vec(element.eye), index == 0};
  }
  const int n = static_cast<int>(level), i = static_cast<int>(index);
  const int32_t length = is_whole ? kWholeLength : length_of(element, face);
  return {sub_cell(face, vec(element.eye), n, i % n, i / n, length), true};
}

}  // namespace fixrad
