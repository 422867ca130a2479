// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/report/baked_mesh.h"
#include "host_sim/report/camera.h"

namespace fixrad::host {

/// Linear display value of the background: dark and neutral, yet not the black of an unlit surface.
inline constexpr double kBackground = 0.012;

/// 8-bit sRGB pixels, rows from the top, three bytes a pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

struct PictureOptions {
  int width = 1024;  ///< pixels, 1 to 16384
  int height = 768;
  std::optional<Camera> camera;  ///< automatic_camera where there is none
};

/// The mesh as a person would photograph it: perspective, Gouraud shading on linear radiosity, back faces
/// culled (a room seen from outside is a doll's house), 4 x 4 samples a pixel, with
/// highlights and mirror images where a material has them, tone-mapped by tone.h before samples are averaged
/// (so that edges of lamps stay smooth). Throws std::invalid_argument for a mesh that check_mesh refuses, a
/// size out of range or a camera that looks nowhere. Memory O(triangles + width); time O(triangles + covered
/// samples).
Image render_picture(const BakedMesh& mesh, const Display& display, const PictureOptions& options = {});

}  // namespace fixrad::host
