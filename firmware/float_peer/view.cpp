// SPDX-License-Identifier: MIT
#include "firmware/float_peer/view.h"

namespace fixrad {
namespace peer {
namespace {

// As in the core: a face whose plane passes within two grid units of the eye counts as front.
constexpr float kEdgeOn = 2.0f * kEyeScale * kUnit;
constexpr float kSmallestDistance = 1.0f;  // of a plane, Q14 times a quarter of a unit

struct Frame {
  Vector x, y, z;

  Vector to_local(Vector v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

struct Turn {
  float cosine, sine;
};

// The core's sequence: angle i is frac((i + 1/2) * 0.6180339887) * 180 degrees.
constexpr FIXRAD_IN_FLASH Turn kTurnTable[kTurns] = {
    {0.564634886f, 0.825340805f},  {-0.973853896f, 0.227175238f}, {-0.141165510f, 0.989986009f},
    {0.871544224f, 0.490316904f},  {-0.772816995f, 0.634628941f}, {0.311445277f, 0.950264089f},
    {0.998536890f, 0.054074748f},  {-0.412244115f, 0.911073427f}, {0.699763059f, 0.714375014f},
    {-0.919397238f, 0.393330293f}, {0.033430113f, 0.999441058f},  {0.943625705f, 0.331014394f},
    {-0.650462409f, 0.759538449f}, {0.472203218f, 0.881489717f},  {-0.992691587f, 0.120678970f},
    {-0.247249791f, 0.968951774f}};

Frame make_frame(const Face& face, uint8_t turn) {
  constexpr float kOneth = 1.0f / kUnit;
  const Turn t = flash_read(kTurnTable, turn % kTurns);
  const Vector z = scale(to_float(vec(face.normal)), kOneth);
  const Vector x = scale(to_float(vec(face.tangent)), kOneth);
  const Vector y = cross(z, x);
  return {add(scale(x, t.cosine), scale(y, t.sine)), add(scale(y, t.cosine), scale(x, -t.sine)), z};
}

uint16_t face_corner(const Scene& scene, const Face& face, uint8_t k) {
  return flash_read(scene.corners, static_cast<unsigned>(face.first_corner) + k);
}

Vec3 from_eye(Vec3 grid_point, Vec3 eye) {
  return {grid_point.x * kEyeScale - eye.x, grid_point.y * kEyeScale - eye.y,
          grid_point.z * kEyeScale - eye.z};
}

void place_vertices(const Scene& scene, const Frame& frame, Vec3 eye, VertexView* vertices) {
  for (uint16_t i = 0; i < scene.vertex_count; ++i) {
    VertexView& v = vertices[i];
    const Vector offset = frame.to_local(to_float(from_eye(vec(flash_read(scene.vertices, i)), eye)));
    v.x = offset.x;
    v.y = offset.y;
    v.z = offset.z;
    v.over_horizon = offset.z > 0.0f;
  }
}

bool is_below_horizon(const Scene& scene, const Face& face, const VertexView* vertices) {
  for (uint8_t k = 0; k < face.corner_count; ++k) {
    if (vertices[face_corner(scene, face, k)].over_horizon) {
      return false;
    }
  }
  return true;
}

// A direction d meets the plane where d t = o + a u + b v (o: the grid's origin seen from the eye; u, v: its
// axes), hence a = (o x v) . d / (v x u) . d. As v x u = -area n, division of both by area times height makes
// the denominator -n . d / height, which is 1/depth: one linear function less to carry.
void make_grid(const Face& face, const Frame& frame, Vec3 eye, float inverse_height, FaceView& view) {
  const Vector o = to_float(from_eye(vec(face.origin), eye));
  const float cells_u = static_cast<float>(face.cells_u);
  const float cells_v = static_cast<float>(face.cells_v);
  const float cell_area = static_cast<float>(face.cell_area) * (1.0f / 8);  // square grid units
  // o is in quarters of a unit, the axes in units; the height is in Q14 times a quarter of a unit.
  const float s = inverse_height * (static_cast<float>(kUnit) / kEyeScale) / (cell_area * cells_u * cells_v);
  if (view.has_u()) {
    view.u = frame.to_local(scale(cross(o, to_float(vec(face.axis_v))), s * cells_u));
  }
  if (view.has_v()) {
    view.v = frame.to_local(scale(cross(to_float(vec(face.axis_u)), o), s * cells_v));
  }
}

}  // namespace

void make_view(const Scene& scene, const EyePoint& eye, Backs backs, bool grids, Workspace& work) {
  const Frame frame = make_frame(flash_read(scene.faces, eye.face), eye.turn);
  place_vertices(scene, frame, eye.position, work.vertices);
  work.view_count = 0;
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    if (f == eye.face || is_below_horizon(scene, face, work.vertices)) {
      continue;
    }
    const Vector normal = to_float(vec(face.normal));  // Q14
    const Vec3 corner = vec(flash_read(scene.vertices, face_corner(scene, face, 0)));
    const float height = -dot(normal, to_float(from_eye(corner, eye.position)));
    const bool is_back = height < -kEdgeOn;
    if (is_back && (backs == Backs::none || (backs == Backs::unsealed && face.is_sealed != 0))) {
      continue;
    }
    FaceView& view = work.views[work.view_count++];
    view.first_corner = face.first_corner;
    view.corner_count = face.corner_count;
    view.first_cell_row = face.first_cell_row;
    view.is_back = is_back;
    view.cells_u = is_back || !grids ? static_cast<uint8_t>(1) : face.cells_u;
    view.cells_v = is_back || !grids ? static_cast<uint8_t>(1) : face.cells_v;
    const float inverse_height = 1.0f / (is_back || height > kSmallestDistance ? height : kSmallestDistance);
    view.depth = frame.to_local(scale(normal, -inverse_height));
    if (view.has_u() || view.has_v()) {
      make_grid(face, frame, eye.position, inverse_height, view);
    }
  }
}

}  // namespace peer
}  // namespace fixrad
