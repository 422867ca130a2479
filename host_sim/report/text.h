// SPDX-License-Identifier: MIT
// Numbers and names as text, the same in every locale, and text as a file that appears complete or not at
// all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace fixrad::host {

/// Appends the shortest decimal number that reads back as exactly `value`. Independent of the locale.
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);
void append_number(std::string& text, std::int64_t value);

/// `value` as 16 hexadecimal digits.
std::string hex(std::uint64_t value);

/// Appends `value` as a C++ literal of type float, `0.5f` or `1e-20f`; value finite.
void append_float_literal(std::string& text, float value);

/// `name` with every byte that could end or continue a comment line (controls, backslash) replaced by `_`.
std::string one_line(std::string_view name);

/// `field` as a CSV field: in quotes, quotes doubled, where it holds a comma, a quote, a line end or an outer
/// blank. Source: RFC 4180, section 2, rules 5 to 7.
std::string csv_field(std::string_view field);

/// Double to float, rounded to nearest; beyond the range of float the largest finite value (files hold no
/// infinity).
float finite_float(double value);

/// Writes `text` to `target` by write_atomically. Throws InputError if it cannot be written.
void write_text(const std::filesystem::path& target, std::string_view text);

}  // namespace fixrad::host
