// SPDX-License-Identifier: MIT
#include "lib/scene/load.h"

#include "lib/scene/corner.h"

namespace fixrad {
namespace {

bool is_unit(Vec3 n) {
  const int64_t length2 =
      static_cast<int64_t>(n.x) * n.x + static_cast<int64_t>(n.y) * n.y + static_cast<int64_t>(n.z) * n.z;
  const int64_t one = static_cast<int64_t>(kUnit) * kUnit;
  const int64_t slack = 4 * static_cast<int64_t>(kUnit);  // each component is rounded by at most 1/2
  return length2 > one - slack && length2 < one + slack;
}

// Both vectors are rounded by at most 1/2 a component, so their product is off by at most 3/2 (sqrt(3) kUnit)
// or so.
bool is_frame(const Face& face) {
  const int64_t n[3] = {face.normal[0], face.normal[1], face.normal[2]};
  const int64_t off = wide_dot(n, vec(face.tangent));
  const uint32_t longest = max_magnitude(vec(face.axis_u)) > max_magnitude(vec(face.axis_v))
                               ? max_magnitude(vec(face.axis_u))
                               : max_magnitude(vec(face.axis_v));
  const int64_t slack = 4 * static_cast<int64_t>(kUnit);
  return is_unit(vec(face.tangent)) && off < slack && off > -slack && longest <= 2 * kGridMax;
}

Status check_vertices(const Scene& scene) {
  for (uint16_t i = 0; i < scene.vertex_count; ++i) {
    const Vec3 v = vec(flash_read(scene.vertices, i));
    if (v.x < 0 || v.y < 0 || v.z < 0 || v.x > kGridMax || v.y > kGridMax || v.z > kGridMax) {
      return Status::vertex_off_grid;
    }
  }
  return Status::ok;
}

Status check_corners(const Scene& scene, const Face& face) {
  if (face.corner_count < 3 || face.corner_count > kMaxCorners ||
      static_cast<uint32_t>(face.first_corner) + face.corner_count > scene.corner_count ||
      face.material >= scene.material_count) {
    return Status::bad_index;
  }
  for (int k = 0; k < face.corner_count; ++k) {
    const uint16_t v = corner_vertex(scene, face, k);
    if (v >= scene.vertex_count) {
      return Status::bad_index;
    }
    for (int i = 0; i < k; ++i) {
      if (corner_vertex(scene, face, i) == v) {
        return Status::repeated_corner;
      }
    }
  }
  return Status::ok;
}

// A corner may turn the wrong way by what rounding to the grid can do: kPlaneTolerance units across its two
// edges.
Status check_shape(const Scene& scene, const Face& face) {
  const Vec3 n = vec(face.normal);
  if (!is_unit(n)) {
    return Status::not_planar;
  }
  if (!is_frame(face)) {
    return Status::bad_frame;
  }
  const Vec3 first = corner_position(scene, face, 0);
  int64_t area = 0;
  for (int k = 0; k < face.corner_count; ++k) {
    const Vec3 a = corner_position(scene, face, k);
    const Vec3 b = corner_position(scene, face, k + 1) - a;
    const Vec3 c = corner_position(scene, face, k + 2) - corner_position(scene, face, k + 1);
    const int64_t height = wide_dot({a.x - first.x, a.y - first.y, a.z - first.z}, n);
    if (height > kPlaneTolerance * kUnit || height < -kPlaneTolerance * kUnit) {
      return Status::not_planar;
    }
    const int64_t slack = static_cast<int64_t>(kPlaneTolerance) * kUnit *
                          (static_cast<int64_t>(max_magnitude(b)) + max_magnitude(c));
    if (turn_about(b, c, n) < -slack) {
      return Status::not_convex;
    }
    area += turn_about(a - first, b, n);
  }
  return area > 0 ? Status::ok : Status::zero_area;
}

Status check_leaf(const Scene& scene, uint32_t element, uint16_t face) {
  if (element >= scene.element_count) {
    return Status::bad_index;
  }
  return flash_read(scene.elements, static_cast<unsigned>(element)).face == face ? Status::ok
                                                                                 : Status::bad_grid;
}

Status check_side(const Scene& scene, uint16_t side, uint16_t face) {
  if (side >= kLeaf) {
    return check_leaf(scene, side - static_cast<uint32_t>(kLeaf), face);
  }
  return side < scene.cut_count ? Status::ok : Status::bad_index;
}

bool has_wide_numbers(const Cut& cut) {
  constexpr int16_t kMostSlope = 1 << kCutBits, kMostOffset = (1 << (kCutBits + 2)) - 1;
  return cut.a < -kMostSlope || cut.a > kMostSlope || cut.b < -kMostSlope || cut.b > kMostSlope ||
         cut.c < -kMostOffset || cut.c > kMostOffset;
}

// Goes down a tree of cuts, each side in turn, without a stack: the way to a leaf is a number whose bits say
// left or right, and the next way is that number plus one. A tree too deep may also be one without end.
Status check_tree(const Scene& scene, uint16_t root, uint16_t face) {
  constexpr uint16_t kAll = 1u << kMostCuts;
  for (uint16_t way = 0; way < kAll;) {
    uint16_t side = root;
    uint16_t bit = kAll;
    for (;;) {
      const Status status = check_side(scene, side, face);
      if (status != Status::ok || side >= kLeaf) {
        if (status != Status::ok) {
          return status;
        }
        break;
      }
      if (bit == 1) {
        return Status::bad_grid;
      }
      bit = static_cast<uint16_t>(bit >> 1);
      const Cut cut = flash_read(scene.cuts, side);
      if (has_wide_numbers(cut)) {
        return Status::bad_grid;
      }
      side = (way & bit) != 0 ? cut.right : cut.left;
    }
    way = static_cast<uint16_t>(way + bit);  // carries over to the next side that has not been seen
  }
  return Status::ok;
}

Status check_cell(const Scene& scene, uint32_t cell, uint16_t face) {
  if (scene.roots == nullptr) {
    return check_leaf(scene, cell, face);
  }
  return cell < scene.root_count
             ? check_tree(scene, flash_read(scene.roots, static_cast<unsigned>(cell)), face)
             : Status::bad_index;
}

Status check_grid(const Scene& scene, const Face& face, uint16_t index) {
  if (face.cells_u < 1 || face.cells_v < 1 || face.cells_u > 127 || face.cells_v > 127 ||
      turn_about(vec(face.axis_u), vec(face.axis_v), vec(face.normal)) <= 0) {
    return Status::bad_grid;
  }
  if (static_cast<uint32_t>(face.first_cell_row) + face.cells_v > scene.cell_row_count) {
    return Status::bad_index;
  }
  for (unsigned v = 0; v < face.cells_v; ++v) {
    const CellRow row = flash_read(scene.cell_rows, face.first_cell_row + v);
    if (row.first_cell > row.last_cell || row.last_cell >= face.cells_u) {
      return Status::bad_grid;
    }
    const uint32_t last = static_cast<uint32_t>(row.first_element) + row.last_cell - row.first_cell;
    for (uint32_t cell = row.first_element; cell <= last; ++cell) {
      const Status status = check_cell(scene, cell, index);
      if (status != Status::ok) {
        return status;
      }
    }
  }
  return Status::ok;
}

Status check_eye(const Scene& scene, const uint16_t (&eye)[3], uint16_t face_index) {
  const Face face = flash_read(scene.faces, face_index);
  const Vec3 corner = corner_position(scene, face, 0);
  const Vec3 p = vec(eye);
  const int64_t offset[3] = {p.x - kEyeScale * corner.x, p.y - kEyeScale * corner.y,
                             p.z - kEyeScale * corner.z};
  const int64_t height = wide_dot(offset, vec(face.normal));
  const int64_t highest = static_cast<int64_t>(kPlaneTolerance + 2) * kEyeScale * kUnit;
  return height > 0 && height < highest ? Status::ok : Status::bad_eye;
}

Status check_element(const Scene& scene, uint16_t index) {
  const Element element = flash_read(scene.elements, index);
  if (element.face >= scene.face_count || element.patch >= scene.patch_count ||
      flash_read(scene.patches, element.patch).face != element.face ||
      flash_read(scene.faces, element.face).material != element.material ||
      (index > 0 && flash_read(scene.elements, index - 1u).face > element.face)) {
    return Status::bad_index;
  }
  return element.area == 0 ? Status::zero_area : check_eye(scene, element.eye, element.face);
}

Status check_patch(const Scene& scene, uint16_t index, uint32_t& elements_before) {
  const Patch patch = flash_read(scene.patches, index);
  if (patch.face >= scene.face_count || patch.first_element != elements_before || patch.element_count == 0 ||
      patch.element_count > kMaxPatchElements ||
      elements_before + patch.element_count > scene.element_count) {
    return Status::bad_index;
  }
  for (unsigned i = 0; i < patch.element_count; ++i) {
    const uint16_t e = flash_read(scene.patch_elements, patch.first_element + i);
    if (e >= scene.element_count || flash_read(scene.elements, e).patch != index) {
      return Status::bad_index;
    }
  }
  elements_before += patch.element_count;
  return Status::ok;
}

// Everything received by one element is at most all that is ever sent, emitted / (1 - reflectance);
// overshooting may double it for a while. Hence emitted < 2^30 (1 - reflectance).
Status check_light(const Scene& scene, int channel, bool& emits) {
  uint32_t highest = 0;
  uint64_t emitted = 0;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const Element element = flash_read(scene.elements, e);
    const Material material = flash_read(scene.materials, element.material);
    const uint64_t flux =
        (static_cast<uint64_t>(material.emission[channel]) * element.area) >> scene.emission_shift;
    if (flux >= (1ul << 30)) {
      return Status::flux_overflow;
    }
    emitted += flux;
    highest = material.reflectance[channel] > highest ? material.reflectance[channel] : highest;
  }
  const uint64_t headroom = ((static_cast<uint64_t>(1) << 32) - highest) >> 2;
  emits = emits || emitted > 0;
  return emitted < headroom
             ? Status::ok
             : (highest == 0xffffffffu ? Status::reflectance_not_below_one : Status::flux_overflow);
}

Status check_counts(const Scene& scene, const Capacity& capacity) {
  if ((scene.channels != 1 && scene.channels != kMaxChannels) || scene.channels > capacity.channels) {
    return Status::bad_channel_count;
  }
  if (scene.vertex_count > capacity.vertices) {
    return Status::too_many_vertices;
  }
  if (scene.face_count > capacity.faces) {
    return Status::too_many_faces;
  }
  if (scene.element_count > capacity.elements || (scene.roots != nullptr && scene.element_count > kLeaf)) {
    return Status::too_many_elements;
  }
  return scene.emission_shift <= 63 && scene.radiosity_shift <= 32 ? Status::ok : Status::bad_unit;
}

Status check_faces(const Scene& scene) {
  for (uint16_t f = 0; f < scene.face_count; ++f) {
    const Face face = flash_read(scene.faces, f);
    Status status = check_corners(scene, face);
    status = status == Status::ok ? check_shape(scene, face) : status;
    status = status == Status::ok ? check_grid(scene, face, f) : status;
    if (status != Status::ok) {
      return status;
    }
  }
  return Status::ok;
}

Status check_elements(const Scene& scene) {
  uint32_t elements_before = 0;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const Status status = check_element(scene, e);
    if (status != Status::ok) {
      return status;
    }
  }
  for (uint16_t p = 0; p < scene.patch_count; ++p) {
    const Status status = check_patch(scene, p, elements_before);
    if (status != Status::ok) {
      return status;
    }
  }
  return elements_before == scene.element_count ? Status::ok : Status::bad_index;
}

}  // namespace

Status check_scene(const Scene& scene, const Capacity& capacity) {
  Status status = check_counts(scene, capacity);
  status = status == Status::ok ? check_vertices(scene) : status;
  status = status == Status::ok ? check_faces(scene) : status;
  status = status == Status::ok ? check_elements(scene) : status;
  bool emits = false;
  for (int c = 0; c < scene.channels && status == Status::ok; ++c) {
    status = check_light(scene, c, emits);
  }
  return status == Status::ok && !emits ? Status::no_emitter : status;
}

}  // namespace fixrad
