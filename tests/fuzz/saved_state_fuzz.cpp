// SPDX-License-Identifier: MIT
// Any bytes as a saved state: they are refused and the solver is as before, or the solver is in a state that
// it saves as the same bytes and goes on from with its ledger balanced. The first byte says how far the
// others are helped along: as they are, with a right checksum, also with the right identity, also with sums
// that add up.
//
// A seed is that byte and a state of `fixrad bake scenes/closed_box.obj --profile tiny --shots N --save FILE`
// (with --no-overshoot for plain shooting), or of scenes/cornell.obj as scripts/export_scenes.sh exports it.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "firmware/scenes/closed_box_tiny.h"
#include "firmware/scenes/cornell_tiny.h"
#include "lib/fixed/short_flux.h"
#include "lib/save/checksum.h"

namespace {

using namespace fixrad;

enum Mode : unsigned {
  kSealed = 1,
  kIdentified = 2,
  kSummed = 4,
  kOvershooting = 8,
  kCornell = 16,
  kConfined = 32
};

constexpr int kShots = 6;

using Bytes = std::vector<std::uint8_t>;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

bool append(void* context, const std::uint8_t* from, std::uint8_t count) {
  Bytes& bytes = *static_cast<Bytes*>(context);
  bytes.insert(bytes.end(), from, from + count);
  return true;
}

bool read(void* context, std::uint32_t offset, std::uint8_t* to, std::uint8_t count) {
  const Bytes& bytes = *static_cast<Bytes*>(context);
  if (offset > bytes.size() || bytes.size() - offset < count) {
    return false;
  }
  std::memcpy(to, bytes.data() + offset, count);
  return true;
}

Bytes saved(const State& state, const Identity& identity, std::uint32_t sequence = 0) {
  Bytes bytes;
  require(save_state(state, identity, {&bytes, append}, sequence) == SaveStatus::ok);
  return bytes;
}

std::uint64_t number(const Bytes& bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) {
    value = value << 8 | (at + i < bytes.size() ? bytes[at + i] : 0u);
  }
  return value;
}

void put(Bytes& bytes, std::size_t at, std::size_t count, std::uint64_t value) {
  for (std::size_t i = 0; i < count && at + i < bytes.size(); ++i, value >>= 8) {
    bytes[at + i] = static_cast<std::uint8_t>(value);
  }
}

// A solver and how it was right after load().
template <class Solver>
struct Loaded {
  Loaded(const Scene& scene, Settings settings, bool overshoot) {
    settings.overshoot = overshoot;
    require(solver->load(scene, settings) == Status::ok);
    identity = solver->identify();
    start = saved(solver->state(), identity);
  }

  std::unique_ptr<Solver> solver = std::make_unique<Solver>();
  Identity identity = {};
  Bytes start;
};

// Magic, version, counts, identity and length as they must be; a byte of its own says who shoots.
void identify_bytes(const State& state, const Bytes& start, Bytes& bytes) {
  bytes.resize(bytes.size() < 68 ? 68 : bytes.size());
  const std::uint64_t kind = bytes[11] % 3u;
  const Scene& scene = state.scene;
  bytes.resize(saved_bytes(scene.element_count, scene.face_count, scene.channels, kind == 2));
  std::memcpy(bytes.data(), start.data(), 11);
  std::memcpy(bytes.data() + 12, start.data() + 12, 4);
  std::memcpy(bytes.data() + 20, start.data() + 20, 16);
  put(bytes, 4, 4, bytes.size());
  bytes[11] = static_cast<std::uint8_t>(kind);
}

// What of the emitted flux of channel `c` the emitters from `next` on have still to send.
std::int64_t pending(const State& state, int c, std::uint64_t next) {
  std::int64_t sum = 0;
  for (std::uint64_t e = next; e < state.scene.element_count; ++e) {
    const Element& element = state.scene.elements[e];
    sum += emitted_flux(state.scene, state.scene.materials[element.material], element.area, c).raw;
  }
  return sum;
}

// Cuts what channel `c` of `bytes` holds until no part of its ledger is negative: elements and faces share
// what lamps have sent, none has sent more than it reflects, nothing has escaped.
void confine_channel(const State& state, int c, Bytes& bytes) {
  const Scene& scene = state.scene;
  const std::size_t channels = scene.channels, channel = static_cast<std::size_t>(c);
  const bool has_faces = bytes[11] == 2;
  const std::size_t step = has_faces ? 4 : 6, body = 68 + 32 * channels;
  const auto sent_in_all =
      static_cast<std::uint64_t>(state.emitted[c] - pending(state, c, number(bytes, 54, 2)));
  const std::uint64_t most = sent_in_all / (2u * scene.element_count) + 1;
  for (std::size_t e = 0; e < scene.element_count; ++e) {
    const std::size_t at = body + step * (e * channels + channel);
    const std::uint64_t received = sent_in_all == 0 ? 0 : number(bytes, at, 4) % most;
    put(bytes, at, 4, received);
    const Material& material = scene.materials[scene.elements[e].material];
    const std::int32_t reflected = reflect(Reflectance::from_raw(material.reflectance[c]),
                                           Flux::from_raw(static_cast<std::int32_t>(received)))
                                       .raw;
    if (!has_faces) {
      const std::uint32_t sent = long_flux(static_cast<std::uint16_t>(number(bytes, at + 4, 2) % 0xa800u));
      put(bytes, at + 4, 2, short_flux(sent % (static_cast<std::uint32_t>(reflected) + 1)));
    }
  }
  for (std::size_t f = 0; has_faces && f < scene.face_count; ++f) {
    const std::size_t at = body + 4 * channels * scene.element_count + 4 * (f * channels + channel);
    put(bytes, at, 4, number(bytes, at, 4) % (sent_in_all / (2u * scene.face_count) + 1));
  }
  put(bytes, 68 + 32 * channel, 4, 0);
  put(bytes, 68 + 32 * channel + 8, 4, 0);
}

// What channel `c` has emitted, absorbed and not yet shot as the elements and faces in `bytes` say; what is
// missing from the ledger has met backs.
void sum_channel(const State& state, int c, Bytes& bytes) {
  const Scene& scene = state.scene;
  const std::size_t channels = scene.channels, channel = 68 + 32 * static_cast<std::size_t>(c);
  const bool has_faces = bytes[11] == 2;
  const std::size_t step = has_faces ? 4 : 6, body = 68 + 32 * channels;
  std::int64_t absorbed = 0, balance = 0;
  std::uint64_t unshot = 0;
  const auto add = [&](std::int64_t flux) {
    balance += flux;
    unshot += static_cast<std::uint64_t>(flux < 0 ? -flux : flux);
  };
  for (std::uint16_t e = 0; e < scene.element_count; ++e) {
    const std::size_t at = body + step * (e * channels + static_cast<std::size_t>(c));
    const auto received = static_cast<std::int32_t>(number(bytes, at, 4));
    const Material& material = scene.materials[scene.elements[e].material];
    const std::int32_t reflected =
        reflect(Reflectance::from_raw(material.reflectance[c]), Flux::from_raw(received)).raw;
    absorbed += std::int64_t{received} - reflected;
    if (!has_faces) {
      add(std::int64_t{reflected} - long_flux(static_cast<std::uint16_t>(number(bytes, at + 4, 2))));
    }
    if (e >= number(bytes, 54, 2)) {
      add(emitted_flux(scene, material, scene.elements[e].area, c).raw);
    }
  }
  for (std::size_t f = 0; has_faces && f < scene.face_count; ++f) {
    const std::size_t at = body + 4 * (scene.element_count * channels + f * channels);
    add(static_cast<std::int32_t>(number(bytes, at + 4 * static_cast<std::size_t>(c), 4)));
  }
  const std::int32_t emitted = state.emitted[c];
  const auto escaped = static_cast<std::int32_t>(number(bytes, channel + 8, 4));
  put(bytes, channel + 4, 4, static_cast<std::uint64_t>(emitted));
  put(bytes, channel + 12, 4, static_cast<std::uint64_t>(emitted - absorbed - balance - escaped));
  put(bytes, channel + 16, 8, static_cast<std::uint64_t>(absorbed));
  put(bytes, channel + 24, 8, unshot);
}

void seal(Bytes& bytes) {
  if (bytes.size() < kChecksumBytes) {
    return;
  }
  Checksum sum;
  for (std::size_t i = 0; i + kChecksumBytes < bytes.size(); ++i) {
    sum.add(bytes[i]);
  }
  put(bytes, bytes.size() - kChecksumBytes, kChecksumBytes, sum.value());
}

void require_balance(const State& state) {
  for (int c = 0; c < state.scene.channels; ++c) {
    require(ledger(state, c).imbalance() == 0);
  }
}

template <class Solver>
void offer(Loaded<Solver>& loaded, unsigned mode, Bytes bytes) {
  State& state = loaded.solver->state();
  if ((mode & kIdentified) != 0) {
    identify_bytes(state, loaded.start, bytes);
  }
  for (int c = 0; c < state.scene.channels && (mode & kSummed) != 0 && (mode & kIdentified) != 0; ++c) {
    if ((mode & kConfined) != 0) {
      confine_channel(state, c, bytes);
    }
    sum_channel(state, c, bytes);
  }
  if ((mode & kSealed) != 0) {
    seal(bytes);
  }
  if (loaded.solver->resume(loaded.identity, {&bytes, read}) != SaveStatus::ok) {
    require(saved(state, loaded.identity) == loaded.start);
    return;
  }
  const Bytes again = saved(state, loaded.identity, static_cast<std::uint32_t>(number(bytes, 16, 4)));
  require(again.size() <= bytes.size() && std::memcmp(again.data(), bytes.data(), again.size()) == 0);
  require_balance(state);
  // Sums that were made right may be those of a state that lends until a flux overflows (docs/numbers.md),
  // which sanitizers report: such a state takes no further shot.
  const bool may_overflow = (mode & kOvershooting) != 0 && (mode & kSummed) != 0;
  for (int i = 0; i < kShots && !may_overflow && loaded.solver->step() == Status::ok; ++i) {
    require_balance(state);
  }
  require(loaded.solver->resume(loaded.identity, {&loaded.start, read}) == SaveStatus::ok);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Loaded<closed_box_tiny::Solver> box[2] = {
      {closed_box_tiny::scene(), closed_box_tiny::settings(), false},
      {closed_box_tiny::scene(), closed_box_tiny::settings(), true}};
  static Loaded<cornell_tiny::Solver> cornell[2] = {{cornell_tiny::scene(), cornell_tiny::settings(), false},
                                                    {cornell_tiny::scene(), cornell_tiny::settings(), true}};
  if (size == 0) {
    return 0;
  }
  const unsigned mode = data[0];
  const std::size_t which = (mode & kOvershooting) != 0 ? 1 : 0;
  Bytes bytes(data + 1, data + size);
  if ((mode & kCornell) != 0) {
    offer(cornell[which], mode, std::move(bytes));
  } else {
    offer(box[which], mode, std::move(bytes));
  }
  return 0;
}
