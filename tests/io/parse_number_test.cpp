// SPDX-License-Identifier: MIT
#include "host_sim/io/parse_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace fixrad::host {
namespace {

TEST(ParseReal, TakesWholeDecimalNumbersOnly) {
  EXPECT_EQ(parse_real("-1.25e2"), -125.0);
  EXPECT_EQ(parse_real("+.5"), 0.5);
  EXPECT_EQ(parse_real("3."), 3.0);
  EXPECT_EQ(parse_real("0.1"), 0.1);
  for (const char* token : {"", "+", "-", ".", "e5", "1 ", " 1", "1x", "0x1p3", "1,0", "++1", "+-1"}) {
    EXPECT_FALSE(parse_real(token)) << token;
  }
}

TEST(ParseReal, OverflowIsInfiniteAndUnderflowIsZero) {
  EXPECT_TRUE(std::isinf(*parse_real("1e400")));
  EXPECT_TRUE(std::isinf(*parse_real("-123.0E+4000")));
  EXPECT_EQ(parse_real("1e-400"), 0.0);
  EXPECT_TRUE(std::isnan(*parse_real("nan")));
}

TEST(ParseReal, RefusesAbsurdLengths) {
  EXPECT_TRUE(parse_real("0." + std::string(126, '3')));
  EXPECT_FALSE(parse_real("0." + std::string(127, '3')));
}

TEST(ParseInteger, TakesWholeIntegersAndSaturates) {
  EXPECT_EQ(parse_integer("-42"), -42);
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_EQ(parse_integer("99999999999999999999"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parse_integer("-99999999999999999999"), std::numeric_limits<std::int64_t>::min());
  for (const char* token : {"", "1.0", "1 ", "a", "+", "--1", "+-1"}) {
    EXPECT_FALSE(parse_integer(token)) << token;
  }
}

}  // namespace
}  // namespace fixrad::host
