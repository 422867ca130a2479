// SPDX-License-Identifier: MIT
// A furnace: a closed cube whose six faces emit E = 1 and reflect one half. Every face must end at B = E / (1
// - 1/2).
#include <stdio.h>
#include <stdlib.h>

#include "lib/fixrad.h"

namespace {

constexpr int16_t kSide = 4096;                              // grid units
constexpr uint32_t kFaceArea = uint32_t{kSide} * kSide * 8;  // UQ29.3
constexpr uint32_t kEmission = 1u << 10;                     // flux an area unit, times 2^17
constexpr long kEmittedRadiosity = 1L << 13;  // ((kEmission * kFaceArea >> 17) << 20) / kFaceArea

fixrad::Vertex vertices[8];
uint16_t corners[24];
fixrad::Face faces[6];
fixrad::CellRow cell_rows[6];
fixrad::Element elements[6];
fixrad::Patch patches[6];
uint16_t patch_elements[6];
const fixrad::Material kHalf = {{0x80000000u, 0, 0}, {kEmission, 0, 0}};

/// Corner `bits` of the cube: bit k set means the far end of axis k.
fixrad::Vertex cube_corner(unsigned bits) {
  const auto at = [bits](unsigned axis) {
    return static_cast<int16_t>(((bits >> axis) & 1u) != 0 ? kSide : 0);
  };
  return {at(0), at(1), at(2)};
}

/// The face across `axis`, at its far end or not, seen from inside.
void set_face(uint16_t index, unsigned axis, bool is_far) {
  fixrad::Face& face = faces[index];
  // axis_u x axis_v points along +axis, which is the inside of the near face.
  unsigned u = (axis + 1) % 3;
  unsigned v = (axis + 2) % 3;
  if (is_far) {
    const unsigned w = u;
    u = v;
    v = w;
  }
  const unsigned base = is_far ? 1u << axis : 0u;
  const unsigned turn[4] = {base, base | 1u << u, base | 1u << u | 1u << v, base | 1u << v};
  for (unsigned k = 0; k < 4; ++k) {
    corners[4 * index + k] = static_cast<uint16_t>(turn[k]);
  }
  face.first_corner = static_cast<uint16_t>(4 * index);
  face.corner_count = 4;
  face.first_cell_row = index;
  face.cells_u = face.cells_v = 1;
  face.normal[axis] = static_cast<int16_t>(is_far ? -fixrad::kUnit : fixrad::kUnit);
  face.tangent[u] = static_cast<int16_t>(fixrad::kUnit);
  face.origin[axis] = is_far ? kSide : int16_t{0};
  face.axis_u[u] = kSide;
  face.axis_v[v] = kSide;
  face.cell_area = kFaceArea;
  cell_rows[index] = {index, 0, 0};

  // The middle of the face, half a grid unit above it, in quarters of a unit.
  uint16_t eye[3] = {2 * kSide, 2 * kSide, 2 * kSide};
  eye[axis] = static_cast<uint16_t>(is_far ? 4 * kSide - 2 : 2);
  elements[index] = {kFaceArea, {eye[0], eye[1], eye[2]}, index, index};
  patches[index] = {index, index, 1};
  patch_elements[index] = index;
}

}  // namespace

int main() {
  for (unsigned bits = 0; bits < 8; ++bits) {
    vertices[bits] = cube_corner(bits);
  }
  for (uint16_t i = 0; i < 6; ++i) {
    set_face(i, i / 2u, i % 2 != 0);
  }
  fixrad::Scene scene = {};
  scene.vertices = vertices;
  scene.corners = corners;
  scene.faces = faces;
  scene.cell_rows = cell_rows;
  scene.elements = elements;
  scene.patches = patches;
  scene.patch_elements = patch_elements;
  scene.materials = &kHalf;
  scene.vertex_count = 8;
  scene.corner_count = 24;
  scene.face_count = scene.cell_row_count = scene.element_count = scene.patch_count = 6;
  scene.material_count = 1;
  scene.channels = 1;
  scene.emission_shift = 17;
  scene.radiosity_shift = 20;

  static fixrad::Solver<fixrad::Limits<8, 6, 6>> solver;
  fixrad::Status status = solver.load(scene);
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  if (status != fixrad::Status::converged) {
    printf("status %d\n", static_cast<int>(status));
    return 1;
  }
  for (uint16_t e = 0; e < 6; ++e) {
    const long radiosity =
        static_cast<long>(element_radiosity(solver.state(), e, 0, fixrad::Radiosity::from_raw(0)).raw);
    printf("face %d: B / E = %ld / %ld\n", int{e}, radiosity, kEmittedRadiosity);
    if (labs(radiosity - 2 * kEmittedRadiosity) > kEmittedRadiosity / 100) {
      return 1;
    }
  }
  return 0;
}
