// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/records.h"

namespace fixrad {

/// Adds to `light` [channels] what a shiny material shows of the lamps at a point of its surface (Phong 1975,
/// normalised as by Lafortune & Willems 1994, so that at most a part Ks of what arrives is reflected):
///
///     Ks (n + 2)/2 cos^n(a) E,   E = B A cos cos' / (pi r^2), at most B,
///
/// a the angle between the mirror direction of the eye and the lamp, E the irradiance from a lamp of
/// radiosity B and area A taken as a point. Nothing stands between lamps and surfaces here. `at`, `eye`: grid
/// units, within 17 bits of each other; `normal`: of any length > 0, components of 16 bits. Cost, a lamp: a
/// unit vector (18 wide products), a 64-bit division, and 2 log2(exponent) wide products.
void add_highlights(const PictureScene& scene, const PictureMaterial& material, const Vec3& at,
                    const Vec3& normal, const Vec3& eye, uint16_t* light);

}  // namespace fixrad
