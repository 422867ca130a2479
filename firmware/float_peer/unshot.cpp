// SPDX-License-Identifier: MIT
#include "firmware/float_peer/unshot.h"

namespace fixrad {
namespace peer {
namespace {

// The accounts of a source: one for a face, else one for each of its elements.
uint16_t account_count(const EyeSource& source) {
  return source.kind == SourceKind::face ? static_cast<uint16_t>(1) : source.count;
}

float* account_of(const State& state, uint16_t element_or_face) {
  return state.accounts + static_cast<uint32_t>(element_or_face) * state.scene.channels;
}

Channels element_unshot(const State& state, uint16_t e, const Channels& reflectance) {
  const float* received = state.received + static_cast<uint32_t>(e) * state.scene.channels;
  const float* sent = account_of(state, e);
  Channels unshot = {};
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    unshot.c[c] = reflectance.c[c] * received[c] - sent[c];
  }
  return unshot;
}

Channels face_unshot(const State& state, uint16_t face) {
  const float* account = account_of(state, face);
  Channels unshot = {};
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    unshot.c[c] = account[c];
  }
  return unshot;
}

// What the i-th account of the source says.
Channels account_unshot(const State& state, const EyeSource& source, uint16_t i, Reflectances& reflectances) {
  if (source.kind == SourceKind::face) {
    return face_unshot(state, source.face);
  }
  const uint16_t e = source_element(state.scene, source, i);
  return element_unshot(state, e, reflectances.of(e));
}

// What the element sends: all that it has, and its loan.
Channels element_amount(const State& state, uint16_t e, const Channels& reflectance) {
  Channels amount = element_unshot(state, e, reflectance);
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    const float lent = state.sweep.loan.c[c];
    if (lent > 0.0f && amount.c[c] > 0.0f) {
      const float area = static_cast<float>(flash_at(state.scene.elements, e).area);
      const float loan = reflectance.c[c] * lent * area;
      amount.c[c] += loan < amount.c[c] ? loan : amount.c[c];
    }
  }
  return amount;
}

void add_to(Channels& sum, const Channels& more) {
  for (int c = 0; c < kMaxChannels; ++c) {
    sum.c[c] += more.c[c];
  }
}

}  // namespace

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

Channels unshot_of(const State& state, const EyeSource& source, Reflectances& reflectances) {
  Channels unshot = account_unshot(state, source, 0, reflectances);
  for (uint16_t i = 1; i < account_count(source); ++i) {
    add_to(unshot, account_unshot(state, source, i, reflectances));
  }
  return unshot;
}

float magnitude_of(const State& state, const Channels& flux) {
  float sum = __builtin_fabsf(flux.c[0]);
  for (uint8_t c = 1; c < state.scene.channels; ++c) {
    sum += __builtin_fabsf(flux.c[c]);
  }
  return sum;
}

Channels amount_of(const State& state, const EyeSource& source) {
  if (source.kind == SourceKind::face) {
    return face_unshot(state, source.face);
  }
  Reflectances reflectances(state.scene);
  Channels amount = {};
  for (uint16_t i = 0; i < source.count; ++i) {
    const uint16_t e = source_element(state.scene, source, i);
    add_to(amount, element_amount(state, e, reflectances.of(e)));
  }
  return amount;
}

void book_sent(State& state, const EyeSource& source) {
  if (source.kind == SourceKind::face) {
    float* unshot = account_of(state, source.face);
    for (uint8_t c = 0; c < state.scene.channels; ++c) {
      unshot[c] = 0.0f;
    }
    return;
  }
  Reflectances reflectances(state.scene);
  for (uint16_t i = 0; i < source.count; ++i) {
    const uint16_t e = source_element(state.scene, source, i);
    const Channels amount = element_amount(state, e, reflectances.of(e));
    float* sent = account_of(state, e);
    for (uint8_t c = 0; c < state.scene.channels; ++c) {
      sent[c] += amount.c[c];
    }
  }
}

// No face stands behind its first element, so its account takes the place of one that has been read.
void group_by_face(State& state) {
  Reflectances reflectances(state.scene);
  for (uint16_t e = 0; e < state.scene.element_count;) {
    const EyeSource face = face_source(state.scene, e);
    Channels unshot = {};
    for (uint16_t i = 0; i < face.count; ++i, ++e) {
      add_to(unshot, element_unshot(state, e, reflectances.of(e)));
    }
    float* account = account_of(state, face.face);
    for (uint8_t c = 0; c < state.scene.channels; ++c) {
      account[c] = unshot.c[c];
    }
  }
  state.sweep.kind = SourceKind::face;
}

UnshotScan scan_unshot(State& state) {
  UnshotScan scan = {};
  Reflectances reflectances(state.scene);
  for (state.sweep.cursor = 0; has_source(state);) {
    const EyeSource source = source_at_cursor(state);
    Channels sum = {};
    for (uint16_t i = 0; i < account_count(source); ++i) {
      const Channels unshot = account_unshot(state, source, i, reflectances);
      for (uint8_t c = 0; c < state.scene.channels; ++c) {
        scan.magnitude.c[c] += __builtin_fabsf(unshot.c[c]);
        scan.balance.c[c] += unshot.c[c];
        sum.c[c] += unshot.c[c];
      }
    }
    const float flux = magnitude_of(state, sum);
    scan.loudest = flux > scan.loudest ? flux : scan.loudest;
    advance(state, source);
  }
  state.sweep.cursor = 0;
  return scan;
}

}  // namespace peer
}  // namespace fixrad
