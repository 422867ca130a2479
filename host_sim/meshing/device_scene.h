// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host_sim/meshing/convex_faces.h"
#include "host_sim/meshing/element_grid.h"
#include "host_sim/meshing/element_mesh.h"
#include "lib/scene/scene.h"
#include "lib/vertices/vertex_radiosity.h"

namespace fixrad::host {

/// Which input face an element lies on, and how much of it. Elements of joined faces may have several.
struct Overlap {
  std::uint32_t element, input_face;
  double area;  ///< scene units
};

/// A scene before it is cut into elements: everything that does not depend on their number.
struct PreparedScene {
  const Model* model = nullptr;
  QuantisedVertices vertices;
  std::vector<ConvexFace> faces;
  std::vector<FaceFrame> frames;  ///< [faces]
  std::vector<std::string> warnings;
  int channels = 3;  ///< 1 if every reflectance and emission is grey
};

/// Reads nothing but the model; throws InputError if nothing with an area is left or the core's counts are
/// exceeded.
PreparedScene prepare(const Model& model);
PreparedScene prepare(const Model&& model) = delete;  // it would end before the scene that points at it

/// The cut faces of a scene and how their elements are grouped for shooting.
struct Meshing {
  std::vector<FaceElements> faces;
  int block_u = 1, block_v = 1;  ///< a patch is up to block_u x block_v cells
  std::uint32_t element_count = 0, patch_count = 0;
};

/// Uniform mesh of at most `elements` elements (but at least one a face), grouped into at most `patches`
/// patches where that is possible. Lamps get 2 x 2 cells at least if there is room.
Meshing make_uniform(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches);

/// A scene in the core's records, with the numbers that lead back to physical units. Owns the tables that
/// `view()` points at; must not move while a solver uses them.
struct DeviceScene {
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> corners;
  std::vector<fixrad::Face> faces;
  std::vector<CellRow> cell_rows;
  std::vector<std::uint16_t> roots;  ///< empty: no cell is cut
  std::vector<Cut> cuts;
  std::vector<Element> elements;
  std::vector<Patch> patches;
  std::vector<std::uint16_t> patch_elements;
  std::vector<fixrad::Material> materials;
  std::vector<Sight> sights;  ///< [elements], or empty
  int channels = 3;
  int emission_shift = 0, radiosity_shift = 0;
  double unit_watts = 1;      ///< one flux unit, W
  double unit_radiosity = 1;  ///< one radiosity unit, W/m^2
  Grid grid;
  ElementMesh mesh;               ///< the same elements in double, same order
  std::vector<Overlap> overlaps;  ///< ordered by element

  Scene view() const;
  std::size_t rom_bytes() const;  ///< of the tables, as a 32-bit target lays them out
};

DeviceScene make_device_scene(const PreparedScene& scene, const Meshing& meshing);

/// A point of a face (grid units) as an eye: quarters of a grid unit, lifted along the normal until the core
/// sees it on the lit side.
Vec3 lifted_eye(const PreparedScene& scene, std::size_t face, glm::dvec3 point);

/// Area-weighted mean radiosity of each input face, in file order. A face that has no element (it collapsed
/// on the grid) gets its own emission.
std::vector<glm::dvec3> face_means(const Model& model, const std::vector<Overlap>& overlaps,
                                   const std::vector<glm::dvec3>& element_radiosity);

/// Area of each face of the model, scene units.
std::vector<double> face_areas(const Model& model);

}  // namespace fixrad::host
