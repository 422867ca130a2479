// SPDX-License-Identifier: MIT
#include "lib/transport/unshot.h"

#include "lib/fixed/short_flux.h"

namespace fixrad {
namespace {

int32_t* account_of(const State& state, int c) {
  return state.accounts +
         static_cast<uint32_t>(c) * account_words(state.scene.element_count, state.scene.face_count);
}

uint16_t sent_short(const State& state, uint16_t e, int c) {
  const uint32_t pair = static_cast<uint32_t>(account_of(state, c)[e / 2]);
  return static_cast<uint16_t>(e % 2 != 0 ? pair >> 16 : pair);
}

void set_sent(State& state, uint16_t e, int c, uint16_t sent) {
  int32_t& word = account_of(state, c)[e / 2];
  const uint32_t pair = static_cast<uint32_t>(word);
  word = static_cast<int32_t>(e % 2 != 0 ? (pair & 0xffffu) | static_cast<uint32_t>(sent) << 16
                                         : (pair & 0xffff0000u) | sent);
}

int32_t element_unshot(const State& state, uint16_t e, int c) {
  return reflected_flux(state, e, c).raw - static_cast<int32_t>(sent_flux(state, e, c));
}

int32_t emission_left(const State& state, uint16_t e, int c) {
  if (e < state.next_emitter) {
    return 0;
  }
  const Element& element = flash_at(state.scene.elements, e);
  const Material& material = flash_at(state.scene.materials, element.material);
  return emitted_flux(state.scene, material, element.area, c).raw;
}

// What the element can have sent after a shot: all that it reflects, and its loan.
uint32_t reachable(const State& state, uint16_t e, int c, int32_t unshot) {
  const int32_t reflected = unshot + static_cast<int32_t>(sent_flux(state, e, c));
  int32_t loan = 0;
  const Radiosity ambient = state.sweep.ambient[c];
  if (ambient.raw != 0 && unshot > 0) {
    const Element& element = flash_at(state.scene.elements, e);
    const Material& material = flash_at(state.scene.materials, element.material);
    const uint64_t flux = wide_product(mul_high(material.reflectance[c], ambient.raw), element.area) >>
                          state.scene.radiosity_shift;
    loan = flux < static_cast<uint64_t>(unshot) ? static_cast<int32_t>(flux) : unshot;
  }
  return reflected + loan > 0 ? static_cast<uint32_t>(reflected + loan) : 0u;
}

}  // namespace

uint32_t sent_flux(const State& state, uint16_t e, int c) {
  return long_flux(sent_short(state, e, c));
}

uint64_t unshot_of(const State& state, const EyeSource& source, Flux* unshot) {
  uint64_t sum = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    int32_t flux = 0;
    if (source.kind == SourceKind::face) {
      flux = account_of(state, c)[source.face];
    } else {
      for (uint16_t i = 0; i < source.count; ++i) {
        flux += element_unshot(state, source_element(state.scene, source, i), c);
      }
    }
    unshot[c] = Flux::from_raw(flux);
    sum += magnitude(flux);
  }
  return sum;
}

bool plan_amount(const State& state, const EyeSource& source, Flux* unshot, Flux* amount) {
  unshot_of(state, source, unshot);
  bool is_any = false;
  for (int c = 0; c < state.scene.channels; ++c) {
    int32_t flux = source.kind == SourceKind::face ? unshot[c].raw : 0;
    for (uint16_t i = 0; source.kind != SourceKind::face && i < source.count; ++i) {
      const uint16_t e = source_element(state.scene, source, i);
      const uint32_t after = long_flux(short_flux(reachable(state, e, c, element_unshot(state, e, c))));
      flux += static_cast<int32_t>(after - sent_flux(state, e, c));
    }
    amount[c] = Flux::from_raw(flux);
    is_any = is_any || flux != 0;
  }
  return is_any;
}

void book_sent(State& state, const EyeSource& source) {
  for (int c = 0; c < state.scene.channels; ++c) {
    if (source.kind == SourceKind::face) {
      account_of(state, c)[source.face] = 0;
    }
    for (uint16_t i = 0; source.kind != SourceKind::face && i < source.count; ++i) {
      const uint16_t e = source_element(state.scene, source, i);
      set_sent(state, e, c, short_flux(reachable(state, e, c, element_unshot(state, e, c))));
    }
  }
}

void group_by_face(State& state) {
  const Scene& scene = state.scene;
  uint32_t* sums = state.row.share;  // there are at least as many elements as faces that have any
  for (int c = 0; c < scene.channels; ++c) {
    int32_t* account = account_of(state, c);
    for (uint16_t f = 0; f < scene.face_count; ++f) {
      sums[f] = 0;
    }
    for (uint16_t e = 0; e < scene.element_count; ++e) {
      sums[flash_at(scene.elements, e).face] += static_cast<uint32_t>(element_unshot(state, e, c));
    }
    for (uint16_t f = 0; f < scene.face_count; ++f) {
      account[f] = static_cast<int32_t>(sums[f]);
      sums[f] = 0;
    }
  }
  state.sweep.kind = SourceKind::face;
}

void start_face_accounts(State& state) {
  for (int c = 0; c < state.scene.channels; ++c) {
    for (uint16_t f = 0; f < state.scene.face_count; ++f) {
      account_of(state, c)[f] = 0;
    }
  }
  state.sweep.kind = SourceKind::face;
  state.next_emitter = state.scene.element_count;
}

void account_unshot(State& state, uint16_t e, int c, Flux more) {
  account_of(state, c)[flash_at(state.scene.elements, e).face] += more.raw;
}

UnshotSum sum_unshot(const State& state, int c) {
  UnshotSum sum = {0, 0};
  const bool by_face = state.sweep.kind == SourceKind::face;
  for (uint16_t f = 0; by_face && f < state.scene.face_count; ++f) {
    const int32_t flux = account_of(state, c)[f];
    sum.magnitude += magnitude(flux);
    sum.balance += flux;
  }
  for (uint16_t e = by_face ? state.next_emitter : 0; e < state.scene.element_count; ++e) {
    const int32_t flux = emission_left(state, e, c) + (by_face ? 0 : element_unshot(state, e, c));
    sum.magnitude += magnitude(flux);
    sum.balance += flux;
  }
  return sum;
}

}  // namespace fixrad
