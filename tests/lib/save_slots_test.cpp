// SPDX-License-Identifier: MIT
// Two slots: power that is lost at any byte of a write leaves a state to go on from. And the checksum,
// against its published check value.
#include <gmock/gmock.h>

#include <memory>

#include "firmware/scenes/cornell_grey_tiny.h"
#include "tests/lib/saved_blob.h"

namespace fixrad::host {
namespace {

namespace scene = ::cornell_grey_tiny;

constexpr std::size_t kSlotBytes = saved_bytes(scene::Limits::elements, scene::Limits::faces, 1);

struct Device {
  Device() {
    EXPECT_EQ(solver->load(scene::scene(), scene::settings()), Status::ok);
    identity = solver->identify();
    for (Blob& slot : slots) {
      slot.bytes.assign(kSlotBytes, 0xff);
    }
  }

  SlotChoice choose() {
    const StateSource sources[2] = {slots[0].source(), slots[1].source()};
    return choose_slot(solver->state(), identity, sources);
  }

  // Puts the first `count` bytes of `blob` over what the slot holds.
  void write(std::uint8_t slot, const Blob& blob, std::size_t count) {
    std::copy_n(blob.bytes.begin(), count, slots[slot].bytes.begin());
  }

  Blob at(const SlotChoice& choice) { return saved(solver->state(), identity, choice.sequence); }

  std::unique_ptr<scene::Solver> solver = std::make_unique<scene::Solver>();
  Identity identity;
  Blob slots[2];
};

TEST(Slots, ErasedOnesHoldNothing) {
  Device device;
  const SlotChoice choice = device.choose();
  EXPECT_EQ(choice.newest, kNoSlot);
  EXPECT_LT(choice.next, 2);
}

TEST(Slots, AreWrittenInTurn) {
  Device device;
  SlotChoice choice = device.choose();
  for (int shot = 0; shot < 20; ++shot) {
    ASSERT_EQ(device.solver->step(), Status::ok);
    const Blob blob = device.at(choice);
    device.write(choice.next, blob, blob.bytes.size());
    const SlotChoice found = device.choose(), told = after_saving(choice);
    EXPECT_EQ(found.newest, choice.next);
    EXPECT_EQ(found.next, 1 - choice.next);
    EXPECT_EQ(told.newest, found.newest);
    EXPECT_EQ(told.next, found.next);
    EXPECT_EQ(told.sequence, found.sequence);
    choice = found;
  }
}

TEST(Slots, NumbersGoOnRoundTheEndOf32Bits) {
  Device device;
  const std::pair<std::uint32_t, std::uint32_t> numbers[] = {
      {0xfffffffe, 0xffffffff}, {0xffffffff, 0}, {7, 8}};
  for (const auto& [older, newer] : numbers) {
    for (std::uint8_t first = 0; first < 2; ++first) {
      const Blob a = saved(device.solver->state(), device.identity, older);
      const Blob b = saved(device.solver->state(), device.identity, newer);
      device.write(first, a, a.bytes.size());
      device.write(static_cast<std::uint8_t>(1 - first), b, b.bytes.size());
      const SlotChoice choice = device.choose();
      EXPECT_EQ(choice.newest, 1 - first);
      EXPECT_EQ(choice.sequence, newer + 1);
    }
  }
}

// The power fails after each byte of a write into a slot that has been erased, or still holds an older state.
TEST(Slots, AnyCutOfAWriteLeavesTheStateBefore) {
  for (const bool is_erased : {true, false}) {
    Device device;
    SlotChoice choice = device.choose();
    Blob before, blob;
    for (int save = 0; save < 3; ++save) {
      for (int shot = 0; shot < 10; ++shot) {
        ASSERT_EQ(device.solver->step(), Status::ok);
      }
      before = blob;
      blob = device.at(choice);
      if (save < 2) {
        device.write(choice.next, blob, blob.bytes.size());
        choice = after_saving(choice);
      }
    }
    const Blob old = device.slots[choice.next];
    ASSERT_NE(blob.bytes, old.bytes);
    for (std::size_t count = 0; count <= blob.bytes.size(); ++count) {
      device.slots[choice.next] = old;
      if (is_erased) {
        device.slots[choice.next].bytes.assign(kSlotBytes, 0xff);
      }
      device.write(choice.next, blob, count);
      const bool is_whole =
          std::equal(blob.bytes.begin(), blob.bytes.end(), device.slots[choice.next].bytes.begin());
      const SlotChoice found = device.choose();
      ASSERT_EQ(found.newest, is_whole ? choice.next : 1 - choice.next) << count;
      ASSERT_EQ(device.solver->resume(device.identity, device.slots[found.newest].source()), SaveStatus::ok);
      ASSERT_EQ(saved(device.solver->state(), device.identity, found.sequence - 1).bytes,
                is_whole ? blob.bytes : before.bytes);
    }
  }
}

TEST(Checksum, OfTheNineDigitsIsThePublishedOne) {
  Checksum sum;
  EXPECT_EQ(sum.value(), 0u);
  for (const char digit : {'1', '2', '3', '4', '5', '6', '7', '8', '9'}) {
    sum.add(static_cast<std::uint8_t>(digit));
  }
  EXPECT_EQ(sum.value(), 0xcbf43926u);
}

}  // namespace
}  // namespace fixrad::host
