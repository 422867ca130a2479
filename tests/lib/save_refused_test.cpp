// SPDX-License-Identifier: MIT
// What is not the state of this solver is refused by name, and leaves the solver as it was.
#include <gmock/gmock.h>

#include <functional>
#include <memory>

#include "firmware/scenes/closed_box_tiny.h"
#include "firmware/scenes/cornell_grey_tiny.h"
#include "firmware/scenes/cornell_tiny.h"
#include "lib/fixed/short_flux.h"
#include "tests/lib/saved_blob.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

// Where fields stand, docs/saving.md.
enum Offset : std::size_t {
  kLength = 4,
  kVersion = 8,
  kChannels = 10,
  kKind = 11,
  kElements = 12,
  kFaces = 14,
  kScene = 20,
  kSettings = 28,
  kNextEmitter = 54,
  kCursor = 56,
  kTurn = 58,
  kFlags = 59,
  kThreshold = 60,
  kFirstChannel = 68,
  kAmbient = kFirstChannel,
  kEmitted = kFirstChannel + 4,
  kEscaped = kFirstChannel + 8,
  kBack = kFirstChannel + 12,
  kAbsorbed = kFirstChannel + 16,
  kUnshot = kFirstChannel + 24
};

// Two solvers of one scene: one that has been saved, and one some shots behind, which is offered the blob.
template <class Solver>
struct Pair {
  Pair(const Scene& scene, const Settings& settings, int shots) {
    EXPECT_EQ(saver->load(scene, settings), Status::ok);
    EXPECT_EQ(other->load(scene, settings), Status::ok);
    identity = saver->identify();
    for (int i = 0; i < shots && saver->step() == Status::ok; ++i) {
    }
    EXPECT_EQ(other->step(), Status::ok);
    blob = saved(saver->state(), identity);
    before = saved(other->state(), identity);
  }

  SaveStatus offer(Blob& offered) { return other->resume(identity, offered.source()); }

  void expect_refused(Blob& offered, SaveStatus why) {
    EXPECT_EQ(offer(offered), why);
    EXPECT_EQ(saved(other->state(), identity).bytes, before.bytes) << "changed by a blob that was refused";
  }

  std::unique_ptr<Solver> saver = std::make_unique<Solver>(), other = std::make_unique<Solver>();
  Identity identity;
  Blob blob, before;
};

Settings plain_settings() {
  Settings settings = cornell_grey_tiny::settings();
  settings.overshoot = false;
  return settings;
}

// Enough shots for elements, or for faces, to be shooting.
constexpr int kSome = 30, kAll = 100000;

using Grey = Pair<cornell_grey_tiny::Solver>;
using Rgb = Pair<cornell_tiny::Solver>;

Grey grey_pair(int shots) {
  return Grey(cornell_grey_tiny::scene(), plain_settings(), shots);
}
Rgb rgb_pair(int shots) {
  return Rgb(cornell_tiny::scene(), cornell_tiny::settings(), shots);
}

TEST(Refused, EverySingleFlippedBit) {
  for (const int shots : {kSome, kAll}) {
    Rgb pair = rgb_pair(shots);
    for (std::size_t bit = 0; bit < 8 * pair.blob.bytes.size(); ++bit) {
      Blob flipped = pair.blob;
      flipped.bytes[bit / 8] = static_cast<std::uint8_t>(flipped.bytes[bit / 8] ^ 1u << bit % 8);
      const SaveStatus why = pair.offer(flipped);
      const bool is_magic = bit < 32, is_length = bit >= 32 && bit < 64;
      ASSERT_TRUE(is_magic ? why == SaveStatus::not_a_state
                           : why == SaveStatus::damaged || (is_length && why == SaveStatus::truncated))
          << "bit " << bit << ": " << static_cast<int>(why);
    }
    EXPECT_EQ(saved(pair.other->state(), pair.identity).bytes, pair.before.bytes);
    EXPECT_EQ(pair.offer(pair.blob), SaveStatus::ok);
  }
}

TEST(Refused, EveryTruncation) {
  for (const int shots : {kSome, kAll}) {
    Rgb pair = rgb_pair(shots);
    for (std::size_t count = 0; count < pair.blob.bytes.size(); ++count) {
      Blob cut = {{pair.blob.bytes.begin(), pair.blob.bytes.begin() + static_cast<std::ptrdiff_t>(count)}};
      ASSERT_EQ(pair.offer(cut), SaveStatus::truncated) << count;
    }
    EXPECT_EQ(saved(pair.other->state(), pair.identity).bytes, pair.before.bytes);
  }
}

TEST(Refused, ErasedAndForeignMemory) {
  Grey pair = grey_pair(kSome);
  for (const int byte : {0x00, 0xff, 0xa5}) {
    Blob erased = {std::vector<std::uint8_t>(4096, static_cast<std::uint8_t>(byte))};
    pair.expect_refused(erased, SaveStatus::not_a_state);
  }
}

TEST(Refused, LengthsThatHoldNoState) {
  Grey pair = grey_pair(kSome);
  for (const std::uint32_t length : {0u, 4u, 8u, 13u}) {
    Blob blob = pair.blob;
    blob.set_number(kLength, 4, length);
    pair.expect_refused(blob, SaveStatus::damaged);
  }
}

TEST(Refused, OtherVersionsByTheirAge) {
  Grey pair = grey_pair(kSome);
  const std::pair<std::uint16_t, SaveStatus> versions[] = {{0, SaveStatus::older_version},
                                                           {kStateVersion + 1, SaveStatus::newer_version},
                                                           {0xffff, SaveStatus::newer_version}};
  for (const auto& [version, why] : versions) {
    Blob blob = pair.blob;
    blob.set_number(kVersion, 2, version);
    blob.seal();
    pair.expect_refused(blob, why);
    blob.bytes.resize(14);  // another version may be of any length
    blob.set_number(kLength, 4, 14);
    blob.seal();
    pair.expect_refused(blob, why);
  }
}

TEST(Refused, AnotherScene) {
  Rgb pair = rgb_pair(kSome);
  const auto box = std::make_unique<closed_box_tiny::Solver>();
  ASSERT_EQ(box->load(closed_box_tiny::scene(), cornell_tiny::settings()), Status::ok);
  Blob blob = saved(box->state(), box->identify());
  pair.expect_refused(blob, SaveStatus::foreign_scene);
}

// One number of one table is another: each kind of record in turn.
TEST(Refused, ASceneInWhichOneNumberIsAnother) {
  using Change = std::function<void(DeviceScene&)>;
  const Change changes[] = {
      [](DeviceScene& s) { s.materials[0].reflectance[0] ^= 1; },
      [](DeviceScene& s) { s.materials[1].emission[0] ^= 1; },
      [](DeviceScene& s) { s.vertices[5].y = static_cast<std::int16_t>(s.vertices[5].y - 1); },
      [](DeviceScene& s) { s.faces[2].axis_v[0] ^= 1; },
      [](DeviceScene& s) { s.faces[3].cell_area ^= 1; },
      [](DeviceScene& s) { s.faces[1].is_sealed ^= 1; },
      [](DeviceScene& s) { s.elements[7].area ^= 1; },
      [](DeviceScene& s) { s.elements[7].eye[1] ^= 1; },
      [](DeviceScene& s) { s.sights.assign(s.elements.size(), Sight::centroid_clear); },
      [](DeviceScene& s) { std::swap(s.patch_elements[0], s.patch_elements[1]); },
      [](DeviceScene& s) { ++s.emission_shift; },
      [](DeviceScene& s) { --s.radiosity_shift; }};
  const SolveOptions options;
  Solution original(random_closed_room(1), options);
  const Identity identity = identify(original.state());
  for (const Change& change : changes) {
    DeviceScene device = original.device();
    change(device);
    SimulatedDevice solver(sizes_for(device, 0, options.settings));
    const Status status = solver.load(device.view(), options.settings);
    ASSERT_EQ(status, Status::ok) << describe(status);
    const Identity other = identify(solver.state());
    EXPECT_NE(other.scene, identity.scene) << "change " << &change - changes;
    Blob blob = saved(original.state(), identity);
    EXPECT_EQ(load_state(solver.state(), other, blob.source()), SaveStatus::foreign_scene);
  }
}

TEST(Refused, OtherSettings) {
  using Change = std::function<void(Settings&)>;
  const Change changes[] = {[](Settings& s) { s.stop.raw ^= 1; },
                            [](Settings& s) { s.flux_per_row.raw ^= 1; },
                            [](Settings& s) { s.flux_per_eye.raw ^= 1; },
                            [](Settings& s) { s.overshoot = !s.overshoot; },
                            [](Settings& s) { --s.table_count; },
                            [](Settings& s) { s.tables = kLunes + 1; },
                            [](Settings& s) { s.probe = kLunes + 1; },
                            [](Settings& s) { s.probe = &kDelta8; },
                            [](Settings& s) { s.near_field = correct_near_field; },
                            [](Settings& s) { s.engine = ray_row; },
                            [](Settings& s) { s.engine = contour_row; },
                            [](Settings& s) {
                              s.engine = hemicube_rows;
                              s.tables = &kDelta16;
                              s.table_count = 1;
                            }};
  Grey pair = grey_pair(kSome);
  for (const Change& change : changes) {
    Settings settings = plain_settings();
    change(settings);
    ASSERT_EQ(pair.other->load(cornell_grey_tiny::scene(), settings), Status::ok);
    const Identity other = pair.other->identify();
    EXPECT_EQ(other.scene, pair.identity.scene);
    EXPECT_EQ(pair.other->resume(other, pair.blob.source()), SaveStatus::foreign_settings)
        << "change " << &change - changes;
  }
}

// Rows and pixels of one hemicube table have the same numbers everywhere in the settings.
TEST(Refused, AnotherEngineWithTheSameTables) {
  Settings settings = plain_settings();
  settings.tables = settings.probe = &kDelta16;
  settings.table_count = 1;
  const auto solver = std::make_unique<Solver<Limits<40, 30, 300, 90, 1, 16>>>();
  std::vector<std::uint64_t> known;
  for (const Engine engine : {hemicube_rows, hemicube_pixels}) {
    settings.engine = engine;
    ASSERT_EQ(solver->load(cornell_grey_tiny::scene(), settings), Status::ok);
    known.push_back(solver->identify().settings);
  }
  EXPECT_NE(known[0], known[1]);
}

TEST(Refused, ASceneWhoseElementsHaveBeenSplit) {
  const SolveOptions options;
  Solution s(random_closed_room(1), options);
  const Identity identity = identify(s.state());
  Blob blob = saved(s.state(), identity);
  ++s.state().scene.element_count;
  Blob none;
  EXPECT_EQ(save_state(s.state(), identity, none.sink(), 0), SaveStatus::refined);
  EXPECT_TRUE(none.bytes.empty());
  EXPECT_EQ(load_state(s.state(), identity, blob.source()), SaveStatus::refined);
}

// A right checksum does not make a state possible.
template <class Solver>
void expect_inconsistent(Pair<Solver>& pair, std::size_t offset, std::size_t count, std::uint64_t value) {
  Blob blob = pair.blob;
  ASSERT_NE(blob.number(offset, count), value) << offset;
  blob.set_number(offset, count, value);
  blob.seal();
  SCOPED_TRACE(offset);
  pair.expect_refused(blob, SaveStatus::inconsistent);
}

TEST(Refused, NumbersOutOfRangeUnderARightChecksum) {
  for (const int shots : {kSome, kAll}) {
    Grey pair = grey_pair(shots);
    const Scene& scene = pair.saver->state().scene;
    for (const std::uint64_t channels : {0u, 2u, 3u, 4u, 255u}) {
      expect_inconsistent(pair, kChannels, 1, channels);
    }
    expect_inconsistent(pair, kKind, 1, 3);
    expect_inconsistent(pair, kElements, 2, 0xffff);
    expect_inconsistent(pair, kNextEmitter, 2, scene.element_count + 1u);
    expect_inconsistent(pair, kNextEmitter, 2, scene.element_count - 1u);
    expect_inconsistent(pair, kCursor, 2, 0xffff);
    expect_inconsistent(pair, kCursor, 2, scene.element_count + 1u);
    expect_inconsistent(pair, kTurn, 1, kTurns);
    for (const std::uint64_t flags : {2u, 4u, 0x80u}) {
      expect_inconsistent(pair, kFlags, 1, flags);
    }
    if (shots == kSome) {  // in the middle of a pass
      expect_inconsistent(pair, kFlags, 1, 3);
    }
    expect_inconsistent(pair, kThreshold, 8, ~std::uint64_t{0});
    expect_inconsistent(pair, kAmbient, 4, 1);
    expect_inconsistent(pair, kEmitted, 4, 0);
    for (const std::size_t sum : {kEmitted, kEscaped, kBack, kAbsorbed, kUnshot}) {
      expect_inconsistent(pair, sum, 4, pair.blob.number(sum, 4) + 1);
    }
    expect_inconsistent(pair, kEscaped, 4, 0xffffffff);
    expect_inconsistent(pair, kBack, 4, 0x80000000);
  }
}

// What an element has received and sent, its bytes from `offset` on.
struct SavedElement {
  std::size_t offset;
  std::int64_t received, sent;
};

SavedElement element_of(const Blob& blob, std::size_t e, bool faces_shoot) {
  const std::size_t offset = kFirstChannel + kChannelBytes + e * (faces_shoot ? 4 : 6);
  return {offset, static_cast<std::int32_t>(blob.number(offset, 4)),
          faces_shoot
              ? 0
              : static_cast<std::int64_t>(long_flux(static_cast<std::uint16_t>(blob.number(offset + 4, 2))))};
}

TEST(Refused, ElementsThatHoldWhatNoneCan) {
  Grey pair = grey_pair(kSome);
  std::size_t e = 0;
  while (element_of(pair.blob, e, false).sent == 0) {
    ++e;
  }
  const SavedElement element = element_of(pair.blob, e, false);
  expect_inconsistent(pair, element.offset, 4, 0x80000000);
  expect_inconsistent(pair, element.offset, 4, 0x7fffffff);
  expect_inconsistent(pair, element.offset, 4, static_cast<std::uint64_t>(-element.received));
  expect_inconsistent(pair, element.offset, 4, static_cast<std::uint64_t>(element.received + 1));
  expect_inconsistent(pair, element.offset, 4, 0);
  expect_inconsistent(pair, element.offset + 4, 2, 0xffff);
  expect_inconsistent(pair, element.offset + 4, 2, 0xa800);
  expect_inconsistent(pair, element.offset + 4, 2, pair.blob.number(element.offset + 4, 2) + 1);
  expect_inconsistent(pair, element.offset + 4, 2, 0);
}

// All sums right, but one part of the ledger is made of what another has less than nothing of.
TEST(Refused, LightThatIsBorrowedWithoutOvershooting) {
  Grey pair = grey_pair(kSome);
  Blob blob = pair.blob;
  const std::uint64_t escaped = blob.number(kEscaped, 4), back = blob.number(kBack, 4);
  blob.set_number(kEscaped, 4, escaped + back + 1);
  blob.set_number(kBack, 4, 0xffffffff);
  blob.seal();
  pair.expect_refused(blob, SaveStatus::inconsistent);
  blob.set_number(kEscaped, 4, escaped + back);
  blob.set_number(kBack, 4, 0);
  blob.seal();
  EXPECT_EQ(pair.offer(blob), SaveStatus::ok) << "the same with nothing borrowed is a state";
}

TEST(Refused, FacesThatHoldWhatNoneCan) {
  Grey pair = grey_pair(kAll);
  const Scene& scene = pair.saver->state().scene;
  const std::size_t faces = kFirstChannel + kChannelBytes + 4 * std::size_t{scene.element_count};
  for (std::size_t f = 0; f < scene.face_count; ++f) {
    expect_inconsistent(pair, faces + 4 * f, 4, pair.blob.number(faces + 4 * f, 4) + 1);
    expect_inconsistent(pair, faces + 4 * f, 4, 0x80000000);
  }
}

TEST(Refused, ACursorAmidTheElementsOfAFace) {
  Grey pair = grey_pair(kAll);
  const Scene& scene = pair.saver->state().scene;
  for (std::uint16_t e = 0; e <= scene.element_count; ++e) {
    const bool is_first = e == 0 || e == scene.element_count ||
                          flash_read(scene.elements, e).face != flash_read(scene.elements, e - 1u).face;
    Blob blob = pair.blob;
    blob.set_number(kCursor, 2, e);
    blob.seal();
    EXPECT_EQ(pair.offer(blob), is_first ? SaveStatus::ok : SaveStatus::inconsistent) << e;
  }
}

// Before all emission is sent no pass has begun.
TEST(Refused, APassBeforeTheLampsHaveShot) {
  Grey pair = grey_pair(1);
  ASSERT_LT(pair.saver->state().next_emitter, pair.saver->state().scene.element_count);
  expect_inconsistent(pair, kKind, 1, 1);
  expect_inconsistent(pair, kCursor, 2, 0);
  expect_inconsistent(pair, kFlags, 1, 0);
  expect_inconsistent(pair, kThreshold, 8, 1);
}

// A state that overshoots may hold borrowed light, but no more than a flux holds.
TEST(Refused, MoreBorrowedLightThanFits) {
  Rgb pair = rgb_pair(kSome);
  expect_inconsistent(pair, kEscaped, 4, 0x80000000);
  expect_inconsistent(pair, kFirstChannel + 3 * kChannelBytes, 4, 0x80000000);
}

// Its bytes change between two readings: one bit, from reading `from` on.
struct Fickle {
  Blob blob;
  int readings = 0, from = 0;

  StateSource source() {
    return {this, [](void* context, std::uint32_t offset, std::uint8_t* to, std::uint8_t count) {
              auto& fickle = *static_cast<Fickle*>(context);
              fickle.readings += offset == 0 ? 1 : 0;
              const StateSource steady = fickle.blob.source();
              const bool is_read = steady.read(steady.context, offset, to, count);
              if (fickle.readings >= fickle.from && offset <= 120 && 120u < offset + count) {
                to[120 - offset] = static_cast<std::uint8_t>(to[120 - offset] ^ 0x80u);
              }
              return is_read;
            }};
  }
};

TEST(Refused, ASourceThatSaysSomethingElseTheSecondTime) {
  Grey pair = grey_pair(kSome);
  const auto fresh = std::make_unique<cornell_grey_tiny::Solver>();
  ASSERT_EQ(fresh->load(cornell_grey_tiny::scene(), plain_settings()), Status::ok);
  Fickle second = {pair.blob, 0, 2};
  EXPECT_NE(pair.other->resume(pair.identity, second.source()), SaveStatus::ok);
  EXPECT_EQ(saved(pair.other->state(), pair.identity).bytes, pair.before.bytes);
  Fickle third = {pair.blob, 0, 3};
  EXPECT_EQ(pair.other->resume(pair.identity, third.source()), SaveStatus::damaged);
  EXPECT_EQ(saved(pair.other->state(), pair.identity).bytes, saved(fresh->state(), pair.identity).bytes)
      << "a state that was checked but not read starts anew";
  Fickle never = {pair.blob, 0, 4};
  EXPECT_EQ(pair.other->resume(pair.identity, never.source()), SaveStatus::ok);
}

}  // namespace
}  // namespace fixrad::host
