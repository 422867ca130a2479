// SPDX-License-Identifier: MIT
#include "lib/form_factor/eye.h"

namespace fixrad {
namespace {

struct Turn {
  int16_t cosine, sine;  // Q14
};

// Angle i is frac((i + 1/2) * 0.6180339887) * 180 degrees, the golden-ratio sequence: any run of it covers
// evenly the half turn after which lunes repeat (and the quarter turn of a hemicube). None is 0: there rows
// are parallel to the borders of elements in a rectangular room, and where a border lies on the middle of a
// row, the last bit decides about the whole row.
constexpr FIXRAD_IN_FLASH Turn kTurnTable[kTurns] = {
    {9251, 13522},   {-15956, 3722}, {-2313, 16220}, {14279, 8033},  {-12662, 10398}, {5103, 15569},
    {16360, 886},    {-6754, 14927}, {11465, 11704}, {-15063, 6444}, {548, 16375},    {15460, 5423},
    {-10657, 12444}, {7737, 14442},  {-16264, 1977}, {-4051, 15875}};

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
