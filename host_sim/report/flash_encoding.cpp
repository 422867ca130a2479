// SPDX-License-Identifier: MIT
#include "host_sim/report/flash_encoding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr double kLargestStep = 32767.0;

/// C++17 keywords (N4659 [lex.key], tables 5 and 6), and names that a global namespace cannot have: std,
/// main, and what GNU compilers predefine without underscores.
bool is_taken(const std::string& name) {
  static const std::set<std::string, std::less<>> taken = {"alignas",
                                                           "alignof",
                                                           "and",
                                                           "and_eq",
                                                           "asm",
                                                           "auto",
                                                           "bitand",
                                                           "bitor",
                                                           "bool",
                                                           "break",
                                                           "case",
                                                           "catch",
                                                           "char",
                                                           "class",
                                                           "compl",
                                                           "const",
                                                           "continue",
                                                           "decltype",
                                                           "default",
                                                           "delete",
                                                           "do",
                                                           "double",
                                                           "else",
                                                           "enum",
                                                           "explicit",
                                                           "export",
                                                           "extern",
                                                           "false",
                                                           "float",
                                                           "for",
                                                           "friend",
                                                           "goto",
                                                           "if",
                                                           "inline",
                                                           "int",
                                                           "long",
                                                           "mutable",
                                                           "namespace",
                                                           "new",
                                                           "noexcept",
                                                           "not",
                                                           "not_eq",
                                                           "nullptr",
                                                           "operator",
                                                           "or",
                                                           "or_eq",
                                                           "private",
                                                           "protected",
                                                           "public",
                                                           "register",
                                                           "return",
                                                           "short",
                                                           "signed",
                                                           "sizeof",
                                                           "static",
                                                           "struct",
                                                           "switch",
                                                           "template",
                                                           "this",
                                                           "throw",
                                                           "true",
                                                           "try",
                                                           "typedef",
                                                           "typeid",
                                                           "typename",
                                                           "union",
                                                           "unsigned",
                                                           "using",
                                                           "virtual",
                                                           "void",
                                                           "volatile",
                                                           "while",
                                                           "xor",
                                                           "xor_eq",
                                                           "const_cast",
                                                           "dynamic_cast",
                                                           "reinterpret_cast",
                                                           "static_cast",
                                                           "static_assert",
                                                           "thread_local",
                                                           "constexpr",
                                                           "wchar_t",
                                                           "char16_t",
                                                           "char32_t",
                                                           "std",
                                                           "main",
                                                           "linux",
                                                           "unix",
                                                           "i386",
                                                           "arm",
                                                           "avr",
                                                           "AVR",
                                                           "concept",
                                                           "requires",
                                                           "typeof"};
  const bool type_name = name.size() > 2 && name.compare(name.size() - 2, 2, "_t") == 0;
  return type_name || taken.count(name) != 0;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_identifier_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c);
}

}  // namespace

PositionGrid position_grid(const std::vector<glm::dvec3>& positions) {
  PositionGrid grid;
  double reach = 0.0;
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(positions.begin(), positions.end(),
                            [k](const glm::dvec3& a, const glm::dvec3& b) { return a[k] < b[k]; });
    const double offset = finite_float((*low)[k] / 2.0 + (*high)[k] / 2.0);
    grid.offset[k] = offset;
    reach = std::max({reach, (*high)[k] - offset, offset - (*low)[k]});
  }
  if (reach > 0.0) {
    // Rounded up, so that the outermost vertex never falls off the grid.
    const float nearest = finite_float(reach / kLargestStep);
    grid.scale = std::nextafter(nearest, std::numeric_limits<float>::max());
  }
  return grid;
}

std::array<std::int16_t, 3> quantise(const PositionGrid& grid, const glm::dvec3& position) {
  std::array<std::int16_t, 3> result{};
  for (int k = 0; k < 3; ++k) {
    const double steps = std::round((position[k] - grid.offset[k]) / grid.scale);
    result[static_cast<std::size_t>(k)] =
        static_cast<std::int16_t>(std::clamp(steps, -kLargestStep, kLargestStep));
  }
  return result;
}

std::array<std::uint8_t, 4> rgbe8(const glm::dvec3& radiosity) {
  const double largest = std::max({radiosity.x, radiosity.y, radiosity.z});
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest in [2^(exponent - 1), 2^exponent)
  // A mantissa that rounds up to 256 belongs to the next exponent.
  if (std::round(std::ldexp(largest, 8 - exponent)) > 255.0) {
    ++exponent;
  }
  const int biased = std::min(exponent + kRgbeBias - 8, 255);
  if (!(largest > 0.0) || biased < 1) {
    return {0, 0, 0, 0};
  }
  const auto mantissa = [biased](double channel) {
    return static_cast<std::uint8_t>(std::min(255.0, std::round(std::ldexp(channel, kRgbeBias - biased))));
  };
  return {mantissa(radiosity.x), mantissa(radiosity.y), mantissa(radiosity.z),
          static_cast<std::uint8_t>(biased)};
}

std::string namespace_name(std::string_view scene_name) {
  std::string name;
  for (const char c : scene_name) {
    if (is_identifier_character(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';  // never two in a row, nor in front: such names are reserved
    }
  }
  while (!name.empty() && name.back() == '_') {
    name.pop_back();
  }
  const bool needs_prefix = name.empty() || is_digit(name.front()) || is_taken(name);
  if (!needs_prefix) {
    return name;
  }
  return name.empty() ? "scene" : "scene_" + name;
}

}  // namespace fixrad::host
