// SPDX-License-Identifier: MIT
#include "lib/transport/shooting.h"

#include "lib/fixed/cutter.h"
#include "lib/transport/sampling.h"
#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

// Overshooting ends while this many times the wanted unshot fraction is left; plain shooting, which only ever
// lowers the sum of unshot flux, finishes.
constexpr uint64_t kOvershootUntil = 8;

// An element deserves a shot of its own while it has this many rows' worth of flux to send, the fewest rows
// that a shot takes; a patch, half of that.
constexpr uint64_t kRowsOfElement = 4;
constexpr uint64_t kRowsOfPatch = 2;

// Sources shoot once they have this part, in 16ths, of the most that one had when the pass began.
constexpr uint64_t kPassThreshold = 11;

// 2^32 over the golden ratio: the roundings of successive shots are spread evenly.
constexpr uint32_t kGoldenStep = 0x9e3779b9u;

uint64_t part_of_emitted(const State& state, Fraction part, int c) {
  return (static_cast<uint64_t>(part.raw) * static_cast<uint32_t>(state.emitted[c])) >> 32;
}

// Gives the shares of the row, and what is not given to elements, to those who receive them.
void distribute(State& state, const Flux* amount) {
  const Scene& scene = state.scene;
  const int channels = scene.channels;
  const bool by_face = state.sweep.kind == SourceKind::face;
  const uint32_t phase = (state.shots * kGoldenStep) >> 12;
  FluxCutter cutter[kMaxChannels] = {{amount[0], phase}, {amount[1], phase}, {amount[2], phase}};
  uint32_t left = kRowOne - state.row.escaped;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const uint32_t part = state.row.share[e];
    if (part == 0) {
      continue;
    }
    left -= part;
    int32_t* received = state.received + static_cast<uint32_t>(e) * scene.channels;
    for (int c = 0; c < channels; ++c) {
      const Flux share = cutter[c].cut(part);
      if (by_face) {
        const Material& material = flash_at(scene.materials, flash_at(scene.elements, e).material);
        account_unshot(
            state, e, c,
            reflect_more(Reflectance::from_raw(material.reflectance[c]), Flux::from_raw(received[c]), share));
      }
      received[c] += share.raw;
    }
  }
  for (int c = 0; c < channels; ++c) {
    state.escaped[c] += cutter[c].cut(state.row.escaped).raw;
    state.back[c] += cutter[c].cut(left).raw;
  }
}

Status fire(State& state, const Shot& shot, uint64_t flux) {
  const uint8_t turn = state.turn;
  const Status status = sample_source(state, shot.source, flux);
  if (status != Status::ok) {
    state.turn = turn;  // the next attempt looks as this one did
    return status;
  }
  const Observer& observer = state.settings.observer;
  if (observer.on_shot != nullptr) {
    observer.on_shot(observer.context, shot);
  }
  if (shot.is_emission) {
    ++state.next_emitter;
  } else {
    book_sent(state, shot.source);
  }
  distribute(state, shot.amount);
  ++state.shots;
  return Status::ok;
}

// Moves to the next element that emits; false if there is none.
bool find_emission(State& state, Shot& shot, uint64_t& flux) {
  const Scene& scene = state.scene;
  for (; state.next_emitter < scene.element_count; ++state.next_emitter) {
    const Element& element = flash_at(scene.elements, state.next_emitter);
    const Material& material = flash_at(scene.materials, element.material);
    flux = 0;
    for (int c = 0; c < scene.channels; ++c) {
      shot.amount[c] = shot.unshot[c] = emitted_flux(scene, material, element.area, c);
      flux += static_cast<uint32_t>(shot.amount[c].raw);
    }
    if (flux > 0) {
      shot.source = element_source(scene, state.next_emitter);
      shot.is_emission = true;
      return true;
    }
  }
  return false;
}

bool has_source(const State& state) {
  return state.sweep.cursor <
         (state.sweep.kind == SourceKind::patch ? state.scene.patch_count : state.scene.element_count);
}

EyeSource source_at_cursor(const State& state) {
  const uint16_t cursor = state.sweep.cursor;
  return state.sweep.kind == SourceKind::element ? element_source(state.scene, cursor)
         : state.sweep.kind == SourceKind::patch ? patch_source(state.scene, cursor)
                                                 : face_source(state.scene, cursor);
}

void advance(State& state, const EyeSource& source) {
  state.sweep.cursor =
      static_cast<uint16_t>(state.sweep.cursor + (source.kind == SourceKind::face ? source.count : 1u));
}

// The most that a source of the kind that shoots now has to send.
uint64_t loudest(State& state) {
  uint64_t most = 0;
  for (state.sweep.cursor = 0; has_source(state);) {
    const EyeSource source = source_at_cursor(state);
    Flux unshot[kMaxChannels];
    const uint64_t flux = unshot_of(state, source, unshot);
    most = flux > most ? flux : most;
    advance(state, source);
  }
  state.sweep.cursor = 0;
  return most;
}

void go_on_with_larger_sources(State& state) {
  if (state.sweep.kind == SourceKind::element) {
    state.sweep.kind = SourceKind::patch;
  } else {
    group_by_face(state);
  }
}

// Starts a pass, with larger sources where those of the last one have too little left for shots of their own.
// False when the solution has converged.
bool start_pass(State& state) {
  Sweep& sweep = state.sweep;
  bool is_near_end = true;
  bool is_done = true;
  UnshotSum unshot[kMaxChannels] = {};
  for (int c = 0; c < state.scene.channels; ++c) {
    unshot[c] = sum_unshot(state, c);
    const uint64_t limit = part_of_emitted(state, state.settings.stop, c);
    is_done = is_done && unshot[c].magnitude <= limit;
    is_near_end = is_near_end && unshot[c].magnitude <= kOvershootUntil * limit;
  }
  if (is_done) {
    return false;
  }
  uint64_t most = loudest(state);
  uint64_t floor = 0;
  for (; sweep.kind != SourceKind::face; most = loudest(state)) {
    floor = 4 * static_cast<uint64_t>(state.a_row) *
            (sweep.kind == SourceKind::element ? kRowsOfElement : kRowsOfPatch);
    if (sweep.has_shot && most >= floor) {
      break;
    }
    go_on_with_larger_sources(state);
    sweep.has_shot = true;
  }
  const uint64_t threshold = most * kPassThreshold / 16;
  const bool by_face = sweep.kind == SourceKind::face;
  sweep.threshold = by_face || threshold > floor ? threshold : floor;
  sweep.has_shot = false;
  for (int c = 0; c < state.scene.channels; ++c) {
    sweep.ambient[c] = state.settings.overshoot && !is_near_end && !by_face
                           ? ambient_of(state, c, unshot[c].balance)
                           : Radiosity::from_raw(0);
  }
  return true;
}

}  // namespace

Fraction unshot_fraction(const State& state) {
  uint64_t worst = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    const uint64_t emitted = static_cast<uint32_t>(state.emitted[c]);
    const uint64_t part = emitted == 0 ? 0 : (sum_unshot(state, c).magnitude << 32) / emitted;
    worst = part > worst ? part : worst;
  }
  return Fraction::from_raw(worst > 0xffffffffu ? 0xffffffffu : static_cast<uint32_t>(worst));
}

Status shoot(State& state) {
  Shot shot = {};
  uint64_t flux = 0;
  if (find_emission(state, shot, flux)) {
    return fire(state, shot, flux);
  }
  do {
    while (has_source(state)) {
      shot.source = source_at_cursor(state);
      flux = unshot_of(state, shot.source, shot.unshot);
      if (flux >= state.sweep.threshold && plan_amount(state, shot.source, shot.unshot, shot.amount)) {
        const Status status = fire(state, shot, flux);
        if (status == Status::ok) {
          state.sweep.has_shot = true;
          advance(state, shot.source);
        }
        return status;
      }
      advance(state, shot.source);
    }
  } while (start_pass(state));
  return Status::converged;
}

}  // namespace fixrad
