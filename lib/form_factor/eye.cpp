// SPDX-License-Identifier: MIT
#include "lib/form_factor/eye.h"

namespace fixrad {
namespace {

struct Turn {
  int16_t cosine, sine;  // Q14
};

// Angle i is frac(i * 0.6180339887) * 90 degrees, the golden-ratio sequence: any run of it covers the quarter
// turn evenly.
constexpr FIXRAD_FLASH Turn kTurnTable[kTurns] = {
    {16384, 0},    {9251, 13522}, {15270, 5937}, {3722, 15956},  {12081, 11067}, {16220, 2313},
    {7249, 14693}, {14279, 8033}, {1432, 16321}, {10398, 12662}, {15731, 4579},  {5103, 15569},
    {13002, 9969}, {16360, 886},  {8506, 14003}, {14927, 6754}};

Vec3 combine(Vec3 a, int32_t p, Vec3 b, int32_t q) {
  const int32_t half = kUnit / 2;
  return {floor_shift(a.x * p + b.x * q + half, 14), floor_shift(a.y * p + b.y * q + half, 14),
          floor_shift(a.z * p + b.z * q + half, 14)};
}

}  // namespace

EyeFrame eye_frame(const Face& face, uint8_t turn) {
  const Turn t = flash_read(kTurnTable, turn % kTurns);
  const Vec3 z = vec(face.normal);
  const Vec3 x0 = vec(face.tangent);
  const Vec3 c = cross(z, x0);
  const Vec3 y0 = {floor_shift(c.x + kUnit / 2, 14), floor_shift(c.y + kUnit / 2, 14),
                   floor_shift(c.z + kUnit / 2, 14)};
  return {combine(x0, t.cosine, y0, t.sine), combine(y0, t.cosine, x0, -t.sine), z};
}

}  // namespace fixrad
