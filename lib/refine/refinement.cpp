// SPDX-License-Identifier: MIT
#include "lib/refine/refinement.h"

#include "lib/form_factor/cell_polygon.h"
#include "lib/transport/unshot.h"

#if !defined(__AVR__)

namespace fixrad {
namespace {

// Of an error the lowest bit says which axis is to be cut: 1 along u.
constexpr uint32_t kCutsU = 1;

// Errors keep the upper 32 bits of radiosity/4 x area after this shift.
constexpr int kErrorShift = 20;

// Samples lie 5/8 of the way from the centroid to a corner.
constexpr int32_t kWay = 5, kWholeWay = 8;

// In the coordinates of a cell: Q16.
constexpr int32_t kLeastWidth = (1 << 16) / 16;

constexpr int32_t kTooLong = 3;

bool emits(const Scene& scene, const Element& element) {
  const Material& material = flash_at(scene.materials, element.material);
  bool any = false;
  for (int c = 0; c < scene.channels; ++c) {
    any = any || material.emission[c] != 0;
  }
  return any;
}

// A point of a face (1/64 grid unit) as an eye: lifted until it stands over the plane of the first corner, as
// load() asks.
Vec3 lifted(const Scene& scene, const Face& face, const Vec3& point) {
  const Vec3 corner = vec(flash_read(scene.vertices, corner_vertex(scene, face, 0)));
  const Vec3 normal = vec(face.normal);
  const Vec3 at = scale_down(point, kFineLog2 - 2);  // quarters
  Vec3 eye = at;
  for (int32_t lift = 2; lift < 40; ++lift) {
    eye = {at.x + rounded_shift(lift * normal.x, 14), at.y + rounded_shift(lift * normal.y, 14),
           at.z + rounded_shift(lift * normal.z, 14)};
    eye = {eye.x < 0 ? 0 : eye.x, eye.y < 0 ? 0 : eye.y, eye.z < 0 ? 0 : eye.z};
    const int64_t height = static_cast<int64_t>(eye.x - kEyeScale * corner.x) * normal.x +
                           static_cast<int64_t>(eye.y - kEyeScale * corner.y) * normal.y +
                           static_cast<int64_t>(eye.z - kEyeScale * corner.z) * normal.z;
    if (height > 0) {
      break;
    }
  }
  return eye;
}

// Looks at irradiance from points of one element.
class ElementLight {
 public:
  ElementLight(State& state, const DeltaTable& table, uint16_t e)
      : state_(state), table_(table), element_(flash_read(state.scene.elements, e)) {
    for (int c = 0; c < state.scene.channels; ++c) {
      ambient_[c] = ambient_radiosity(state, c);
    }
    face_ = flash_read(state.scene.faces, element_.face);
  }

  const Face& face() const { return face_; }
  const Element& element() const { return element_; }

  Status look(const Vec3& point, Irradiance& irradiance) {
    const EyePoint eye = {lifted(state_.scene, face_, point), element_.face, 0};
    return gather_irradiance(state_, table_, nullptr, eye, false, ambient_, irradiance);
  }

  /// What is reflected, summed over the channels; a quarter of the radiosity unit.
  uint32_t reflected(const Irradiance& irradiance) const {
    const Material& material = flash_at(state_.scene.materials, element_.material);
    uint32_t sum = 0;
    for (int c = 0; c < state_.scene.channels; ++c) {
      sum += mul_high(material.reflectance[c], irradiance.of[c].raw) / 4;
    }
    return sum;
  }

 private:
  State& state_;
  const DeltaTable& table_;
  Element element_;
  Face face_ = {};
  Radiosity ambient_[kMaxChannels] = {};
};

struct Extents {
  int32_t u, v;  // of a polygon in its cell, Q16
  bool is_long_u, is_long_v;
};

// An element's polygon takes 250 bytes of stack, so no function keeps one while it looks.
struct Shape {
  Vec3 centroid;
  int corners;
  Extents extents;
};

Extents extents_of(const Face& face, const ElementCells& cells, const Polygon& polygon) {
  CellPoint low = cell_point(face, cells, polygon.corner[0]), high = low;
  for (int k = 1; k < polygon.count; ++k) {
    const CellPoint p = cell_point(face, cells, polygon.corner[k]);
    low = {p.u < low.u ? p.u : low.u, p.v < low.v ? p.v : low.v};
    high = {p.u > high.u ? p.u : high.u, p.v > high.v ? p.v : high.v};
  }
  const int64_t u = high.u - low.u, v = high.v - low.v;
  const int64_t length_u = u * max_magnitude(vec(face.axis_u)) / face.cells_u;
  const int64_t length_v = v * max_magnitude(vec(face.axis_v)) / face.cells_v;
  return {static_cast<int32_t>(u), static_cast<int32_t>(v), length_u > kTooLong * length_v,
          length_v > kTooLong * length_u};
}

__attribute__((noinline)) Shape shape_of(const Scene& scene, const Face& face, const ElementCells& cells) {
  Polygon polygon;
  element_polygon(scene, face, cells, polygon);
  return {moments_of(face, polygon).centroid, polygon.count, extents_of(face, cells, polygon)};
}

// A sample between the centroid and corner `k`.
__attribute__((noinline)) Vec3 sample_point(const Scene& scene, const Face& face, const ElementCells& cells,
                                            const Vec3& centroid, int k) {
  Polygon polygon;
  element_polygon(scene, face, cells, polygon);
  const Vec3 way = polygon.corner[k] - centroid;
  return {centroid.x + way.x * kWay / kWholeWay, centroid.y + way.y * kWay / kWholeWay,
          centroid.z + way.z * kWay / kWholeWay};
}

__attribute__((noinline)) PolygonMoments part_of_element(const Scene& scene, const Face& face,
                                                         const ElementCells& cells, const Cut& cut,
                                                         bool is_right) {
  Polygon polygon;
  element_polygon(scene, face, cells, polygon);
  cut_polygon(face, cells, cut, is_right, polygon);
  return moments_of(face, polygon);
}

// The change of light along one axis, from samples on both sides of the centroid.
int64_t signed_by(int32_t offset, int64_t change) {
  return offset > 0 ? change : (offset < 0 ? -change : 0);
}

FIXRAD_MODULO uint64_t size_of(int64_t a) {
  return a < 0 ? 0u - static_cast<uint64_t>(a) : static_cast<uint64_t>(a);
}

Status estimate(State& state, RefinedScene& tables, const DeltaTable& table, uint16_t e) {
  ElementLight light(state, table, e);
  tables.errors[e] = 0;
  if (emits(state.scene, light.element())) {
    return Status::ok;
  }
  const Face& face = light.face();
  const ElementCells cells = cells_of(state.scene, face, e);
  const Shape shape = shape_of(state.scene, face, cells);
  const CellPoint centre = cell_point(face, cells, shape.centroid);
  Irradiance irradiance;
  Status status = light.look(shape.centroid, irradiance);
  const uint32_t at_middle = light.reflected(irradiance);
  uint32_t low = at_middle, high = at_middle;
  int64_t change_u = 0, change_v = 0;
  for (int k = 0; k < shape.corners && status == Status::ok; ++k) {
    const Vec3 point = sample_point(state.scene, face, cells, shape.centroid, k);
    status = light.look(point, irradiance);
    const uint32_t there = light.reflected(irradiance);
    low = there < low ? there : low;
    high = there > high ? there : high;
    const CellPoint at = cell_point(face, cells, point);
    const int64_t change = static_cast<int64_t>(there) - at_middle;
    change_u += signed_by(at.u - centre.u, change);
    change_v += signed_by(at.v - centre.v, change);
  }
  if (status != Status::ok) {
    return status;
  }
  const Extents& size = shape.extents;
  const bool cuts_u = size.is_long_u || (!size.is_long_v && size_of(change_u) >= size_of(change_v));
  const uint64_t error = wide_product(high - low, light.element().area) >> kErrorShift;
  const uint32_t kept = saturate(error, Place::error_of_element);
  const bool is_wide = (cuts_u ? size.u : size.v) >= 2 * kLeastWidth;
  tables.errors[e] = is_wide && cells.cuts < kMostCuts ? (kept & ~kCutsU) | (cuts_u ? kCutsU : 0u) : 0u;
  return Status::ok;
}

void store(uint16_t (&eye)[3], const Vec3& p) {
  eye[0] = narrow<uint16_t>(p.x, Place::eye_of_part);
  eye[1] = narrow<uint16_t>(p.y, Place::eye_of_part);
  eye[2] = narrow<uint16_t>(p.z, Place::eye_of_part);
}

// The parts of an element that is to be cut, and the light at their centroids.
struct Parts {
  Split split;
  uint32_t weight[2][kMaxChannels];
  bool is_usable;
};

Status plan_parts(State& state, const DeltaTable& table, uint16_t e, bool cuts_u, Parts& parts) {
  ElementLight light(state, table, e);
  const Face& face = light.face();
  const ElementCells cells = cells_of(state.scene, face, e);
  const CellPoint centre = cell_point(face, cells, shape_of(state.scene, face, cells).centroid);
  const int16_t offset =
      narrow<int16_t>(-floor_shift(cuts_u ? centre.u : centre.v, 16 - kCutBits), Place::offset_of_cut);
  const int16_t one = 1 << kCutBits, none = 0;
  parts.split.parent = e;
  parts.split.cut = {cuts_u ? one : none, cuts_u ? none : one, offset, 0, 0};
  const PolygonMoments moments[2] = {part_of_element(state.scene, face, cells, parts.split.cut, false),
                                     part_of_element(state.scene, face, cells, parts.split.cut, true)};
  const uint64_t sum = moments[0].area + moments[1].area;
  const int shift = bit_length(static_cast<uint32_t>(sum >> 32));
  const uint32_t all = static_cast<uint32_t>(sum >> shift);
  const uint32_t area = light.element().area;
  const uint32_t left_part = static_cast<uint32_t>(moments[0].area >> shift);
  parts.split.left_area = all == 0 ? 0 : static_cast<uint32_t>(wide_product(area, left_part) / all);
  parts.split.right_area = area - parts.split.left_area;
  parts.is_usable = parts.split.left_area > 0 && parts.split.right_area > 0;
  const uint32_t areas[2] = {parts.split.left_area, parts.split.right_area};
  for (int i = 0; i < 2; ++i) {
    Irradiance irradiance;
    const Status status = light.look(moments[i].centroid, irradiance);
    if (status != Status::ok) {
      return status;
    }
    for (int c = 0; c < kMaxChannels; ++c) {
      parts.weight[i][c] = mul_high(irradiance.of[c].raw, areas[i]);
    }
  }
  store(parts.split.left_eye, lifted(state.scene, face, moments[0].centroid));
  store(parts.split.right_eye, lifted(state.scene, face, moments[1].centroid));
  return Status::ok;
}

uint64_t absorbing_area(const State& state, uint16_t e, int c) {
  const Element& element = flash_at(state.scene.elements, e);
  const Material& material = flash_at(state.scene.materials, element.material);
  return element.area - mul_high(material.reflectance[c], element.area);
}

void apply(State& state, RefinedScene& tables, const Parts& parts) {
  const uint16_t parent = parts.split.parent;
  const uint16_t child = static_cast<uint16_t>(parent + 1);
  for (int c = 0; c < state.scene.channels; ++c) {
    state.absorbing_area[c] -= absorbing_area(state, parent, c);
  }
  enter_split(state.scene, tables, parts.split);
  for (int c = 0; c < state.scene.channels; ++c) {
    state.absorbing_area[c] += absorbing_area(state, parent, c) + absorbing_area(state, child, c);
  }
  share_flux(state, parent, parts.weight[0], parts.weight[1]);
  state.row.count = state.scene.element_count;
  clear(state.row);
  state.next_emitter = static_cast<uint16_t>(state.next_emitter + (state.next_emitter > parent ? 1 : 0));
  if (state.sweep.kind == SourceKind::element && state.sweep.cursor > parent) {
    ++state.sweep.cursor;
  }
}

}  // namespace

Status start_refining(State& state, RefinedScene& tables, const DeltaTable& table) {
  for (uint16_t e = 0; e < state.scene.element_count; ++e) {
    const Status status = estimate(state, tables, table, e);
    if (status != Status::ok) {
      return status;
    }
  }
  return Status::ok;
}

Status split_worst(State& state, RefinedScene& tables, const DeltaTable& table) {
  for (;;) {
    uint16_t worst = 0;
    for (uint16_t e = 1; e < state.scene.element_count; ++e) {
      worst = tables.errors[e] / 2 > tables.errors[worst] / 2 ? e : worst;
    }
    const uint32_t error = tables.errors[worst];
    if (error / 2 == 0 || state.sweep.kind == SourceKind::face) {
      return Status::converged;
    }
    if (!has_room(state.scene, tables, worst)) {
      return Status::too_many_elements;
    }
    Parts parts;
    const Status status = plan_parts(state, table, worst, (error & kCutsU) != 0, parts);
    if (status != Status::ok) {
      return status;
    }
    if (!parts.is_usable) {
      tables.errors[worst] = 0;
      continue;
    }
    apply(state, tables, parts);
    const Status first = estimate(state, tables, table, worst);
    return first != Status::ok ? first : estimate(state, tables, table, static_cast<uint16_t>(worst + 1));
  }
}

}  // namespace fixrad

#endif
