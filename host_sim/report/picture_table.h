// SPDX-License-Identifier: MIT
// A baked mesh as the core's renderer takes it.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/meshing/quantise.h"
#include "host_sim/report/baked_mesh.h"
#include "host_sim/report/picture.h"
#include "lib/picture/draw.h"
#include "lib/picture/tone.h"

namespace fixrad::host {

/// The tables of a PictureScene. Vertex i of the mesh is vertex i here; side points follow.
struct PictureTable {
  std::vector<Vertex> vertices;
  std::vector<SidePoint> side_points;
  std::vector<std::int16_t> normals;  ///< [vertices][3], empty where nothing has highlights
  std::vector<PictureTriangle> triangles;
  std::vector<PictureMaterial> materials;
  std::vector<PictureMirror> mirrors;
  std::vector<PictureLamp> lamps;
  int channels = 3;
  PictureCamera camera = {};
  Exposure exposure = {};

  /// Points into this object.
  PictureScene view() const;
};

/// What the core's numbers stand for.
struct DeviceUnits {
  Grid grid;
  double radiosity = 1;  ///< W/m^2 a unit
  int channels = 3;
};

/// Puts a mesh on the grid. Where the side of a triangle passes a vertex of another surface it gets a corner
/// there too, so that rounding opens no crack between surfaces. Throws InputError if the camera is too far
/// away or the mesh has more than 65,535 vertices or triangles.
PictureTable make_picture_table(const BakedMesh& mesh, const DeviceUnits& units, const Display& display,
                                const PictureOptions& picture);

/// The light of the mesh's vertices, as the device computes it from its own radiosities:
/// [vertices][channels].
std::vector<std::uint16_t> exposed_light(const BakedMesh& mesh, const DeviceUnits& units,
                                         const PictureTable& table);

/// The picture that the core draws, `band_rows` rows at a time (the pixels do not depend on it).
Image draw_on_device(const PictureTable& table, const std::vector<std::uint16_t>& light, int band_rows = 16);

/// FNV-1a, 64 bits, over the pixels as the core hands them over: `channels` bytes a pixel, from the top.
std::uint64_t picture_digest(const Image& image, int channels);

}  // namespace fixrad::host
