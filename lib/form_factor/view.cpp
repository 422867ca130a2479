// SPDX-License-Identifier: MIT
#include "lib/form_factor/view.h"

#include "lib/fixed/checked.h"

namespace fixrad {
namespace {

// A face whose plane passes within two grid units of the eye counts as front: seen almost edge-on, rounded
// directions and rounded plane may disagree about its side. Its intervals decide then, a reversed one is
// empty.
constexpr int32_t kEdgeOn = 2 * kEyeScale * kUnit;

constexpr int kDirectionBits = 14;
constexpr int kGridBits = 18;

void make_directions(const Scene& scene, const EyeFrame& frame, Vec3 eye, Direction* directions) {
  for (uint16_t i = 0; i < scene.vertex_count; ++i) {
    const Vec3 v = vec(flash_at(scene.vertices, i));
    const Vec3 offset = {v.x * kEyeScale - eye.x, v.y * kEyeScale - eye.y, v.z * kEyeScale - eye.z};
    const Vec3 d = block_normalise(to_local(frame, offset), kDirectionBits);
    directions[i] = {narrow<int16_t>(d.x, Place::direction), narrow<int16_t>(d.y, Place::direction),
                     narrow<int16_t>(d.z, Place::direction), 0};
  }
}

bool is_below_horizon(const Scene& scene, const Face& face, const Direction* directions) {
  for (int k = 0; k < face.corner_count; ++k) {
    if (directions[corner_vertex(scene, face, k)].z > 0) {
      return false;
    }
  }
  return true;
}

Vec3 relative_to_eye(Vec3 grid_point, Vec3 eye) {
  return {grid_point.x * kEyeScale - eye.x, grid_point.y * kEyeScale - eye.y,
          grid_point.z * kEyeScale - eye.z};
}

void scale_down_together(Vec3 (&v)[3], int bits) {
  uint32_t m = 1;
  for (const Vec3& a : v) {
    m = max_magnitude(a) > m ? max_magnitude(a) : m;
  }
  const int shift = bit_length(m) - bits;
  for (Vec3& a : v) {
    a = scale_down(a, shift);
  }
}

// With o the grid's origin and u, v its axes (all seen from the eye), a direction d meets the plane where
// d t = o + a u + b v, hence a = (o x v) . d / (v x u) . d and b = (u x o) . d / (v x u) . d.
void make_grid(const Face& face, const EyeFrame& frame, Vec3 eye, FaceView& view) {
  const Vec3 u = vec(face.axis_u);
  const Vec3 v = vec(face.axis_v);
  Vec3 g[3] = {relative_to_eye(vec(face.origin), eye),
               {u.x * kEyeScale, u.y * kEyeScale, u.z * kEyeScale},
               {v.x * kEyeScale, v.y * kEyeScale, v.z * kEyeScale}};
  uint32_t m = 0;
  for (const Vec3& a : g) {
    m = max_magnitude(a) > m ? max_magnitude(a) : m;
  }
  const int excess = bit_length(m) - 16;  // |a| < 2^16 keeps to_local below 2^31
  for (Vec3& a : g) {
    a = to_local(frame, excess > 0 ? scale_down(a, excess) : a);
  }
  scale_down_together(g, kDirectionBits);
  Vec3 lines[3] = {cross(g[0], g[2]), cross(g[1], g[0]), cross(g[2], g[1])};
  const uint32_t cells = face.cells_u > face.cells_v ? face.cells_u : face.cells_v;
  scale_down_together(lines, kGridBits - bit_length(cells));
  const int32_t nu = face.cells_u;
  const int32_t nv = face.cells_v;
  view.grid_u = {lines[0].x * nu, lines[0].y * nu, lines[0].z * nu};
  view.grid_v = {lines[1].x * nv, lines[1].y * nv, lines[1].z * nv};
  view.grid_n = lines[2];
}

// Depth comes from the face's own unit normal, not from the grid: the grid's vectors share one scale, in
// which the normal of a small far face keeps few bits. With h the distance and H its top 16 bits, n_i / h =
// (n_i 2^15 / H) 2^-15 2^-(bits - 16): a block of three numbers up to 2^14 and an exponent.
void make_plane(const EyeFrame& frame, Vec3 normal, int32_t height, FaceView& view) {
  const Vec3 n = scale_down(to_local(frame, normal), 14);
  const int32_t distance = view.is_back ? -height : height;
  const uint32_t h = distance > 0 ? static_cast<uint32_t>(distance) : 1;
  const int bits = bit_length(h);
  const uint32_t top = bits > 16 ? h >> (bits - 16) : h << (16 - bits);
  const uint32_t reciprocal = (static_cast<uint32_t>(1) << 31) / top;
  const int32_t factor = static_cast<int32_t>(saturate(reciprocal, Place::depth_reciprocal, 0xffffu));
  const int32_t sign = view.is_back ? factor : -factor;
  view.depth[0] = narrow<int16_t>(floor_shift(n.x * sign, 16), Place::depth_of_plane);
  view.depth[1] = narrow<int16_t>(floor_shift(n.y * sign, 16), Place::depth_of_plane);
  view.depth[2] = narrow<int16_t>(floor_shift(n.z * sign, 16), Place::depth_of_plane);
  view.depth_shift = static_cast<uint8_t>(bits);
}

// How far the eye stands in front of the face's plane, Q14 quarters of a grid unit.
__attribute__((noinline)) int32_t eye_height(const Scene& scene, const Face& face, Vec3 eye) {
  const Vec3 corner = vec(flash_read(scene.vertices, corner_vertex(scene, face, 0)));
  return -dot(vec(face.normal), relative_to_eye(corner, eye));
}

// Not inlined: clang for AVR runs out of registers in the loop over all faces.
__attribute__((noinline)) void see_face(const Face& face, FaceView& view) {
  view.first_corner = face.first_corner;
  view.corner_count = face.corner_count;
  view.first_cell_row = face.first_cell_row;
  view.cells_u = face.cells_u;
  view.cells_v = face.cells_v;
  view.depth_shift = 0;
}

// One loop for both: on small cores it weighs as much as what it does.
__attribute__((noinline)) void complete_views(const Scene& scene, const EyePoint& eye, bool with_depths,
                                              Workspace& work) {
  const EyeFrame frame = eye_frame(flash_at(scene.faces, eye.face), eye.turn);
  for (uint16_t i = 0; i < work.view_count; ++i) {
    FaceView& view = work.views[i];
    const Face& face = flash_at(scene.faces, view.face);
    if (with_depths) {
      make_plane(frame, vec(face.normal), eye_height(scene, face, eye.position), view);
    } else if (!view.is_back && has_grid(scene, view)) {
      make_grid(face, frame, eye.position, view);
    }
  }
}

}  // namespace

void make_view(const Scene& scene, const EyePoint& eye, Backs backs, Workspace& work) {
  const EyeFrame frame = eye_frame(flash_at(scene.faces, eye.face), eye.turn);
  make_directions(scene, frame, eye.position, work.directions);
  work.view_count = 0;
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face& face = flash_at(scene.faces, f);
    const bool is_back = eye_height(scene, face, eye.position) < -kEdgeOn;
    const bool is_left_out =
        is_back && (backs == Backs::none || (backs == Backs::unsealed && face.is_sealed != 0));
    if (f == eye.face || is_left_out || is_below_horizon(scene, face, work.directions)) {
      continue;
    }
    FaceView& view = work.views[work.view_count++];
    view.face = f;
    view.is_back = is_back;
    see_face(face, view);
  }
}

void make_depths(const Scene& scene, const EyePoint& eye, Workspace& work) {
  complete_views(scene, eye, true, work);
}

void make_grids(const Scene& scene, const EyePoint& eye, Workspace& work) {
  complete_views(scene, eye, false, work);
}

}  // namespace fixrad
