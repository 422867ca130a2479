// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/transport/state.h"

namespace fixrad {

// The format of a saved state, docs/saving.md. Numbers of fixed width, least significant byte first, one
// after the other without gaps: the same bytes on every target.

/// Outcome of saving and resuming. Everything but ok leaves the solver as it was.
enum class SaveStatus : uint8_t {
  ok,
  write_failed,      ///< the sink did not take all bytes: what it holds is torn
  refined,           ///< elements have been split since identify(): such a scene is not saved
  not_a_state,       ///< does not begin as a saved state does; erased memory neither
  truncated,         ///< the source ends before the state does
  damaged,           ///< the checksum is wrong: torn while it was written, or bits have changed since
  older_version,     ///< of the format
  newer_version,     ///< of the format
  foreign_scene,     ///< the state of another scene
  foreign_settings,  ///< or of other settings, or of a core that computes other bits
  inconsistent,      ///< the checksum is right, but no solver comes to such a state
};

/// Takes a saved state, in order and a few bytes at a time.
struct StateSink {
  void* context;
  /// Takes `count` (1 .. 8) bytes; false: it cannot.
  bool (*write)(void* context, const uint8_t* bytes, uint8_t count);
};

/// Gives a saved state, as often as it is asked.
struct StateSource {
  void* context;
  /// Gives `count` (1 .. 8) bytes from `offset` on; false: they lie beyond the end. Whatever `offset` is.
  bool (*read)(void* context, uint32_t offset, uint8_t* bytes, uint8_t count);
};

/// "FXRS", as the bytes of the file.
constexpr uint32_t kStateMagic = 0x53525846u;
constexpr uint16_t kStateVersion = 1;

/// What a saved state holds of each channel, in flux units.
struct SavedChannel {
  uint32_t ambient;  ///< Sweep::ambient
  int32_t emitted, escaped, back;
  int64_t absorbed;  ///< of the ledger
  uint64_t unshot;   ///< sum of |unshot| over the shooters, emission included
};

/// The beginning of a saved state. What follows: for every element and channel the received flux, 4 bytes,
/// and unless faces shoot what it has sent on of it as a short flux, 2 bytes; if faces shoot, the unshot flux
/// of every face and channel, 4 bytes; the checksum of all that, 4 bytes.
struct SavedHeader {
  uint32_t length;  ///< of the whole, bytes
  uint16_t version;
  uint8_t channels;
  uint8_t kind;  ///< SourceKind of what shoots
  uint16_t elements, faces;
  uint32_t sequence;         ///< the caller's, see slots.h
  uint64_t scene, settings;  ///< Identity
  uint32_t shots, eyes, withdrawn;
  uint32_t gaps_closed;           ///< as in Workspace
  uint16_t spans_used;            ///< Workspace::span_high_water
  uint16_t next_emitter, cursor;  ///< as in State and Sweep
  uint8_t turn;
  uint8_t flags;  ///< kHasShot, kGrows; the other bits are 0
  uint64_t threshold;
  SavedChannel channel[kMaxChannels];  ///< [channels] are saved
};

/// SavedHeader::flags: Sweep::has_shot, Sweep::grows.
constexpr uint8_t kHasShot = 1, kGrows = 2;

constexpr uint32_t kHeaderBytes = 68, kChannelBytes = 32, kChecksumBytes = 4;

/// Bytes of a saved state.
constexpr uint32_t saved_bytes(uint32_t elements, uint32_t faces, uint32_t channels, bool faces_shoot) {
  return kHeaderBytes + kChecksumBytes +
         channels * (kChannelBytes + (faces_shoot ? 4 * (elements + faces) : 6 * elements));
}

/// Bytes that hold every saved state of a scene.
constexpr uint32_t saved_bytes(uint32_t elements, uint32_t faces, uint32_t channels) {
  return 2 * faces > elements ? saved_bytes(elements, faces, channels, true)
                              : saved_bytes(elements, faces, channels, false);
}

/// All fields of the header behind magic and length, in order; Io writes or reads them.
template <class Io, class Header>
void header_fields(Io& io, Header& h) {
  io.field(h.version);
  io.field(h.channels);
  io.field(h.kind);
  io.field(h.elements);
  io.field(h.faces);
  io.field(h.sequence);
  io.field(h.scene);
  io.field(h.settings);
  io.field(h.shots);
  io.field(h.eyes);
  io.field(h.withdrawn);
  io.field(h.gaps_closed);
  io.field(h.spans_used);
  io.field(h.next_emitter);
  io.field(h.cursor);
  io.field(h.turn);
  io.field(h.flags);
  io.field(h.threshold);
  for (uint8_t c = 0; c < h.channels && c < kMaxChannels; ++c) {
    io.field(h.channel[c].ambient);
    io.field(h.channel[c].emitted);
    io.field(h.channel[c].escaped);
    io.field(h.channel[c].back);
    io.field(h.channel[c].absorbed);
    io.field(h.channel[c].unshot);
  }
}

}  // namespace fixrad
