// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {
namespace {

bool is_lamp(const PreparedScene& scene, std::size_t f) {
  return scene.model->materials[scene.faces[f].material].emission != glm::dvec3(0.0);
}

// Gives up, with part of the faces, once there are more than `most` elements.
std::vector<FaceElements> cut_all(const PreparedScene& scene, double h, int least_on_lamps,
                                  std::uint32_t most, std::uint32_t& count) {
  std::vector<FaceElements> faces;
  count = 0;
  for (std::size_t f = 0; f < scene.faces.size() && count <= most; ++f) {
    const auto [nu, nv] = cells_for_size(scene.frames[f], h, is_lamp(scene, f) ? least_on_lamps : 1);
    faces.push_back(cut_face(scene.frames[f], nu, nv));
    count += static_cast<std::uint32_t>(faces.back().elements.size());
  }
  return faces;
}

std::uint32_t blocks(int cells, int block) {
  return static_cast<std::uint32_t>((cells + block - 1) / block);
}

// Upper bound of the number of patches: cut faces use fewer blocks than their grid has.
std::uint32_t count_patches(const Meshing& meshing) {
  std::uint32_t count = 0;
  for (const FaceElements& face : meshing.faces) {
    const std::uint32_t grid = blocks(face.cells_u, meshing.block_u) * blocks(face.cells_v, meshing.block_v);
    count += std::min(grid, static_cast<std::uint32_t>(face.elements.size()));
  }
  return count;
}

}  // namespace

Meshing make_uniform(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches) {
  double total = 0;
  for (const FaceFrame& frame : scene.frames) {
    total += frame.unit_area();
  }
  const std::uint32_t lamp_faces = [&] {
    std::uint32_t n = 0;
    for (std::size_t f = 0; f < scene.faces.size(); ++f) {
      n += is_lamp(scene, f) ? 1u : 0u;
    }
    return n;
  }();
  const auto face_count = static_cast<std::uint32_t>(scene.faces.size());
  const int least_on_lamps = elements >= face_count + 6 * lamp_faces ? 2 : 1;
  Meshing best;
  double low = std::sqrt(total / std::max(1u, elements)) / 4;
  double high = low * 64;
  best.faces = cut_all(scene, high * 1e6, least_on_lamps, std::numeric_limits<std::uint32_t>::max(),
                       best.element_count);
  for (int i = 0; i < 24; ++i) {
    const double middle = std::sqrt(low * high);
    std::uint32_t count = 0;
    std::vector<FaceElements> faces = cut_all(scene, middle, least_on_lamps, elements, count);
    if (count <= elements) {
      high = middle;
      if (count >= best.element_count) {
        best.faces = std::move(faces);
        best.element_count = count;
      }
    } else {
      low = middle;
    }
  }
  for (bool grow_u = true;
       (best.patch_count = count_patches(best)) > patches && best.block_u * best.block_v < 64;
       grow_u = !grow_u) {
    ++(grow_u ? best.block_u : best.block_v);
  }
  return best;
}

}  // namespace fixrad::host
