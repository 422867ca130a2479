// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fixrad::host {

/// The whole of `token` as a decimal number (a leading + is allowed), or nothing if it is none.
/// "nan", "inf" and what overflows come back as a NaN or an infinity: test with std::isfinite.
/// What underflows is 0. Independent of the locale. Tokens of more than 128 characters are no numbers.
std::optional<double> parse_real(std::string_view token);

/// The whole of `token` as a decimal integer, or nothing. Values beyond 64 bits saturate.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// "what is wrong; what to do" for a token that parse_real refuses.
std::string explain_bad_number(std::string_view token);

}  // namespace fixrad::host
