// SPDX-License-Identifier: MIT
#include "lib/picture/highlight.h"

#include "lib/form_factor/arc.h"

namespace fixrad {
namespace {

// 2/pi, UQ0.32: an area counts eighths of a square grid unit, distances here quarters of a unit.
constexpr uint32_t kTwoOverPi = 2734261102ul;

constexpr int kGainBits = 20;

int32_t cosine(const Vec3& a, const Vec3& b) {
  const int64_t sum =
      static_cast<int64_t>(a.x) * b.x + static_cast<int64_t>(a.y) * b.y + static_cast<int64_t>(a.z) * b.z;
  const int64_t one = kArcOne;
  const int64_t value = sum >> kArcBits;
  return static_cast<int32_t>(value > one ? one : value);
}

// 2 (n . v) n - v.
Vec3 mirror_direction(const Vec3& v, const Vec3& n) {
  const int64_t twice = 2 * static_cast<int64_t>(cosine(n, v));
  return {static_cast<int32_t>((twice * n.x >> kArcBits) - v.x),
          static_cast<int32_t>((twice * n.y >> kArcBits) - v.y),
          static_cast<int32_t>((twice * n.z >> kArcBits) - v.z)};
}

// base^exponent, UQ0.32, by repeated squaring.
uint32_t power(uint32_t base, uint16_t exponent) {
  uint32_t result = 0xffffffffu;
  for (; exponent != 0; exponent = static_cast<uint16_t>(exponent >> 1)) {
    result = (exponent & 1u) != 0 ? mul_high(result, base) : result;
    base = mul_high(base, base);
  }
  return result;
}

uint32_t unsigned_cosine(int32_t c) {
  return c >= kArcOne ? 0xffffffffu : static_cast<uint32_t>(c) << 2;
}

uint64_t square(Vec3 a) {
  return wide_product(magnitude(a.x), magnitude(a.x)) + wide_product(magnitude(a.y), magnitude(a.y)) +
         wide_product(magnitude(a.z), magnitude(a.z));
}

// A cos cos' / (pi r^2), UQ0.32, below 1.
uint32_t arriving_part(const PictureLamp& lamp, Vec3 way, int32_t at_surface, int32_t at_lamp) {
  const uint32_t cosines = mul_high(unsigned_cosine(at_surface), unsigned_cosine(at_lamp)) >> 16;
  const uint64_t numerator = wide_product(mul_high(lamp.area, kTwoOverPi), cosines);
  const uint64_t part = (numerator << 16) / (square(way) | 1u);
  return saturate(part, Place::light_of_lamp);
}

struct Point {
  Vec3 at;                // quarters of a grid unit
  Vec3 normal, mirrored;  // Q1.30
};

// What of a lamp's radiosity, times Ks, is seen: UQ12.20.
uint32_t gain_of(const PictureLamp& lamp, const Point& point, uint16_t exponent) {
  const Vec3 way = vec(lamp.at) - point.at;
  const Vec3 to_lamp = unit_vector(way);
  const int32_t lobe = cosine(point.mirrored, to_lamp), at_surface = cosine(point.normal, to_lamp);
  if (lobe <= 0 || at_surface <= 0) {
    return 0;
  }
  const Vec3 back = {-to_lamp.x, -to_lamp.y, -to_lamp.z};
  const int32_t at_lamp = cosine(unit_vector(vec(lamp.normal)), back);
  if (at_lamp <= 0) {
    return 0;
  }
  const uint32_t part = arriving_part(lamp, way, at_surface, at_lamp);
  const uint32_t shape =
      (power(unsigned_cosine(lobe), exponent) >> 16) * (static_cast<uint32_t>(exponent) + 2u) / 2u;
  return static_cast<uint32_t>(wide_product(part, shape) >> (32 + 16 - kGainBits));
}

}  // namespace

void add_highlights(const PictureScene& scene, const PictureMaterial& material, const Vec3& at,
                    const Vec3& normal, const Vec3& eye, uint16_t* light) {
  Point point;
  point.at = {at.x * kEyeScale, at.y * kEyeScale, at.z * kEyeScale};
  point.normal = unit_vector(normal);
  const Vec3 to_eye = unit_vector(eye - at);
  if (cosine(point.normal, to_eye) <= 0) {
    return;
  }
  point.mirrored = mirror_direction(to_eye, point.normal);
  for (uint8_t i = 0; i < scene.lamp_count; ++i) {
    const PictureLamp lamp = flash_read(scene.lamps, i);
    const uint32_t gain = gain_of(lamp, point, material.exponent);
    for (uint8_t c = 0; c < scene.channels; ++c) {
      const uint64_t shown = static_cast<uint64_t>(lamp.light[c]) * material.specular[c] >> 16;
      const uint64_t sum = light[c] + (wide_product(static_cast<uint32_t>(shown), gain) >> kGainBits);
      light[c] = static_cast<uint16_t>(saturate(sum, Place::light_of_picture, kLightMax));
    }
  }
}

}  // namespace fixrad
