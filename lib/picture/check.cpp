// SPDX-License-Identifier: MIT
#include "lib/picture/draw.h"

namespace fixrad {
namespace {

bool is_in_range(const PictureCamera& camera) {
  for (const int32_t coordinate : camera.eye) {
    if (coordinate < kCameraLow || coordinate > kCameraHigh) {
      return false;
    }
  }
  return camera.focal > 0 && camera.focal < kMaxFocal && camera.width > 0 && camera.height > 0 &&
         camera.width <= kMaxPictureSide && camera.height <= kMaxPictureSide;
}

bool has_good_triangles(const PictureScene& scene) {
  for (uint16_t i = 0; i < scene.triangle_count; ++i) {
    const PictureTriangle t = flash_read(scene.triangles, i);
    const bool corners = t.corner[0] < scene.vertex_count && t.corner[1] < scene.vertex_count &&
                         t.corner[2] < scene.vertex_count;
    if (!corners || t.material >= scene.material_count ||
        (t.mirror != kNoMirror && t.mirror >= scene.mirror_count)) {
      return false;
    }
  }
  return true;
}

bool has_good_side_points(const PictureScene& scene) {
  if (scene.side_point_count > scene.vertex_count) {
    return false;
  }
  const uint16_t lit = static_cast<uint16_t>(scene.vertex_count - scene.side_point_count);
  for (uint16_t i = 0; i < scene.side_point_count; ++i) {
    const SidePoint p = flash_read(scene.side_points, i);
    if (p.from >= lit || p.to >= lit) {
      return false;
    }
  }
  return true;
}

bool has_good_materials(const PictureScene& scene) {
  for (uint8_t i = 0; i < scene.material_count; ++i) {
    if (flash_read(scene.materials, i).exponent != 0 && scene.normals == nullptr) {
      return false;
    }
  }
  for (uint8_t i = 0; i < scene.mirror_count; ++i) {
    if (flash_read(scene.mirrors, i).material >= scene.material_count) {
      return false;
    }
  }
  return true;
}

}  // namespace

__attribute__((noinline)) PictureStatus check_picture(const PictureScene& scene, const PictureCamera& camera,
                                                      const PictureBand& band) {
  if (scene.channels != 1 && scene.channels != kMaxChannels) {
    return PictureStatus::bad_channel_count;
  }
  if (!has_good_triangles(scene) || !has_good_side_points(scene) || !has_good_materials(scene)) {
    return PictureStatus::bad_index;
  }
  if (!is_in_range(camera)) {
    return PictureStatus::bad_camera;
  }
  return band.rows == 0 ? PictureStatus::no_memory : PictureStatus::ok;
}

}  // namespace fixrad
