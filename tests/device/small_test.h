// SPDX-License-Identifier: MIT
#pragma once

// The macros of GoogleTest that a chip of 8 KB has room for. A failure is written as
//   FILE:LINE: expected a == b, got 0x3 and 0x4
// Texts stay in flash, a test takes three pointers of RAM, nothing is allocated.

#include <stdint.h>

#include "lib/fixed/flash.h"

namespace fixrad {
namespace small_test {

/// One TEST; constructing it enters it into the list that run_all() goes through.
class Case {
 public:
  Case(const FIXRAD_FLASH char* name, void (*run)());
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

 private:
  friend int run_all();

  const FIXRAD_FLASH char* name_;
  void (*run_)();
  Case* next_;
};

/// An integer of any type, for a message.
struct Value {
  uint64_t magnitude;
  bool is_negative;
};

inline Value value_of(bool v) {
  return {v ? 1u : 0u, false};
}

/// T: an integer, or an enumeration, which is shown as the unsigned number of its bits.
template <class T>
Value value_of(T v) {
  const int64_t wide = static_cast<int64_t>(v);
  const bool is_negative = wide < 0 && !(v > static_cast<T>(0));
  const uint64_t bits = static_cast<uint64_t>(wide);
  return {is_negative ? 0u - bits : bits, is_negative};
}

/// True if a and b differ by at most `tolerance`, in 64 bits.
constexpr bool is_near(int64_t a, int64_t b, int64_t tolerance) {
  return (a < b ? b - a : a - b) <= tolerance;
}

/// Writes that `expected`, at `line` of `file`, does not hold, and marks the running test as failed. Values
/// go by reference, and there is no record of pointers into flash: clang for AVR fails on arguments on the
/// stack, and halves such pointers in initial values.
void fail(const FIXRAD_FLASH char* file, uint16_t line, const FIXRAD_FLASH char* expected);
void fail(const FIXRAD_FLASH char* file, uint16_t line, const FIXRAD_FLASH char* expected, const Value& a,
          const Value& b);

/// Runs every test and writes the verdict. Returns 0 if there was at least one and none has failed, else 1.
int run_all();

namespace {
/// The file that is being compiled, not this header.
constexpr FIXRAD_IN_FLASH char kFile[] = __BASE_FILE__;
}  // namespace

}  // namespace small_test
}  // namespace fixrad

#define TEST(suite, name)                                                                          \
  static void suite##_##name();                                                                    \
  static constexpr FIXRAD_IN_FLASH char suite##_##name##_text[] = #suite "." #name;                \
  static ::fixrad::small_test::Case suite##_##name##_case(suite##_##name##_text, &suite##_##name); \
  static void suite##_##name()

#define FIXRAD_FAIL(...) \
  ::fixrad::small_test::fail(::fixrad::small_test::kFile, static_cast<uint16_t>(__LINE__), __VA_ARGS__)

#define FIXRAD_COMPARE(a, op, b, otherwise)                                    \
  do {                                                                         \
    const auto fixrad_a = (a);                                                 \
    const auto fixrad_b = (b);                                                 \
    if (!(fixrad_a op fixrad_b)) {                                             \
      static constexpr FIXRAD_IN_FLASH char fixrad_text[] = #a " " #op " " #b; \
      FIXRAD_FAIL(fixrad_text, ::fixrad::small_test::value_of(fixrad_a),       \
                  ::fixrad::small_test::value_of(fixrad_b));                   \
      otherwise;                                                               \
    }                                                                          \
  } while (false)

#define FIXRAD_HOLDS(condition, text, otherwise)                  \
  do {                                                            \
    if (!(condition)) {                                           \
      static constexpr FIXRAD_IN_FLASH char fixrad_text[] = text; \
      FIXRAD_FAIL(fixrad_text);                                   \
      otherwise;                                                  \
    }                                                             \
  } while (false)

#define FIXRAD_NEAR(a, b, tolerance, otherwise)                                               \
  do {                                                                                        \
    const auto fixrad_a = (a);                                                                \
    const auto fixrad_b = (b);                                                                \
    if (!::fixrad::small_test::is_near(fixrad_a, fixrad_b, tolerance)) {                      \
      static constexpr FIXRAD_IN_FLASH char fixrad_text[] = #a " near " #b " by " #tolerance; \
      FIXRAD_FAIL(fixrad_text, ::fixrad::small_test::value_of(fixrad_a),                      \
                  ::fixrad::small_test::value_of(fixrad_b));                                  \
      otherwise;                                                                              \
    }                                                                                         \
  } while (false)

#define FIXRAD_GO_ON static_cast<void>(0)

#define EXPECT_EQ(a, b) FIXRAD_COMPARE(a, ==, b, FIXRAD_GO_ON)
#define EXPECT_NE(a, b) FIXRAD_COMPARE(a, !=, b, FIXRAD_GO_ON)
#define EXPECT_LT(a, b) FIXRAD_COMPARE(a, <, b, FIXRAD_GO_ON)
#define EXPECT_LE(a, b) FIXRAD_COMPARE(a, <=, b, FIXRAD_GO_ON)
#define EXPECT_GT(a, b) FIXRAD_COMPARE(a, >, b, FIXRAD_GO_ON)
#define EXPECT_GE(a, b) FIXRAD_COMPARE(a, >=, b, FIXRAD_GO_ON)
#define EXPECT_TRUE(a) FIXRAD_HOLDS(a, #a, FIXRAD_GO_ON)
#define EXPECT_FALSE(a) FIXRAD_HOLDS(!(a), "not " #a, FIXRAD_GO_ON)
#define EXPECT_NEAR(a, b, tolerance) FIXRAD_NEAR(a, b, tolerance, FIXRAD_GO_ON)

#define ASSERT_EQ(a, b) FIXRAD_COMPARE(a, ==, b, return )
#define ASSERT_NE(a, b) FIXRAD_COMPARE(a, !=, b, return )
#define ASSERT_LT(a, b) FIXRAD_COMPARE(a, <, b, return )
#define ASSERT_LE(a, b) FIXRAD_COMPARE(a, <=, b, return )
#define ASSERT_GT(a, b) FIXRAD_COMPARE(a, >, b, return )
#define ASSERT_GE(a, b) FIXRAD_COMPARE(a, >=, b, return )
#define ASSERT_TRUE(a) FIXRAD_HOLDS(a, #a, return )
#define ASSERT_FALSE(a) FIXRAD_HOLDS(!(a), "not " #a, return )
#define ASSERT_NEAR(a, b, tolerance) FIXRAD_NEAR(a, b, tolerance, return )
