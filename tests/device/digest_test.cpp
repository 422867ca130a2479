// SPDX-License-Identifier: MIT
// FNV-1a, 64 bits, against the published test vectors (draft-eastlake-fnv, appendix C).
#include "lib/vertices/digest.h"

#include "tests/device/testing.h"

namespace fixrad {
namespace device_test {
namespace {

constexpr uint64_t kOffsetBasis = 0xcbf29ce484222325;
constexpr uint64_t kOfFoob = 0xdd120e790c2512af;

constexpr int32_t word(char a, char b, char c, char d) {
  return static_cast<int32_t>(static_cast<uint32_t>(d) << 24 | static_cast<uint32_t>(c) << 16 |
                              static_cast<uint32_t>(b) << 8 | static_cast<uint32_t>(a));
}

uint64_t digest_of(int32_t* received, uint16_t elements, uint8_t channels) {
  State state = {};
  state.scene.element_count = elements;
  state.scene.channels = channels;
  state.received = received;
  return digest(state, {nullptr, nullptr, 0});
}

TEST(Digest, OfNothingIsTheOffsetBasis) {
  int32_t none[] = {1};
  EXPECT_EQ(digest_of(none, 0, 1), kOffsetBasis);
}

TEST(Digest, TakesAWordAsFourBytesLeastSignificantFirst) {
  int32_t foob[] = {word('f', 'o', 'o', 'b')};
  EXPECT_EQ(digest_of(foob, 1, 1), kOfFoob);
}

// One multiplication of the definition a byte, and the vector of the first word to start from.
TEST(Digest, GoesOnFromElementToElementAndChannelToChannel) {
  int32_t six[] = {word('f', 'o', 'o', 'b'), -2, 0, 0x01020304, 2147483647, -2147483647 - 1};
  uint64_t expected = kOfFoob;
  for (uint8_t i = 1; i < 6; ++i) {
    const uint32_t bits = static_cast<uint32_t>(six[i]);
    for (uint8_t byte = 0; byte < 4; ++byte) {
      expected ^= bits >> (8 * byte) & 0xffu;
      expected *= 0x100000001b3u;
    }
  }
  EXPECT_EQ(digest_of(six, 6, 1), expected);
  EXPECT_EQ(digest_of(six, 2, 3), expected);
}

TEST(Digest, ChangesWithEveryBit) {
  int32_t zero[] = {0};
  const uint64_t reference = digest_of(zero, 1, 1);
  for (uint8_t bit = 0; bit < 32; ++bit) {
    int32_t one[] = {static_cast<int32_t>(static_cast<uint32_t>(1) << bit)};
    EXPECT_NE(digest_of(one, 1, 1), reference);
  }
}

}  // namespace
}  // namespace device_test
}  // namespace fixrad
