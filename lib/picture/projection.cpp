// SPDX-License-Identifier: MIT
#include "lib/picture/projection.h"

namespace fixrad {
namespace {

// Beyond this many picture widths from the middle triangles are cut off; wide enough that few ever are.
constexpr uint32_t kGuardWidths = 1;
constexpr int kGuardFraction = 12;

uint32_t guard_tangent(uint16_t side, uint32_t focal) {
  const uint64_t pixels = static_cast<uint64_t>(kGuardWidths) * side + 1u;
  const uint64_t tangent = (pixels << (kPixelBits + kGuardFraction)) / focal + 1u;
  return tangent > 0xffffffu ? 0xffffffu : static_cast<uint32_t>(tangent);
}

// a . n / 2^27, rounded, times n: twice the part of `a` along the unit vector n in Q14.
Vec3 less_twice(Vec3 a, int64_t along, Vec3 n) {
  const int64_t half = static_cast<int64_t>(1) << 26;
  return {a.x - static_cast<int32_t>((along * n.x + half) >> 27),
          a.y - static_cast<int32_t>((along * n.y + half) >> 27),
          a.z - static_cast<int32_t>((along * n.z + half) >> 27)};
}

Vec3 mirrored_axis(Vec3 axis, Vec3 normal) {
  return less_twice(axis, dot(axis, normal), normal);
}

bool in_camera_range(int32_t coordinate) {
  return coordinate >= kCameraLow && coordinate <= kCameraHigh;
}

int64_t height(Vec3 normal, Vec3 point, int32_t offset) {
  return static_cast<int64_t>(dot(normal, point)) - offset;
}

// The picture coordinate of tangent u / z, with `inverse` of z: UQ.8 pixels from the middle.
int32_t pixels(int32_t u, uint32_t inverse, uint32_t focal) {
  constexpr int kTangentBits = 20;
  const int64_t tangent = (static_cast<int64_t>(u) * inverse) >> (kInverseBits - kTangentBits);
  const int64_t half = static_cast<int64_t>(1) << (kTangentBits - 1);
  return static_cast<int32_t>((tangent * static_cast<int64_t>(focal) + half) >> kTangentBits);
}

}  // namespace

__attribute__((noinline)) Projection projection_of(const PictureCamera& camera) {
  Projection p;
  p.eye = {camera.eye[0], camera.eye[1], camera.eye[2]};
  p.right = vec(camera.right);
  p.up = vec(camera.up);
  p.forward = vec(camera.forward);
  p.focal = camera.focal;
  p.width = camera.width;
  p.height = camera.height;
  p.guard_x = guard_tangent(camera.width, camera.focal);
  p.guard_y = guard_tangent(camera.height, camera.focal);
  p.is_mirrored = false;
  return p;
}

__attribute__((noinline)) bool mirrored(const Projection& camera, const PictureMirror& mirror,
                                        Projection& result) {
  const Vec3 n = vec(mirror.normal);
  result = camera;
  result.is_mirrored = !camera.is_mirrored;
  result.eye = less_twice(camera.eye, height(n, camera.eye, mirror.offset), n);
  result.right = mirrored_axis(camera.right, n);
  result.up = mirrored_axis(camera.up, n);
  result.forward = mirrored_axis(camera.forward, n);
  return in_camera_range(result.eye.x) && in_camera_range(result.eye.y) && in_camera_range(result.eye.z);
}

int32_t height_over(const PictureMirror& mirror, Vec3 point) {
  return static_cast<int32_t>(height(vec(mirror.normal), point, mirror.offset));
}

Vec3 to_view(const Projection& projection, Vec3 vertex) {
  const Vec3 d = vertex - projection.eye;
  return {rounded_shift(dot(projection.right, d), 14 - kViewBits),
          rounded_shift(dot(projection.up, d), 14 - kViewBits),
          rounded_shift(dot(projection.forward, d), 14 - kViewBits)};
}

Vec3 to_grid(const Projection& projection, Vec3 view) {
  const Vec3 v = scale_down(view, kViewBits);
  const auto along = [&](int32_t right, int32_t up, int32_t forward) {
    return rounded_shift(right * v.x + up * v.y + forward * v.z, 14);
  };
  const Projection& p = projection;
  return {p.eye.x + along(p.right.x, p.up.x, p.forward.x), p.eye.y + along(p.right.y, p.up.y, p.forward.y),
          p.eye.z + along(p.right.z, p.up.z, p.forward.z)};
}

ScreenCorner to_screen(const Projection& projection, Vec3 view) {
  const uint32_t inverse =
      static_cast<uint32_t>((static_cast<uint64_t>(1) << kInverseBits) / static_cast<uint32_t>(view.z));
  const int32_t middle_x = static_cast<int32_t>(projection.width) << (kPixelBits - 1);
  const int32_t middle_y = static_cast<int32_t>(projection.height) << (kPixelBits - 1);
  return {middle_x + pixels(view.x, inverse, projection.focal),
          middle_y - pixels(view.y, inverse, projection.focal), inverse};
}

}  // namespace fixrad
