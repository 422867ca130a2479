// SPDX-License-Identifier: MIT
// Tables of integers as C++ for a firmware's flash.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fixrad::host {

/// Integers as C++ reads them where int has 16 bits: signed literals take the type that holds them, unsigned
/// ones need the suffix to stay unsigned.
std::string literal(std::int64_t value);
std::string unsigned_literal(std::uint32_t value);
std::string hex_literal(std::uint64_t value);

/// `{part, part, ...}`.
std::string braced(const std::vector<std::string>& parts);

/// An array as a braced list of literals.
template <class T, std::size_t N>
std::string braced_array(const T (&values)[N]) {
  std::vector<std::string> parts;
  for (const T value : values) {
    parts.push_back(literal(value));
  }
  return braced(parts);
}

/// `constexpr FIXRAD_IN_FLASH declaration = {records};`, lines filled.
void append_table(std::string& text, std::string_view declaration, const std::vector<std::string>& records);

/// An inline function whose value is `type` of the core with the given members.
void append_function(std::string& text, const std::string& type, const std::string& name,
                     const std::vector<std::pair<const char*, std::string>>& members);

}  // namespace fixrad::host
