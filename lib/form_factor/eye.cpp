// SPDX-License-Identifier: MIT
#include "lib/form_factor/eye.h"

namespace fixrad {
namespace {

struct Turn {
  int16_t cosine, sine;  // Q14
};

// Angle i is frac((i + 1/2) * 0.6180339887) * 90 degrees, the golden-ratio sequence: any run of it covers the
// quarter turn evenly. None is 0: there rows are parallel to the borders of elements in a rectangular room,
// and where a border lies on the middle of a row, the last bit decides about the whole row.
constexpr FIXRAD_IN_FLASH Turn kTurnTable[kTurns] = {
    {14491, 7644}, {1873, 16277}, {10736, 12376}, {15849, 4152}, {5522, 15425},  {13267, 9613},
    {16378, 443},  {8882, 13768}, {15104, 6348},  {3289, 16050}, {11777, 11390}, {16151, 2751},
    {6849, 14884}, {14057, 8417}, {990, 16354},   {10051, 12938}};

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
