// SPDX-License-Identifier: MIT
#include "lib/save/save.h"

#include "lib/fixed/short_flux.h"
#include "lib/save/checksum.h"
#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

class StateWriter {
 public:
  explicit StateWriter(const StateSink& sink) : sink_(sink) {}

  template <class T>
  void field(const T& value) {
    put(static_cast<uint64_t>(value), sizeof(T));
  }

  // Once the sink has refused, nothing more is written.
  __attribute__((noinline)) void put(uint64_t value, uint8_t count) {
    uint8_t bytes[8];
    for (uint8_t i = 0; i < count; ++i) {
      bytes[i] = static_cast<uint8_t>(value);
      checksum_.add(bytes[i]);
      value >>= 8;
    }
    is_written_ = is_written_ && sink_.write(sink_.context, bytes, count);
  }

  uint32_t checksum() const { return checksum_.value(); }
  bool is_written() const { return is_written_; }

 private:
  const StateSink& sink_;
  Checksum checksum_;
  bool is_written_ = true;
};

SavedChannel saved_channel(const State& state, int c) {
  return {state.sweep.ambient[c].raw, state.emitted[c],
          state.escaped[c],           state.back[c],
          ledger(state, c).absorbed,  sum_unshot(state, c).magnitude};
}

SavedHeader saved_header(const State& state, const Identity& identity, uint32_t sequence) {
  const Scene& scene = state.scene;
  SavedHeader h = {};
  h.length = saved_bytes(scene.element_count, scene.face_count, scene.channels,
                         state.sweep.kind == SourceKind::face);
  h.version = kStateVersion;
  h.channels = scene.channels;
  h.kind = static_cast<uint8_t>(state.sweep.kind);
  h.elements = scene.element_count;
  h.faces = scene.face_count;
  h.sequence = sequence;
  h.scene = identity.scene;
  h.settings = identity.settings;
  h.shots = state.shots;
  h.eyes = state.eyes;
  h.withdrawn = state.withdrawn;
  h.gaps_closed = state.work.gaps_closed;
  h.spans_used = state.work.span_high_water;
  h.next_emitter = state.next_emitter;
  h.cursor = state.sweep.cursor;
  h.turn = state.turn;
  h.flags = static_cast<uint8_t>((state.sweep.has_shot ? kHasShot : 0) | (state.sweep.grows ? kGrows : 0));
  h.threshold = state.sweep.threshold;
  for (int c = 0; c < scene.channels; ++c) {
    h.channel[c] = saved_channel(state, c);
  }
  return h;
}

// Not inlined: the header is not to lie on the stack while the body is written.
__attribute__((noinline)) void write_header(const State& state, const Identity& identity, uint32_t sequence,
                                            StateWriter& writer) {
  const SavedHeader header = saved_header(state, identity, sequence);
  writer.field(kStateMagic);
  writer.field(header.length);
  header_fields(writer, header);
}

void write_body(const State& state, StateWriter& writer) {
  const Scene& scene = state.scene;
  const bool faces_shoot = state.sweep.kind == SourceKind::face;
  const int32_t* received = state.received;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    for (int c = 0; c < scene.channels; ++c) {
      writer.field(*received++);
      if (!faces_shoot) {
        writer.field(short_flux(sent_flux(state, e, c)));
      }
    }
  }
  for (uint16_t f = 0; faces_shoot && f < scene.face_count; ++f) {
    for (int c = 0; c < scene.channels; ++c) {
      writer.field(face_unshot(state, f, c).raw);
    }
  }
}

}  // namespace

SaveStatus save_state(const State& state, const Identity& identity, const StateSink& sink,
                      uint32_t sequence) {
  if (state.scene.element_count != identity.elements) {
    return SaveStatus::refined;
  }
  StateWriter writer(sink);
  write_header(state, identity, sequence, writer);
  write_body(state, writer);
  writer.field(writer.checksum());
  return writer.is_written() ? SaveStatus::ok : SaveStatus::write_failed;
}

}  // namespace fixrad
