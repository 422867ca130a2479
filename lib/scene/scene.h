// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/fixed/checked.h"
#include "lib/fixed/flash.h"
#include "lib/fixed/q.h"
#include "lib/fixed/vec3.h"

namespace fixrad {

/// Largest vertex coordinate, grid units. 14 bits: an eye in quarters of a unit then has 16, a difference 17
/// with its sign, and its product with a unit vector in Q14 stays below 2^31 (docs/numbers.md).
constexpr int kGridMax = 16383;

/// Eye points are given in quarters of a grid unit.
constexpr int kEyeScale = 4;

/// A unit vector's components: Q14.
constexpr int32_t kUnit = 1 << 14;

/// Distance of a corner from the plane of its face that load() accepts, grid units: corners are rounded to
/// the grid, which moves each by at most sqrt(3)/2, and the normal to Q14, which adds 2^-15 of the extent.
constexpr int32_t kPlaneTolerance = 3;

constexpr int kMaxCorners = 8;
constexpr int kMaxChannels = 3;

struct Vertex {
  int16_t x, y, z;  ///< grid units, 0 .. kGridMax
};

/// A Lambertian material; channels beyond Scene::channels are not read.
struct Material {
  uint32_t reflectance[kMaxChannels];  ///< UQ0.32
  uint32_t emission[kMaxChannels];     ///< flux an area unit, times 2^emission_shift of the scene
};

/// A convex planar face with its affine element grid: the point of grid coordinates (u, v) is
/// origin + u/cells_u * axis_u + v/cells_v * axis_v, and axis_u x axis_v points along normal.
struct Face {
  uint16_t first_corner;  ///< into Scene::corners; counter-clockwise seen from the lit side
  uint16_t material;
  uint16_t first_cell_row;       ///< into Scene::cell_rows, cells_v of them
  uint8_t corner_count;          ///< 3 .. kMaxCorners
  uint8_t cells_u, cells_v;      ///< 1 .. 127
  int16_t normal[3];             ///< Q14, towards the lit side
  int16_t tangent[3];            ///< Q14, perpendicular to normal
  int16_t origin[3];             ///< grid units
  int16_t axis_u[3], axis_v[3];  ///< grid units, the whole extent of the face
  uint32_t cell_area;            ///< UQ29.3 square grid units, of one whole cell
  uint8_t is_sealed = 0;         ///< 1: part of a body into which no eye sees that is not buried
};

/// One row of a face's element grid. Cells left of first_cell or right of last_cell belong to the first or
/// last one of the row (slivers at the border of the face are part of their neighbour). A cell is an element,
/// or, where the scene has roots, what its root says.
struct CellRow {
  uint16_t first_element;  ///< of the row's cells; into Scene::roots where there are any
  uint8_t first_cell, last_cell;
};

/// A straight cut through a cell or a part of one, in the cell's own coordinates: those of the grid, less the
/// cell's number in its row and the number of the first row that shows it (0 .. 1 but for slivers that it has
/// taken in). Parts with a u + b v + c >= 0 are `left`. A side is kLeaf | element, or the index of a further
/// cut. |a|, |b| <= 2^9, |c| < 2^11: Q9.
struct Cut {
  int16_t a, b, c;
  uint16_t left, right;
};

constexpr uint16_t kLeaf = 0x8000;
constexpr int kCutBits = 9;

/// Cuts on the way from a cell to any of its elements.
constexpr int kMostCuts = 8;

/// Elements are ordered by face.
struct Element {
  uint32_t area;    ///< UQ29.3 square grid units, > 0
  uint16_t eye[3];  ///< its centroid, lifted off the face by half a grid unit; quarters of a grid unit
  uint16_t patch;
  uint16_t face;
  uint16_t material;  ///< of the face, repeated here for the inner loop
};

/// Neighbouring elements of a face that shoot together once each of them has little to send.
struct Patch {
  uint16_t face;
  uint16_t first_element;  ///< into Scene::patch_elements
  uint16_t element_count;  ///< 1 .. kMaxPatchElements
};

/// What the scene's maker knows about the eye points of an element. An eye is buried if it stands under or in
/// something: light must not start there.
enum class Sight : uint8_t {
  unknown,  ///< the core probes each eye before it is used
  centroid_clear,
  centroid_buried,
  all_clear  ///< the eyes of every subdivision too
};

constexpr int kMaxPatchElements = 64;

/// A scene: tables in flash, owned by the caller, read only and never copied. Made by the host tool, checked
/// by load().
struct Scene {
  const FIXRAD_FLASH Vertex* vertices;
  const FIXRAD_FLASH uint16_t* corners;
  const FIXRAD_FLASH Face* faces;
  const FIXRAD_FLASH CellRow* cell_rows;
  const FIXRAD_FLASH uint16_t* roots;  ///< [root_count], a side as in Cut; null: no cell is cut
  const FIXRAD_FLASH Cut* cuts;        ///< [cut_count]
  const FIXRAD_FLASH Element* elements;
  const FIXRAD_FLASH Patch* patches;
  const FIXRAD_FLASH uint16_t* patch_elements;  ///< element_count entries, grouped by patch
  const FIXRAD_FLASH Material* materials;
  const FIXRAD_FLASH Sight* sights;  ///< [element_count], or null: nothing is known
  uint16_t vertex_count, corner_count, face_count, cell_row_count, root_count, cut_count, element_count,
      patch_count, material_count;
  uint8_t channels;         ///< 1 or 3
  uint8_t emission_shift;   ///< emitted flux of an element = emission * area >> emission_shift
  uint8_t radiosity_shift;  ///< radiosity of an element = (flux << radiosity_shift) / area
};

inline Vec3 vec(const int16_t (&a)[3]) {
  return {a[0], a[1], a[2]};
}
inline Vec3 vec(const uint16_t (&a)[3]) {
  return {a[0], a[1], a[2]};
}
inline Vec3 vec(Vertex v) {
  return {v.x, v.y, v.z};
}

/// Vertex of corner `k` (0 <= k < corner_count) of `face`, as an index into the vertex table.
inline uint16_t corner_vertex(const Scene& scene, const Face& face, int k) {
  return flash_read(scene.corners, face.first_corner + static_cast<unsigned>(k));
}

inline Sight sight_of(const Scene& scene, uint16_t element) {
  return scene.sights == nullptr ? Sight::unknown : flash_read(scene.sights, element);
}

/// Flux that an element emits by itself, one channel. The product has 64 bits.
inline Flux emitted_flux(const Scene& scene, const Material& material, uint32_t area, int channel) {
  const uint64_t product = static_cast<uint64_t>(material.emission[channel]) * area;
  return Flux::from_raw(narrow<int32_t>(product >> scene.emission_shift, Place::emitted_flux));
}

}  // namespace fixrad
