// SPDX-License-Identifier: MIT
#include "host_sim/report/text.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "host_sim/io/atomic_file.h"

namespace fixrad::host {
namespace {

template <typename Number>
void append_chars(std::string& text, Number value) {
  char buffer[32];  // the longest shortest double has 24 characters
  const std::to_chars_result result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

}  // namespace

void append_number(std::string& text, double value) {
  append_chars(text, value);
}
void append_number(std::string& text, float value) {
  append_chars(text, value);
}
void append_number(std::string& text, std::int64_t value) {
  append_chars(text, value);
}

std::string hex(std::uint64_t value) {
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; value >>= 4) {
    digits[i] = "0123456789abcdef"[value & 15u];
  }
  return digits;
}

void append_float_literal(std::string& text, float value) {
  const std::size_t start = text.size();
  append_chars(text, value);
  // `1f` is no literal, `1.0f` and `1e+20f` are.
  if (text.find_first_of(".e", start) == std::string::npos) {
    text += ".0";
  }
  text += 'f';
}

std::string one_line(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || c == '\\') {
      c = '_';
    }
  }
  return result;
}

std::string csv_field(std::string_view field) {
  const bool outer_blank = !field.empty() && (field.front() == ' ' || field.back() == ' ');
  if (field.find_first_of(",\"\r\n") == std::string_view::npos && !outer_blank) {
    return std::string(field);
  }
  std::string quoted = "\"";
  for (const char c : field) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + '"';
}

float finite_float(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

void write_text(const std::filesystem::path& target, std::string_view text) {
  write_atomically(target, [&](const std::filesystem::path& temporary) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
      throw std::runtime_error(errno != 0 ? std::strerror(errno) : "the disk refused the data");
    }
  });
}

}  // namespace fixrad::host
