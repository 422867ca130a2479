// SPDX-License-Identifier: MIT
// What the core takes for granted of a compiler, and what it must not.
#include <limits.h>
#include <stdint.h>

#include "lib/fixrad.h"
#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

static_assert(CHAR_BIT == 8, "records are counted in bytes of eight bits");
static_assert(sizeof(long) >= 4, "bit_length() counts in unsigned long");
static_assert(-1 == ~0, "negative integers are two's complement");

// As long as the compiler does not know the value it must compute with the target's own int.
template <class T>
T at_run_time(T value) {
  volatile T hidden = value;
  return hidden;
}

TEST(Platform, IntMayHaveSixteenBitsAndConstantsOfTheCoreStillFit) {
  EXPECT_EQ(at_run_time(kRowOne), 1048576u);
  EXPECT_EQ(at_run_time(static_cast<uint32_t>(kRowEnd)), 4096u);
  EXPECT_EQ(at_run_time(kUnit), 16384);
  EXPECT_EQ(at_run_time(kUnit) * kUnit, 268435456);
  EXPECT_EQ(at_run_time(static_cast<uint32_t>(1) << kDeltaSumLog2), kRowOne);
}

TEST(Platform, ConversionToANarrowerSignedIntegerKeepsTheLowBits) {
  EXPECT_EQ(static_cast<int16_t>(at_run_time<int32_t>(98304)), -32768);
  EXPECT_EQ(static_cast<int32_t>(at_run_time<uint32_t>(0xfffffffeu)), -2);
  EXPECT_EQ(static_cast<int8_t>(at_run_time<uint16_t>(0x1ff)), -1);
}

TEST(Platform, DivisionTruncatesTowardsZero) {
  EXPECT_EQ(at_run_time<int32_t>(-7) / 2, -3);
  EXPECT_EQ(at_run_time<int32_t>(-7) % 2, -1);
  EXPECT_EQ(at_run_time<int64_t>(-7000000000) / 1000000000, -7);
}

// What `fixrad info` promises for a target is computed on the host, from these records.
TEST(Platform, WorkingRecordsAreNoLargerThanOnTheHost) {
  EXPECT_EQ(sizeof(Direction), 8u);
  EXPECT_LE(sizeof(Span), 6u);
  EXPECT_EQ(sizeof(Item), 4u);
  EXPECT_LE(sizeof(FaceView), 92u);
}

template <class L>
void expect_documented_size() {
  constexpr Sizes sizes = {L::vertices, L::faces, L::elements, L::spans, L::channels, L::pixel_resolution};
  constexpr uint32_t kAlignment = 32;  // between the arrays, and the item that a solver without items has
  EXPECT_LE(sizeof(Solver<L>), pool_bytes(sizes) + state_bytes(sizeof(void*)) + kAlignment);
  EXPECT_GE(sizeof(Solver<L>), pool_bytes(sizes));
}

TEST(Platform, ASolverIsAsLargeAsTheFormulaSays) {
  expect_documented_size<Limits<8, 6, 6>>();
  expect_documented_size<Limits<8, 6, 11>>();
  expect_documented_size<Limits<28, 20, 263, 41, 1>>();
  expect_documented_size<Limits<100, 77, 777, 55, 3, 32>>();
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad
