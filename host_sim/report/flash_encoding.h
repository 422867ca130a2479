// SPDX-License-Identifier: MIT
// How the flash table encodes positions, radiosity and its own name.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fixrad::host {

/// Exponent bias of RGBE8 when mantissas are read as integers 0 to 255.
inline constexpr int kRgbeBias = 136;

/// position = offset + q * scale with q an int16; both numbers are floats, as the table writes them.
struct PositionGrid {
  double scale = 1.0;      ///< scene units a step, > 0
  glm::dvec3 offset{0.0};  ///< scene unit, the middle of the bounding box
};

/// The finest common grid on which all positions (one or more, finite) fit into -32767 .. 32767.
PositionGrid position_grid(const std::vector<glm::dvec3>& positions);

/// The grid point nearest to `position`, which lies within the box that the grid was made for.
std::array<std::int16_t, 3> quantise(const PositionGrid& grid, const glm::dvec3& position);

/// A colour with a shared exponent, {r, g, b, e}: channel = m * 2^(e - kRgbeBias), rounded to nearest, so the
/// error is at most half of 2^(e - kRgbeBias), which is 1/256 of the largest channel. Channels >= 0, finite;
/// what is smaller than the format holds becomes black, what is larger its largest value. Source: G. Ward,
/// "Real Pixels", Graphics Gems II (1991), with rounding instead of truncation.
std::array<std::uint8_t, 4> rgbe8(const glm::dvec3& radiosity);

/// A scene's name as the name of a C++ namespace: ASCII letters, digits and single underscores; `scene_` in
/// front where the name is empty, starts with a digit, or has a meaning already (keywords, std, names that
/// end in _t and what compilers predefine).
std::string namespace_name(std::string_view scene_name);

}  // namespace fixrad::host
