// SPDX-License-Identifier: MIT
#include "host_sim/io/parse_number.h"

#include <charconv>
#include <limits>
#include <system_error>

#include "host_sim/io/limits.h"
#include "host_sim/io/source_text.h"

namespace fixrad::host {
namespace {

// No digits of so few characters overflow a double, so "out of range" with a negative exponent is underflow.
static_assert(kMaxNumberChars < 300);

std::string_view without_plus(std::string_view token) {
  const bool has_plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  return has_plus ? token.substr(1) : token;
}

}  // namespace

std::optional<double> parse_real(std::string_view token) {
  token = without_plus(token);
  if (token.size() > kMaxNumberChars) {
    return std::nullopt;
  }
  double value = 0.0;
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) {
    return std::nullopt;
  }
  if (result.ec == std::errc::result_out_of_range) {
    const std::size_t exponent = token.find_first_of("eE");
    const bool underflows = exponent != std::string_view::npos && token[exponent + 1] == '-';
    return underflows ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  token = without_plus(token);
  std::int64_t value = 0;
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) {
    return std::nullopt;
  }
  if (result.ec == std::errc::result_out_of_range) {
    using Limits = std::numeric_limits<std::int64_t>;
    return token[0] == '-' ? Limits::min() : Limits::max();
  }
  return value;
}

std::string explain_bad_number(std::string_view token) {
  if (token.find(',') != std::string_view::npos) {
    return quote(token) + " is not a number; write a decimal point, not a comma";
  }
  return quote(token) + " is not a number; write a decimal number";
}

}  // namespace fixrad::host
