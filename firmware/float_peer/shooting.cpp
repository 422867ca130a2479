// SPDX-License-Identifier: MIT
#include "firmware/float_peer/shooting.h"

#include "firmware/float_peer/sampling.h"
#include "firmware/float_peer/unshot.h"

namespace fixrad {
namespace peer {
namespace {

// As in the core: loans end while this many times the wanted unshot fraction is left; a source needs so many
// rows' worth of flux for a shot of its own; it shoots once it has this part of the loudest one's flux.
constexpr float kOvershootUntil = 8.0f;
constexpr float kRowsOfElement = 4.0f;
constexpr float kRowsOfPatch = 2.0f;
constexpr float kPassThreshold = 11.0f / 16;

struct Shot {
  EyeSource source;
  bool is_emission;
  float flux;  // that the source has to send, sum over channels
  Channels amount;
};

template <int ChannelCount>
void distribute_to_elements(State& state, const Channels& sent) {
  float* received = state.received;
  for (uint16_t e = 0; e < state.scene.element_count; ++e, received += ChannelCount) {
    const float share = state.row.share[e];
    if (share == 0.0f) {
      continue;
    }
    for (int c = 0; c < ChannelCount; ++c) {
      received[c] += sent.c[c] * share;
    }
  }
}

template <int ChannelCount>
void distribute_to_faces(State& state, const Channels& sent) {
  const Scene& scene = state.scene;
  Channels reflected = {};     // of one unit of the row
  uint16_t material = 0xffff;  // of `reflected`; elements are ordered by face
  float* received = state.received;
  for (uint16_t e = 0; e < scene.element_count; ++e, received += ChannelCount) {
    const float share = state.row.share[e];
    if (share == 0.0f) {
      continue;
    }
    const Element& element = flash_at(scene.elements, e);
    if (element.material != material) {
      material = element.material;
      const Channels reflectance = reflectance_of(scene, material);
      for (int c = 0; c < ChannelCount; ++c) {
        reflected.c[c] = sent.c[c] * reflectance.c[c];
      }
    }
    float* unshot = state.accounts + static_cast<uint32_t>(element.face) * ChannelCount;
    for (int c = 0; c < ChannelCount; ++c) {
      received[c] += sent.c[c] * share;
      unshot[c] += reflected.c[c] * share;
    }
  }
}

// The number of channels is a constant here, as these loops run over all elements at every shot.
template <int ChannelCount>
void distribute(State& state, const Channels& sent) {
  if (state.sweep.kind == SourceKind::face) {
    distribute_to_faces<ChannelCount>(state, sent);
  } else {
    distribute_to_elements<ChannelCount>(state, sent);
  }
  for (int c = 0; c < ChannelCount; ++c) {
    state.escaped.c[c] += sent.c[c] * state.row.escaped;
    state.back.c[c] += sent.c[c] * state.row.back;
  }
}

Status fire(State& state, const Shot& shot) {
  const Status status = sample_source(state, shot.source, shot.flux);
  if (status != Status::ok) {
    return status;
  }
  if (shot.is_emission) {
    ++state.next_emitter;
  } else {
    book_sent(state, shot.source);
  }
  const float part_of_shot = 1.0f / state.row.whole;
  Channels sent = {};
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    sent.c[c] = shot.amount.c[c] * part_of_shot;
  }
  const auto distribute_channels = state.scene.channels == 1   ? distribute<1>
                                   : state.scene.channels == 2 ? distribute<2>
                                                               : distribute<3>;
  distribute_channels(state, sent);
  ++state.shots;
  return Status::ok;
}

// Moves to the next element that emits; false if there is none.
bool find_emission(State& state, Shot& shot) {
  for (; state.next_emitter < state.scene.element_count; ++state.next_emitter) {
    for (uint8_t c = 0; c < state.scene.channels; ++c) {
      shot.amount.c[c] = emitted_flux(state, state.next_emitter, c);
    }
    shot.flux = magnitude_of(state, shot.amount);
    if (shot.flux > 0.0f) {
      shot.source = element_source(state.scene, state.next_emitter);
      shot.is_emission = true;
      return true;
    }
  }
  return false;
}

bool is_converged(const State& state, const UnshotScan& scan, float factor) {
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    if (scan.magnitude.c[c] > factor * state.stop * state.emitted.c[c]) {
      return false;
    }
  }
  return true;
}

// What an element of reflectance 1 and area 1 will still receive if the ambient estimate is right.
Channels loans(const State& state, const UnshotScan& scan) {
  Channels loan = {};
  if (!state.overshoot || state.sweep.kind == SourceKind::face ||
      is_converged(state, scan, kOvershootUntil)) {
    return loan;
  }
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    if (scan.balance.c[c] > 0.0f && state.absorbing_area.c[c] > 0.0f) {
      loan.c[c] = scan.balance.c[c] / state.absorbing_area.c[c];
    }
  }
  return loan;
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
  const UnshotScan scan = scan_unshot(state);
  if (is_converged(state, scan, 1.0f)) {
    return false;
  }
  float loudest = scan.loudest;
  float floor = 0.0f;
  for (; sweep.kind != SourceKind::face; loudest = scan_unshot(state).loudest) {
    floor = state.a_row * (sweep.kind == SourceKind::element ? kRowsOfElement : kRowsOfPatch);
    if (sweep.has_shot && loudest >= floor) {
      break;
    }
    go_on_with_larger_sources(state);
    sweep.has_shot = true;
  }
  const float threshold = loudest * kPassThreshold;
  sweep.threshold = sweep.kind == SourceKind::face || threshold > floor ? threshold : floor;
  sweep.has_shot = false;
  sweep.loan = loans(state, scan);
  return true;
}

}  // namespace

Status shoot(State& state) {
  Shot shot = {};
  if (find_emission(state, shot)) {
    return fire(state, shot);
  }
  do {
    Reflectances reflectances(state.scene);
    while (has_source(state)) {
      shot.source = source_at_cursor(state);
      shot.flux = magnitude_of(state, unshot_of(state, shot.source, reflectances));
      if (shot.flux >= state.sweep.threshold) {
        shot.amount = amount_of(state, shot.source);
        const Status status = fire(state, shot);
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

}  // namespace peer
}  // namespace fixrad
