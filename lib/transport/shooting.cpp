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

// The number of channels is a constant here: this loop runs over all elements at every shot.
template <int Channels>
uint32_t give_shares(State& state, FluxCutter* cutter) {
  uint32_t given = 0;
  int32_t* received = state.received;
  const uint32_t* end = state.row.share + state.scene.element_count;
  for (const uint32_t* share = state.row.share; share != end; ++share, received += Channels) {
    const uint32_t part = *share;
    if (part == 0) {
      continue;
    }
    given += part;
    for (int c = 0; c < Channels; ++c) {
      received[c] += cutter[c].cut(part).raw;
    }
  }
  return given;
}

// The same once faces keep account of what their elements have to send.
uint32_t give_shares_to_faces(State& state, FluxCutter* cutter) {
  const Scene& scene = state.scene;
  uint32_t given = 0;
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const uint32_t part = state.row.share[e];
    if (part == 0) {
      continue;
    }
    given += part;
    const Element& element = flash_at(scene.elements, e);
    const Material& material = flash_at(scene.materials, element.material);
    int32_t* received = state.received + static_cast<uint32_t>(e) * scene.channels;
    for (int c = 0; c < scene.channels; ++c) {
      const Flux share = cutter[c].cut(part);
      const Reflectance reflectance = Reflectance::from_raw(material.reflectance[c]);
      account_unshot(state, element.face, c, reflect_more(reflectance, Flux::from_raw(received[c]), share));
      received[c] += share.raw;
    }
  }
  return given;
}

// Not inlined, as start_pass(): what they keep on the stack is not to lie under the engine's.
FIXRAD_MODULO __attribute__((noinline)) void distribute(State& state, const Flux* amount) {
  const uint32_t phase = (state.shots * kGoldenStep) >> 12;
  FluxCutter cutter[kMaxChannels] = {{amount[0], phase}, {amount[1], phase}, {amount[2], phase}};
  const int channels = state.scene.channels;
  const uint32_t given = state.sweep.kind == SourceKind::face ? give_shares_to_faces(state, cutter)
                         : channels == 1                      ? give_shares<1>(state, cutter)
                         : channels == 2                      ? give_shares<2>(state, cutter)
                                                              : give_shares<3>(state, cutter);
  for (int c = 0; c < channels; ++c) {
    state.escaped[c] += cutter[c].cut(state.row.escaped).raw;
    state.back[c] += cutter[c].cut(kRowOne - given - state.row.escaped).raw;
  }
}

Status fire(State& state, const Shot& shot, uint64_t flux) {
  const uint8_t turn = state.turn;
  const Status status = sample_source(state, shot.source, flux);
  if (status != Status::ok) {
    state.turn = turn;  // the next attempt looks as this one did
    return status;
  }
  if (state.settings.near_field != nullptr && shot.source.kind == SourceKind::element) {
    state.settings.near_field(state.scene, shot.source.first, state.work, state.row);
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
    flux = flux_meant(flux, scene.channels);
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

void go_on_with_larger_sources(State& state) {
  if (state.sweep.kind == SourceKind::element) {
    state.sweep.kind = SourceKind::patch;
  } else {
    group_by_face(state);
  }
}

// Are all channels' unshot fluxes at most `factor` times what may be left?
bool is_converged(const State& state, const Survey& survey, uint64_t factor) {
  for (int c = 0; c < state.scene.channels; ++c) {
    if (survey.magnitude[c] > factor * part_of_emitted(state, state.settings.stop, c)) {
      return false;
    }
  }
  return true;
}

// The least that a source of the kind that shoots now is to have for a shot of its own.
uint64_t floor_of(const State& state) {
  const uint64_t rows = state.sweep.kind == SourceKind::element ? kRowsOfElement
                        : state.sweep.kind == SourceKind::patch ? kRowsOfPatch
                                                                : 0;
  return 4 * rows * state.a_row;
}

// Starts a pass, with larger sources where those of the last one have too little left for shots of their own.
// False when the solution has converged.
__attribute__((noinline)) bool start_pass(State& state) {
  Sweep& sweep = state.sweep;
  Survey survey = survey_unshot(state);
  if (is_converged(state, survey, 1)) {
    return false;
  }
  while (sweep.kind != SourceKind::face && (survey.most < floor_of(state) || !sweep.has_shot)) {
    go_on_with_larger_sources(state);
    sweep.has_shot = true;
    survey = survey_unshot(state);
  }
  const uint64_t threshold = survey.most * kPassThreshold / 16;
  const uint64_t floor = floor_of(state);
  sweep.threshold = threshold > floor ? threshold : floor;
  sweep.cursor = 0;
  sweep.has_shot = false;
  const bool lends = state.settings.overshoot && sweep.kind != SourceKind::face &&
                     !is_converged(state, survey, kOvershootUntil);
  for (int c = 0; c < state.scene.channels; ++c) {
    sweep.ambient[c] = lends ? ambient_of(state, c, survey.balance[c]) : Radiosity::from_raw(0);
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
  return Fraction::from_raw(saturate(worst, Place::unshot_fraction));
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
