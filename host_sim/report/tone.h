// SPDX-License-Identifier: MIT
// Radiosity to displayed colour, in one place: every writer and every picture goes through these functions.
//
//   radiosity (W/m^2) --exposure_scale--> exposed --tone--> linear display [0, 1] --srgb8--> 8 bits
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "host_sim/report/baked_mesh.h"

namespace fixrad::host {

/// Exposed luminance that the automatic exposure gives to the middle of the scene.
inline constexpr double kMiddleLuminance = 0.30;
/// Below this exposed value the tone curve is the identity.
inline constexpr double kShoulderStart = 0.45;
/// Exposed value of the largest channel from which on a colour is displayed as white.
inline constexpr double kWhitePoint = 12.0;

/// An 8-bit sRGB colour: red, green, blue.
using Srgb8 = std::array<std::uint8_t, 3>;

/// Relative luminance of a linear colour with the sRGB primaries (ITU-R BT.709 weights), unit of the colour.
double luminance(const glm::dvec3& linear);

/// The factor from radiosity (W/m^2) to exposed values, > 0: kMiddleLuminance / middle *
/// 2^display.exposure_ev. The middle is the area-weighted mean of log luminance over the lit elements that
/// are no lamps, without the darkest 5 % and the brightest 15 % of their area, so that neither a lamp nor a
/// hot spot drives it. Falls back on lamps, then on triangles where the mesh has no elements; a mesh without
/// light gets 2^exposure_ev. O(n log n).
double exposure_scale(const BakedMesh& mesh, const Display& display);

/// The tone curve of one exposed value x >= 0, result in [0, 1]: x up to kShoulderStart, above it a shoulder
/// with a continuous slope that reaches 1 at kWhitePoint (extended Reinhard on what is left to 1). Source:
/// Reinhard et al. 2002, "Photographic tone reproduction for digital images", eq. 4.
double tone_curve(double exposed);

/// Exposed colour (each channel >= 0) to linear display colour, each channel in [0, 1]. The curve acts on the
/// largest channel and the others keep their ratio to it, so that hue stays; only towards the white point a
/// colour fades to white. A grey of value x becomes the grey tone_curve(x).
glm::dvec3 tone(const glm::dvec3& exposed);

/// The sRGB transfer function (IEC 61966-2-1): linear in [0, 1] to encoded in [0, 1]; values outside are
/// clamped.
double srgb_from_linear(double linear);

/// Linear display colour to 8 bits a channel, rounded to nearest.
Srgb8 srgb8(const glm::dvec3& linear);

/// srgb8(tone(radiosity * scale)), scale from exposure_scale.
Srgb8 display_colour(const glm::dvec3& radiosity, double scale);

}  // namespace fixrad::host
