// SPDX-License-Identifier: MIT
#include "tests/device/box_scene.h"

namespace fixrad {
namespace device_test {
namespace {

constexpr uint32_t kCellArea = 4096ul * 4096ul * 8ul;  // UQ29.3

constexpr FIXRAD_IN_FLASH Vertex kVertices[] = {{0, 0, 0},       {8192, 0, 0},      {0, 8192, 0},
                                                {8192, 8192, 0}, {0, 0, 8192},      {8192, 0, 8192},
                                                {0, 8192, 8192}, {8192, 8192, 8192}};

constexpr FIXRAD_IN_FLASH uint16_t kCorners[] = {0, 2, 6, 4, 1, 5, 7, 3, 0, 4, 5, 1,
                                                 2, 3, 7, 6, 0, 1, 3, 2, 4, 6, 7, 5};

// Faces in the order -x +x -y +y -z +z, each with a material of the same index.
constexpr FIXRAD_IN_FLASH Face kFaces[] = {
    {0, 0, 0, 4, 2, 2, {16384, 0, 0}, {0, 16384, 0}, {0, 0, 0}, {0, 8192, 0}, {0, 0, 8192}, kCellArea},
    {4, 1, 2, 4, 2, 2, {-16384, 0, 0}, {0, 0, 16384}, {8192, 0, 0}, {0, 0, 8192}, {0, 8192, 0}, kCellArea},
    {8, 2, 4, 4, 2, 2, {0, 16384, 0}, {0, 0, 16384}, {0, 0, 0}, {0, 0, 8192}, {8192, 0, 0}, kCellArea},
    {12, 3, 6, 4, 2, 2, {0, -16384, 0}, {16384, 0, 0}, {0, 8192, 0}, {8192, 0, 0}, {0, 0, 8192}, kCellArea},
    {16, 4, 8, 4, 2, 2, {0, 0, 16384}, {16384, 0, 0}, {0, 0, 0}, {8192, 0, 0}, {0, 8192, 0}, kCellArea},
    {20, 5, 10, 4, 2, 2, {0, 0, -16384}, {0, 16384, 0}, {0, 0, 8192}, {0, 8192, 0}, {8192, 0, 0}, kCellArea}};

constexpr FIXRAD_IN_FLASH CellRow kCellRows[] = {{0, 0, 1},  {2, 0, 1},  {4, 0, 1},  {6, 0, 1},
                                                 {8, 0, 1},  {10, 0, 1}, {12, 0, 1}, {14, 0, 1},
                                                 {16, 0, 1}, {18, 0, 1}, {20, 0, 1}, {22, 0, 1}};

constexpr FIXRAD_IN_FLASH Element kElements[] = {
    {kCellArea, {2, 8192, 8192}, 0, 0, 0},      {kCellArea, {2, 24576, 8192}, 0, 0, 0},
    {kCellArea, {2, 8192, 24576}, 0, 0, 0},     {kCellArea, {2, 24576, 24576}, 0, 0, 0},
    {kCellArea, {32766, 8192, 8192}, 1, 1, 1},  {kCellArea, {32766, 8192, 24576}, 1, 1, 1},
    {kCellArea, {32766, 24576, 8192}, 1, 1, 1}, {kCellArea, {32766, 24576, 24576}, 1, 1, 1},
    {kCellArea, {8192, 2, 8192}, 2, 2, 2},      {kCellArea, {8192, 2, 24576}, 2, 2, 2},
    {kCellArea, {24576, 2, 8192}, 2, 2, 2},     {kCellArea, {24576, 2, 24576}, 2, 2, 2},
    {kCellArea, {8192, 32766, 8192}, 3, 3, 3},  {kCellArea, {24576, 32766, 8192}, 3, 3, 3},
    {kCellArea, {8192, 32766, 24576}, 3, 3, 3}, {kCellArea, {24576, 32766, 24576}, 3, 3, 3},
    {kCellArea, {8192, 8192, 2}, 4, 4, 4},      {kCellArea, {24576, 8192, 2}, 4, 4, 4},
    {kCellArea, {8192, 24576, 2}, 4, 4, 4},     {kCellArea, {24576, 24576, 2}, 4, 4, 4},
    {kCellArea, {8192, 8192, 32766}, 5, 5, 5},  {kCellArea, {8192, 24576, 32766}, 5, 5, 5},
    {kCellArea, {24576, 8192, 32766}, 5, 5, 5}, {kCellArea, {24576, 24576, 32766}, 5, 5, 5}};

// The last has no elements and is not counted, but by a test of what load() refuses.
constexpr FIXRAD_IN_FLASH Patch kPatches[] = {{0, 0, 4},  {1, 4, 4},  {2, 8, 4}, {3, 12, 4},
                                              {4, 16, 4}, {5, 20, 4}, {5, 24, 0}};

constexpr FIXRAD_IN_FLASH uint16_t kPatchElements[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11,
                                                       12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23};

}  // namespace

Scene box_scene(const FIXRAD_FLASH Material* materials, uint8_t faces, uint8_t channels) {
  Scene scene = {};
  scene.vertices = kVertices;
  scene.corners = kCorners;
  scene.faces = kFaces;
  scene.cell_rows = kCellRows;
  scene.elements = kElements;
  scene.patches = kPatches;
  scene.patch_elements = kPatchElements;
  scene.materials = materials;
  scene.vertex_count = 8;
  scene.corner_count = static_cast<uint16_t>(4 * faces);
  scene.face_count = faces;
  scene.cell_row_count = static_cast<uint16_t>(2 * faces);
  scene.element_count = static_cast<uint16_t>(kElementsPerFace * faces);
  scene.patch_count = faces;
  scene.material_count = faces;
  scene.channels = channels;
  scene.emission_shift = 32;   // kEmission * kCellArea / 2^32 = kEmitted
  scene.radiosity_shift = 27;  // of an element: its flux, since kCellArea = 2^27
  return scene;
}

Settings box_settings() {
  Settings settings;
  settings.engine = hemicube_rows;
  settings.tables = settings.probe = &kDelta16;
  settings.table_count = 1;
  settings.flux_per_eye = fraction(9, 10);
  return settings;
}

BoxSolver& box_solver() {
  static BoxSolver solver;
  return solver;
}

Status run(BoxSolver& solver) {
  Status status = Status::ok;
  while (status == Status::ok) {
    status = solver.step();
  }
  return status;
}

}  // namespace device_test
}  // namespace fixrad
