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

// Not inlined, as others here: what they keep on the stack is not to lie under the engine's.
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

// What an element emits; returns flux_meant() of it.
uint64_t emission_of(const State& state, uint16_t e, Flux* amount) {
  const Scene& scene = state.scene;
  const Element& element = flash_at(scene.elements, e);
  const Material& material = flash_at(scene.materials, element.material);
  uint64_t flux = 0;
  for (int c = 0; c < scene.channels; ++c) {
    amount[c] = emitted_flux(scene, material, element.area, c);
    flux += static_cast<uint32_t>(amount[c].raw);
  }
  return flux_meant(flux, scene.channels);
}

bool has_emission(const State& state) {
  return state.next_emitter < state.scene.element_count;
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

// Starts a pass, or, where the sources of the last one have too little left for shots of their own, turns to
// larger ones: in_progress, the pass starts with the next call. Converged where nothing is left to shoot.
__attribute__((noinline)) Status start_pass(State& state) {
  Sweep& sweep = state.sweep;
  const Survey survey = survey_unshot(state);
  if (!sweep.grows && is_converged(state, survey, 1)) {
    return Status::converged;
  }
  if (sweep.kind != SourceKind::face && (survey.most < floor_of(state) || !sweep.has_shot)) {
    go_on_with_larger_sources(state);
    sweep.has_shot = sweep.grows = true;
    sweep.cursor = state.scene.element_count;  // behind the last source of any kind
    return Status::in_progress;
  }
  const uint64_t threshold = survey.most * kPassThreshold / 16;
  const uint64_t floor = floor_of(state);
  sweep.threshold = threshold > floor ? threshold : floor;
  sweep.cursor = 0;
  sweep.has_shot = sweep.grows = false;
  const bool lends = state.settings.overshoot && sweep.kind != SourceKind::face &&
                     !is_converged(state, survey, kOvershootUntil);
  for (int c = 0; c < state.scene.channels; ++c) {
    sweep.ambient[c] = lends ? ambient_of(state, c, survey.balance[c]) : Radiosity::from_raw(0);
  }
  return Status::ok;
}

// The source of the shot that is under way, or would come next.
EyeSource next_source(const State& state) {
  return has_emission(state) ? element_source(state.scene, state.next_emitter) : source_at_cursor(state);
}

// Moves to the next element that emits and begins its shot; ok where none does.
Status begin_emission(State& state) {
  while (has_emission(state)) {
    if (is_used_up(state.work)) {
      return Status::in_progress;
    }
    Flux amount[kMaxChannels];
    const uint64_t flux = emission_of(state, state.next_emitter, amount);
    if (flux > 0) {
      begin_source(state, element_source(state.scene, state.next_emitter), flux);
      return Status::ok;
    }
    spend_on_stretch(state.work, ++state.next_emitter);
  }
  return Status::ok;
}

// Begins the shot of the source at the cursor if it has enough to send.
__attribute__((noinline)) bool begin_if_strong(State& state, const EyeSource& source) {
  Flux unshot[kMaxChannels], amount[kMaxChannels];
  const uint64_t flux = unshot_of(state, source, unshot);
  if (flux < state.sweep.threshold || !plan_amount(state, source, amount)) {
    return false;
  }
  begin_source(state, source, flux);
  return true;
}

// Moves to the next source that has enough to send and begins its shot. A patch or a face takes a unit,
// elements one a stretch.
Status begin_reflection(State& state) {
  for (;;) {
    if (is_used_up(state.work)) {
      return Status::in_progress;
    }
    if (!has_source(state)) {
      if (start_pass(state) == Status::converged) {
        return Status::converged;
      }
      spend(state.work);
      continue;
    }
    const EyeSource source = source_at_cursor(state);
    if (begin_if_strong(state, source)) {
      return Status::ok;
    }
    advance(state, source);
    spend_on_stretch(state.work, source.kind == SourceKind::element ? state.sweep.cursor : 0);
  }
}

Status begin_shot(State& state) {
  const Status status = begin_emission(state);
  return status != Status::ok || state.sampling.stage != SamplingStage::none ? status
                                                                             : begin_reflection(state);
}

// Corrects the complete row of an element.
Status correct_row(State& state, const EyeSource& source) {
  const NearField near_field = state.settings.near_field;
  if (near_field == nullptr || source.kind != SourceKind::element ||
      state.sampling.stage == SamplingStage::corrected) {
    return Status::ok;
  }
  const Status status = near_field(state.scene, source.first, state.work, state.row);
  if (status == Status::ok) {
    state.sampling.stage = SamplingStage::corrected;
  }
  return status;
}

void report_shot(const State& state, const EyeSource& source) {
  const Observer& observer = state.settings.observer;
  if (observer.on_shot == nullptr) {
    return;
  }
  Shot shot = {};
  shot.source = source;
  shot.is_emission = has_emission(state);
  if (shot.is_emission) {
    emission_of(state, source.first, shot.unshot);
    emission_of(state, source.first, shot.amount);
  } else {
    unshot_of(state, source, shot.unshot);
    plan_amount(state, source, shot.amount);
  }
  observer.on_shot(observer.context, shot);
}

// The row is complete: now the shot becomes part of the solution.
__attribute__((noinline)) void book_shot(State& state, const EyeSource& source) {
  book_eyes(state);
  report_shot(state, source);
  Flux amount[kMaxChannels] = {};
  if (has_emission(state)) {
    emission_of(state, state.next_emitter, amount);
    ++state.next_emitter;
  } else {
    book_sent(state, source, amount);
    state.sweep.has_shot = true;
    advance(state, source);
  }
  distribute(state, amount);
  ++state.shots;
}

Status go_on(State& state) {
  if (state.sampling.stage == SamplingStage::none) {
    const Status status = begin_shot(state);
    if (status != Status::ok) {
      return status;
    }
  }
  const EyeSource source = next_source(state);
  Status status = go_on_with_source(state, source);
  status = status == Status::ok ? correct_row(state, source) : status;
  if (status != Status::ok) {
    return status;
  }
  if (is_used_up(state.work)) {
    return Status::in_progress;
  }
  book_shot(state, source);
  return Status::ok;
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
  state.work.budget = 0;
  return go_on(state);
}

FIXRAD_MODULO Status shoot_for(State& state, uint32_t budget) {
  state.work.budget = budget == 0 ? 2 : budget + 1;  // the most there is stands for no limit
  const Status status = go_on(state);
  state.work.budget = 0;
  return status;
}

void abandon_shot(State& state) {
  state.sampling.stage = SamplingStage::none;
  forget_view(state.work);
}

}  // namespace fixrad
