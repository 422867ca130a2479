// SPDX-License-Identifier: MIT
#include "lib/save/resume.h"

#include "lib/fixed/short_flux.h"
#include "lib/save/checksum.h"
#include "lib/transport/shooting.h"
#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

class StateReader {
 public:
  explicit StateReader(const StateSource& source) : source_(source) {}

  template <class T>
  void field(T& value) {
    value = static_cast<T>(get(sizeof(T)));
  }

  // The next `count` (1 .. 8) bytes as a number; 0 once the source has ended.
  __attribute__((noinline)) uint64_t get(uint8_t count) {
    uint8_t bytes[8];
    is_read_ = is_read_ && source_.read(source_.context, offset_, bytes, count);
    if (!is_read_) {
      return 0;
    }
    offset_ += count;
    uint64_t value = 0;
    for (uint8_t i = 0; i < count; ++i) {
      checksum_.add(bytes[i]);
    }
    for (uint8_t i = count; i > 0; --i) {
      value = value << 8 | bytes[i - 1];
    }
    return value;
  }

  // Whether the source's next four bytes are the checksum of all that has been read.
  bool ends_well() {
    const uint32_t sum = checksum_.value();
    return get(kChecksumBytes) == sum && is_read_;
  }

  uint32_t offset() const { return offset_; }
  bool is_read() const { return is_read_; }
  uint32_t checksum() const { return checksum_.value(); }

 private:
  const StateSource& source_;
  Checksum checksum_;
  uint32_t offset_ = 0;
  bool is_read_ = true;
};

// What every version begins and ends with: magic, length, version; the checksum of `length` - 4 bytes.
constexpr uint32_t kFixedBytes = 10;

SaveStatus check_whole(const StateSource& source) {
  StateReader reader(source);
  const uint64_t magic = reader.get(4);
  if (reader.is_read() && magic != kStateMagic) {
    return SaveStatus::not_a_state;
  }
  const uint32_t length = static_cast<uint32_t>(reader.get(4));
  if (reader.is_read() && length < kFixedBytes + kChecksumBytes) {
    return SaveStatus::damaged;
  }
  while (reader.is_read() && reader.offset() < length - kChecksumBytes) {
    const uint32_t left = length - kChecksumBytes - reader.offset();
    reader.get(static_cast<uint8_t>(left < 8 ? left : 8));
  }
  const bool ends_well = reader.ends_well();
  return !reader.is_read() ? SaveStatus::truncated : ends_well ? SaveStatus::ok : SaveStatus::damaged;
}

SaveStatus read_fields(StateReader& reader, SavedHeader& header) {
  header = {};
  reader.get(4);
  reader.field(header.length);
  header_fields(reader, header);
  if (header.version != kStateVersion) {
    return header.version < kStateVersion ? SaveStatus::older_version : SaveStatus::newer_version;
  }
  const bool is_known = header.channels >= 1 && header.channels <= kMaxChannels &&
                        header.kind <= static_cast<uint8_t>(SourceKind::face);
  return is_known && header.length == saved_bytes(header.elements, header.faces, header.channels,
                                                  header.kind == static_cast<uint8_t>(SourceKind::face))
             ? SaveStatus::ok
             : SaveStatus::inconsistent;
}

bool faces_shoot(const SavedHeader& header) {
  return header.kind == static_cast<uint8_t>(SourceKind::face);
}

// The elements of a face shoot together, so the cursor is at a first one. There are no more patches than
// elements: element_count is behind the last source of any kind.
bool is_at_a_source(const State& state, const SavedHeader& h) {
  const Scene& scene = state.scene;
  if (h.cursor == 0 || h.cursor == scene.element_count) {
    return true;
  }
  if (h.kind == static_cast<uint8_t>(SourceKind::patch)) {
    return h.cursor <= scene.patch_count;
  }
  if (!faces_shoot(h) || h.cursor > scene.element_count) {
    return h.cursor < scene.element_count;
  }
  return flash_at(scene.elements, h.cursor).face != flash_at(scene.elements, h.cursor - 1u).face;
}

// Passes begin once all emission is sent.
bool is_before_passes(const State& state, const SavedHeader& h) {
  return h.kind == static_cast<uint8_t>(SourceKind::element) && h.cursor == state.scene.element_count &&
         h.flags == kHasShot && h.threshold == 0;
}

// A pass that has turned to larger sources is still to start.
bool are_possible_flags(const State& state, const SavedHeader& h) {
  return h.flags <= kHasShot || (h.flags == (kHasShot | kGrows) && h.cursor == state.scene.element_count &&
                                 h.kind != static_cast<uint8_t>(SourceKind::element));
}

// A threshold is at most the magnitudes of three channels, or 4 rows' worth.
constexpr uint64_t kMostThreshold = static_cast<uint64_t>(1) << 37;

bool is_possible_sweep(const State& state, const SavedHeader& h) {
  return h.next_emitter <= state.scene.element_count &&
         (h.next_emitter == state.scene.element_count || is_before_passes(state, h)) &&
         is_at_a_source(state, h) && are_possible_flags(state, h) && h.turn < kTurns &&
         h.threshold <= kMostThreshold;
}

// With overshooting, light that was lent and is taken back may leave where less has left before.
constexpr uint32_t kMostLentBack = static_cast<uint32_t>(1) << 30;

bool is_possible_loss(const State& state, int32_t flux) {
  return state.settings.overshoot ? magnitude(flux) <= kMostLentBack : flux >= 0;
}

bool is_possible_channel(const State& state, const SavedHeader& h, int c) {
  const SavedChannel& saved = h.channel[c];
  const bool may_lend = state.settings.overshoot && h.next_emitter == state.scene.element_count;
  return saved.emitted == state.emitted[c] && (may_lend || saved.ambient == 0) &&
         is_possible_loss(state, saved.escaped) && is_possible_loss(state, saved.back);
}

// Sums of what elements and faces hold, one channel.
struct Tally {
  int64_t absorbed, balance;
  uint64_t received, unshot;  // magnitudes
};

void add_unshot(Tally& tally, int64_t unshot) {
  tally.balance += unshot;
  tally.unshot += static_cast<uint64_t>(unshot < 0 ? -unshot : unshot);
}

// The largest short flux.
constexpr uint16_t kMostSent = (20u << kShortFluxBits) | ((1u << kShortFluxBits) - 1u);

// A source sends at most twice what it has to send, and sums over sources are fluxes too.
constexpr uint64_t kMostUnshot = static_cast<uint64_t>(1) << 30;
constexpr uint64_t kMostFlux = 0x7fffffffu;

bool is_possible_unshot(const State& state, int64_t unshot) {
  return unshot < static_cast<int64_t>(kMostUnshot) &&
         (state.settings.overshoot ? -unshot < static_cast<int64_t>(kMostUnshot) : unshot >= 0);
}

bool check_element(const State& state, const SavedHeader& h, uint16_t e, StateReader& reader, Tally* tally) {
  const Element element = flash_read(state.scene.elements, e);
  const Material material = flash_read(state.scene.materials, element.material);
  bool is_possible = true;
  for (int c = 0; c < state.scene.channels; ++c) {
    int32_t received = 0;
    reader.field(received);
    is_possible = is_possible && (state.settings.overshoot || received >= 0);
    const int32_t reflected =
        reflect(Reflectance::from_raw(material.reflectance[c]), Flux::from_raw(received)).raw;
    tally[c].received += magnitude(received);
    tally[c].absorbed += static_cast<int64_t>(received) - reflected;
    if (!faces_shoot(h)) {
      uint16_t sent = 0;
      reader.field(sent);
      const int64_t unshot = static_cast<int64_t>(reflected) - static_cast<int64_t>(long_flux(sent));
      add_unshot(tally[c], unshot);
      is_possible = is_possible && sent <= kMostSent && is_possible_unshot(state, unshot);
    }
    if (e >= h.next_emitter) {
      add_unshot(tally[c], emitted_flux(state.scene, material, element.area, c).raw);
    }
  }
  return is_possible;
}

bool check_faces(const State& state, StateReader& reader, Tally* tally) {
  bool is_possible = true;
  for (uint16_t f = 0; f < state.scene.face_count; ++f) {
    for (int c = 0; c < state.scene.channels; ++c) {
      int32_t unshot = 0;
      reader.field(unshot);
      add_unshot(tally[c], unshot);
      is_possible = is_possible && is_possible_unshot(state, unshot);
    }
  }
  return is_possible;
}

bool adds_up(const SavedChannel& saved, const Tally& tally) {
  return tally.received <= kMostFlux && tally.unshot <= kMostFlux && tally.absorbed == saved.absorbed &&
         tally.unshot == saved.unshot &&
         saved.emitted == tally.absorbed + tally.balance + saved.escaped + saved.back;
}

// Not inlined: the tallies are not to lie under the header's on the stack.
__attribute__((noinline)) bool check_body(const State& state, const SavedHeader& h, StateReader& reader) {
  Tally tally[kMaxChannels] = {};
  bool is_possible = true;
  for (uint16_t e = 0; e < state.scene.element_count; ++e) {
    is_possible = check_element(state, h, e, reader, tally) && is_possible;
  }
  if (faces_shoot(h)) {
    is_possible = check_faces(state, reader, tally) && is_possible;
  }
  for (int c = 0; c < state.scene.channels; ++c) {
    is_possible = is_possible && adds_up(h.channel[c], tally[c]);
  }
  return is_possible;
}

SaveStatus check_origin(const State& state, const Identity& identity, const SavedHeader& h) {
  const Scene& scene = state.scene;
  if (scene.element_count != identity.elements) {
    return SaveStatus::refined;
  }
  if (h.scene != identity.scene || h.elements != scene.element_count || h.faces != scene.face_count ||
      h.channels != scene.channels) {
    return SaveStatus::foreign_scene;
  }
  return h.settings == identity.settings ? SaveStatus::ok : SaveStatus::foreign_settings;
}

bool is_possible_header(const State& state, const SavedHeader& h) {
  bool is_possible = is_possible_sweep(state, h);
  for (int c = 0; c < state.scene.channels; ++c) {
    is_possible = is_possible && is_possible_channel(state, h, c);
  }
  return is_possible;
}

void take_header(State& state, const SavedHeader& h) {
  abandon_shot(state);
  state.shots = h.shots;
  state.eyes = h.eyes;
  state.withdrawn = h.withdrawn;
  state.work.gaps_closed = h.gaps_closed;
  state.work.span_high_water = h.spans_used;
  state.turn = h.turn;
  state.next_emitter = h.next_emitter;
  state.sweep.kind = static_cast<SourceKind>(h.kind);
  state.sweep.cursor = h.cursor;
  state.sweep.has_shot = (h.flags & kHasShot) != 0;
  state.sweep.grows = (h.flags & kGrows) != 0;
  state.sweep.threshold = h.threshold;
  for (int c = 0; c < state.scene.channels; ++c) {
    state.sweep.ambient[c] = Radiosity::from_raw(h.channel[c].ambient);
    state.escaped[c] = h.channel[c].escaped;
    state.back[c] = h.channel[c].back;
  }
}

void take_body(State& state, StateReader& reader) {
  const Scene& scene = state.scene;
  const bool has_faces = state.sweep.kind == SourceKind::face;
  int32_t* received = state.received;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    for (int c = 0; c < scene.channels; ++c) {
      reader.field(*received++);
      if (!has_faces) {
        uint16_t sent = 0;
        reader.field(sent);
        set_sent(state, e, c, sent);
      }
    }
  }
  for (uint16_t f = 0; has_faces && f < scene.face_count; ++f) {
    for (int c = 0; c < scene.channels; ++c) {
      int32_t unshot = 0;
      reader.field(unshot);
      set_face_unshot(state, f, c, Flux::from_raw(unshot));
    }
  }
}

}  // namespace

SaveStatus read_header(const StateSource& source, SavedHeader& header) {
  const SaveStatus status = check_whole(source);
  StateReader reader(source);
  return status == SaveStatus::ok ? read_fields(reader, header) : status;
}

namespace {

// check_saved(), with the checksum of what it has read.
SaveStatus check_saved_as(const State& state, const Identity& identity, const StateSource& source,
                          SavedHeader& header, uint32_t& checksum) {
  SaveStatus status = check_whole(source);
  StateReader reader(source);
  if (status == SaveStatus::ok) {
    status = read_fields(reader, header);
  }
  if (status == SaveStatus::ok) {
    status = check_origin(state, identity, header);
  }
  if (status != SaveStatus::ok) {
    return status;
  }
  const bool is_possible = is_possible_header(state, header) && check_body(state, header, reader);
  checksum = reader.checksum();
  return !is_possible ? SaveStatus::inconsistent : reader.ends_well() ? SaveStatus::ok : SaveStatus::damaged;
}

}  // namespace

SaveStatus check_saved(const State& state, const Identity& identity, const StateSource& source,
                       SavedHeader& header) {
  uint32_t checksum = 0;
  return check_saved_as(state, identity, source, header, checksum);
}

SaveStatus load_state(State& state, const Identity& identity, const StateSource& source) {
  SavedHeader header;
  uint32_t checksum = 0;
  const SaveStatus status = check_saved_as(state, identity, source, header, checksum);
  if (status != SaveStatus::ok) {
    return status;
  }
  StateReader reader(source);
  while (reader.is_read() && reader.offset() < kHeaderBytes + kChannelBytes * header.channels) {
    reader.get(4);
  }
  take_header(state, header);
  take_body(state, reader);
  if (reader.is_read() && reader.checksum() == checksum) {
    return SaveStatus::ok;
  }
  reset(state, state.scene, state.settings);
  return SaveStatus::damaged;
}

}  // namespace fixrad
