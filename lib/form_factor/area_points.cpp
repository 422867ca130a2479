// SPDX-License-Identifier: MIT
#include "lib/form_factor/area_points.h"

#include "lib/form_factor/arc.h"

namespace fixrad {
namespace {

// Direction numbers of the first three dimensions, five binary digits (Bratley & Fox 1988, Algorithm 659).
constexpr FIXRAD_IN_FLASH uint8_t kSobol[3 * kMaxRaysLog2] = {16, 8,  4,  2,  1,   //
                                                              16, 24, 20, 30, 17,  //
                                                              16, 8,  28, 22, 13};

constexpr int kFanBits = 14;

uint16_t sobol(int i, unsigned dimension) {
  unsigned digits = 0;
  for (unsigned bit = 0; bit < static_cast<unsigned>(kMaxRaysLog2); ++bit) {
    digits ^= (static_cast<unsigned>(i) >> bit & 1u) != 0
                  ? flash_read(kSobol, dimension * static_cast<unsigned>(kMaxRaysLog2) + bit)
                  : 0u;
  }
  return static_cast<uint16_t>(digits << (16 - kMaxRaysLog2));
}

// Every bit of the result depends on every bit of `a` (Wellons 2018, "Prospecting for hash functions").
FIXRAD_MODULO uint32_t mixed(uint32_t a) {
  a ^= a >> 16;
  a *= 0x7feb352dul;
  a ^= a >> 15;
  a *= 0x846ca68bul;
  return a ^ a >> 16;
}

int32_t along_side(int32_t a, int32_t b, int32_t part) {
  return static_cast<int32_t>((static_cast<int64_t>(b - a) * part) >> 16);
}

// corner + s (one - corner) + t (other - corner).
Vec3 affine_point(const Vec3& corner, const Vec3& one, const Vec3& other, int32_t s, int32_t t) {
  return {corner.x + along_side(corner.x, one.x, s) + along_side(corner.x, other.x, t),
          corner.y + along_side(corner.y, one.y, s) + along_side(corner.y, other.y, t),
          corner.z + along_side(corner.z, one.z, s) + along_side(corner.z, other.z, t)};
}

int fan_shift(const Polygon& polygon) {
  uint32_t m = 0;
  for (int k = 1; k < polygon.count; ++k) {
    const uint32_t reach = max_magnitude(polygon.corner[k] - polygon.corner[0]);
    m = reach > m ? reach : m;
  }
  return bit_length(m) - kFanBits;
}

// The largest component of a cross product; in a plane it is proportional to the area. Below 2^29.
uint32_t triangle_measure(const Polygon& polygon, int k, int shift) {
  const Vec3& o = polygon.corner[0];
  return max_magnitude(
      cross(scale_down(polygon.corner[k + 1] - o, shift), scale_down(polygon.corner[k + 2] - o, shift)));
}

bool closes(const Polygon& p) {
  if (p.count != 4) {
    return false;
  }
  const Vec3 a = p.corner[1] - p.corner[0], b = p.corner[2] - p.corner[3];
  return max_magnitude(a - b) <= 2 * static_cast<uint32_t>(kFineScale);
}

}  // namespace

FIXRAD_MODULO RayCoordinates ray_coordinates(int i, int log2, uint32_t pair) {
  const uint32_t first = mixed(pair), second = mixed(first + 0x9e3779b9ul);
  const uint16_t place = static_cast<uint16_t>(static_cast<uint32_t>(i) << (16 - log2));
  return {static_cast<uint16_t>(place ^ (first & 0xffffu)),
          static_cast<uint16_t>(sobol(i, 0) ^ (first >> 16)),
          static_cast<uint16_t>(sobol(i, 1) ^ (second & 0xffffu)),
          static_cast<uint16_t>(sobol(i, 2) ^ (second >> 16))};
}

AreaPoints::AreaPoints(const Polygon& polygon) : polygon_(polygon), is_parallelogram_(closes(polygon)) {
  const int triangles = polygon.count - 2;
  const int shift = fan_shift(polygon);
  uint32_t sum = 0;
  for (int k = 0; k < triangles && !is_parallelogram_; ++k) {
    sum += triangle_measure(polygon, k, shift) >> 1;  // ten of them, below 2^28 each
    part_[k] = sum;
  }
}

Vec3 AreaPoints::at(uint16_t s, uint16_t t) const {
  const Vec3* corner = polygon_.corner;
  if (is_parallelogram_) {
    return affine_point(corner[0], corner[1], corner[3], s, t);
  }
  const int last = polygon_.count - 3;
  if (last < 0) {
    return polygon_.count > 0 ? corner[0] : Vec3{0, 0, 0};
  }
  const uint32_t wanted = static_cast<uint32_t>(wide_product(part_[last], s) >> 16);
  int k = 0;
  while (k < last && part_[k] <= wanted) {
    ++k;
  }
  const uint32_t begin = k == 0 ? 0 : part_[k - 1];
  const uint32_t width = part_[k] - begin;
  const uint32_t inner =
      width == 0 ? 0 : static_cast<uint32_t>((static_cast<uint64_t>(wanted - begin) << 16) / width);
  int32_t a = inner < 0xffffu ? static_cast<int32_t>(inner) : 0xffff, b = t;
  if (a + b > 0x10000) {  // folded back into the triangle
    a = 0x10000 - a;
    b = 0x10000 - b;
  }
  return affine_point(corner[0], corner[k + 1], corner[k + 2], a, b);
}

}  // namespace fixrad
