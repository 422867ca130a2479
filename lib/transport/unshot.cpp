// SPDX-License-Identifier: MIT
#include "lib/transport/unshot.h"

#include "lib/fixed/short_flux.h"

namespace fixrad {
namespace {

uint32_t words_a_channel(const State& state) {
  return account_words(state.scene.element_count, state.scene.face_count);
}

int32_t* account_of(const State& state, int c) {
  return state.accounts + static_cast<uint32_t>(c) * words_a_channel(state);
}

uint16_t half_of(const int32_t* account, uint16_t e) {
  const uint32_t pair = static_cast<uint32_t>(account[e / 2u]);
  return static_cast<uint16_t>(e % 2u != 0 ? pair >> 16 : pair);
}

int32_t unsent(Flux reflected, const int32_t* account, uint16_t e) {
  return reflected.raw - static_cast<int32_t>(long_flux(half_of(account, e)));
}

int32_t element_unshot(const State& state, uint16_t e, int c) {
  return unsent(reflected_flux(state, e, c), account_of(state, c), e);
}

// Unshot flux of elements, all channels: every pass asks for that of every element, so what does not change
// is looked up once.
class ElementUnshot {
 public:
  explicit ElementUnshot(const State& state)
      : state_(state), words_(words_a_channel(state)), channels_(state.scene.channels) {}

  void add(uint16_t e, int32_t* unshot) const {
    const Element& element = flash_at(state_.scene.elements, e);
    const Material& material = flash_at(state_.scene.materials, element.material);
    const int32_t* received = state_.received + static_cast<uint32_t>(e) * channels_;
    const int32_t* account = state_.accounts;
    for (unsigned c = 0; c < channels_; ++c, account += words_) {
      const Reflectance reflectance = Reflectance::from_raw(material.reflectance[c]);
      unshot[c] += unsent(reflect(reflectance, Flux::from_raw(received[c])), account, e);
    }
  }

 private:
  const State& state_;
  uint32_t words_;
  unsigned channels_;
};

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

// What the element will have sent after a shot. A debt below one step of a short flux stays: were it taken
// back, the next loan would lend it again, for ever.
uint16_t sent_after(const State& state, uint16_t e, int c) {
  const uint16_t before = half_of(account_of(state, c), e);
  const uint16_t after = short_flux(reachable(state, e, c, element_unshot(state, e, c)));
  return after + 1 == before ? before : after;
}

}  // namespace

void set_sent(State& state, uint16_t e, int c, uint16_t sent) {
  int32_t& word = account_of(state, c)[e / 2u];
  const uint32_t pair = static_cast<uint32_t>(word);
  word = static_cast<int32_t>(e % 2u != 0 ? (pair & 0xffffu) | static_cast<uint32_t>(sent) << 16
                                          : (pair & 0xffff0000u) | sent);
}

Flux face_unshot(const State& state, uint16_t face, int c) {
  return Flux::from_raw(account_of(state, c)[face]);
}

void set_face_unshot(State& state, uint16_t face, int c, Flux unshot) {
  account_of(state, c)[face] = unshot.raw;
}

uint32_t sent_flux(const State& state, uint16_t e, int c) {
  return long_flux(half_of(account_of(state, c), e));
}

uint64_t unshot_of(const State& state, const EyeSource& source, Flux* unshot) {
  int32_t flux[kMaxChannels] = {0, 0, 0};
  if (source.kind == SourceKind::face) {
    for (int c = 0; c < state.scene.channels; ++c) {
      flux[c] = account_of(state, c)[source.face];
    }
  } else {
    const ElementUnshot elements(state);
    for (uint16_t i = 0; i < source.count; ++i) {
      elements.add(source_element(state.scene, source, i), flux);
    }
  }
  uint64_t sum = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    unshot[c] = Flux::from_raw(flux[c]);
    sum += magnitude(flux[c]);
  }
  return flux_meant(sum, state.scene.channels);
}

bool plan_amount(const State& state, const EyeSource& source, Flux* amount) {
  bool is_any = false;
  for (int c = 0; c < state.scene.channels; ++c) {
    int32_t flux = source.kind == SourceKind::face ? account_of(state, c)[source.face] : 0;
    for (uint16_t i = 0; source.kind != SourceKind::face && i < source.count; ++i) {
      const uint16_t e = source_element(state.scene, source, i);
      const int32_t after = static_cast<int32_t>(long_flux(sent_after(state, e, c)));
      flux += after - static_cast<int32_t>(sent_flux(state, e, c));
    }
    amount[c] = Flux::from_raw(flux);
    is_any = is_any || flux != 0;
  }
  return is_any;
}

FIXRAD_MODULO void book_sent(State& state, const EyeSource& source, Flux* amount) {
  for (int c = 0; c < state.scene.channels; ++c) {
    int32_t flux = 0;
    if (source.kind == SourceKind::face) {
      int32_t& account = account_of(state, c)[source.face];
      flux = account;
      account = 0;
    }
    for (uint16_t i = 0; source.kind != SourceKind::face && i < source.count; ++i) {
      const uint16_t e = source_element(state.scene, source, i);
      const uint16_t after = sent_after(state, e, c);
      flux += static_cast<int32_t>(long_flux(after) - sent_flux(state, e, c));
      set_sent(state, e, c, after);
    }
    amount[c] = Flux::from_raw(flux);
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
      uint32_t& sum = sums[flash_at(scene.elements, e).face];
      // Negative where an element has lent: modulo 2^32, which compilers make of it.
      sum = static_cast<uint32_t>(uint64_t{sum} + static_cast<uint32_t>(element_unshot(state, e, c)));
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

namespace {

// The part weight / (weight + rest) of `whole`, towards zero.
int32_t part_of(int32_t whole, uint32_t weight, uint32_t rest) {
  const uint64_t sum = static_cast<uint64_t>(weight) + rest;
  const int shift = sum >> 32 != 0 ? 1 : 0;
  const uint32_t all = static_cast<uint32_t>(sum >> shift);
  const uint32_t part = all == 0
                            ? magnitude(whole) / 2
                            : static_cast<uint32_t>(wide_product(magnitude(whole), weight >> shift) / all);
  return whole < 0 ? -static_cast<int32_t>(part) : static_cast<int32_t>(part);
}

// The same of what was sent, so that both parts are short fluxes: they keep the step of the whole.
uint16_t short_part(uint16_t whole, uint32_t weight, uint32_t rest) {
  const uint32_t flux = long_flux(whole);
  const int excess = bit_length(flux) - (kShortFluxBits + 1);
  const int step = excess > 0 ? excess : 0;
  return short_flux(static_cast<uint32_t>(part_of(static_cast<int32_t>(flux >> step), weight, rest)) << step);
}

// Elements behind `parent` move up by one, and with them the accounts of all channels: from the last half
// word to the first, since none moves down.
void make_room(State& state, uint16_t parent) {
  const uint16_t count = state.scene.element_count;
  const uint32_t faces = state.scene.face_count;
  const uint32_t channels = state.scene.channels;
  const uint32_t before = account_words(count - 1u, faces);
  for (uint32_t i = count * channels; i-- > (parent + 2u) * channels;) {
    state.received[i] = state.received[i - channels];
  }
  for (int c = state.scene.channels - 1; c >= 0; --c) {
    const int32_t* from = state.accounts + static_cast<uint32_t>(c) * before;
    for (uint16_t e = count; e > 0;) {
      --e;
      const uint16_t source = e > parent ? static_cast<uint16_t>(e - 1) : e;
      set_sent(state, e, c, half_of(from, source));
    }
  }
}

}  // namespace

void share_flux(State& state, uint16_t parent, const uint32_t* weight, const uint32_t* rest) {
  make_room(state, parent);
  const uint16_t child = static_cast<uint16_t>(parent + 1);
  const uint32_t channels = state.scene.channels;
  for (uint32_t c = 0; c < channels; ++c) {
    int32_t& received = state.received[parent * channels + c];
    const int32_t kept = part_of(received, weight[c], rest[c]);
    state.received[child * channels + c] = received - kept;
    received = kept;
    const int32_t* account = account_of(state, static_cast<int>(c));
    const uint16_t sent = half_of(account, parent);
    const uint16_t kept_sent = short_part(sent, weight[c], rest[c]);
    set_sent(state, parent, static_cast<int>(c), kept_sent);
    set_sent(state, child, static_cast<int>(c), short_flux(long_flux(sent) - long_flux(kept_sent)));
  }
}

void account_unshot(State& state, uint16_t face, int c, Flux more) {
  account_of(state, c)[face] += more.raw;
}

namespace {

void add_to(Survey& survey, const int32_t* unshot, int channels) {
  for (int c = 0; c < channels; ++c) {
    survey.magnitude[c] += magnitude(unshot[c]);
    survey.balance[c] += unshot[c];
  }
}

uint64_t sum_of_magnitudes(const int32_t* unshot, int channels) {
  uint64_t sum = 0;
  for (int c = 0; c < channels; ++c) {
    sum += magnitude(unshot[c]);
  }
  return sum;
}

void keep_most(Survey& survey, const int32_t* unshot, int channels) {
  const uint64_t sum = sum_of_magnitudes(unshot, channels);
  survey.most = sum > survey.most ? sum : survey.most;
}

void survey_elements(const State& state, Survey& survey) {
  const ElementUnshot elements(state);
  for (uint16_t e = 0; e < state.scene.element_count; ++e) {
    int32_t unshot[kMaxChannels] = {0, 0, 0};
    elements.add(e, unshot);
    add_to(survey, unshot, state.scene.channels);
    keep_most(survey, unshot, state.scene.channels);
  }
}

void survey_patches(const State& state, Survey& survey) {
  const ElementUnshot elements(state);
  for (uint16_t p = 0; p < state.scene.patch_count; ++p) {
    const EyeSource patch = patch_source(state.scene, p);
    int32_t sum[kMaxChannels] = {0, 0, 0};
    for (uint16_t i = 0; i < patch.count; ++i) {
      int32_t unshot[kMaxChannels] = {0, 0, 0};
      elements.add(source_element(state.scene, patch, i), unshot);
      add_to(survey, unshot, state.scene.channels);
      for (int c = 0; c < state.scene.channels; ++c) {
        sum[c] += unshot[c];
      }
    }
    keep_most(survey, sum, state.scene.channels);
  }
}

void survey_faces(const State& state, Survey& survey) {
  for (uint16_t f = 0; f < state.scene.face_count; ++f) {
    int32_t unshot[kMaxChannels] = {0, 0, 0};
    for (int c = 0; c < state.scene.channels; ++c) {
      unshot[c] = account_of(state, c)[f];
    }
    add_to(survey, unshot, state.scene.channels);
    keep_most(survey, unshot, state.scene.channels);
  }
}

}  // namespace

Survey survey_unshot(const State& state) {
  Survey survey = {};
  if (state.sweep.kind == SourceKind::element) {
    survey_elements(state, survey);
  } else if (state.sweep.kind == SourceKind::patch) {
    survey_patches(state, survey);
  } else {
    survey_faces(state, survey);
  }
  survey.most = flux_meant(survey.most, state.scene.channels);
  return survey;
}

UnshotSum sum_unshot(const State& state, int c) {
  const Survey survey = survey_unshot(state);
  UnshotSum sum = {survey.magnitude[c], survey.balance[c]};
  for (uint16_t e = state.next_emitter; e < state.scene.element_count; ++e) {
    const Element& element = flash_at(state.scene.elements, e);
    const Material& material = flash_at(state.scene.materials, element.material);
    const int32_t flux = emitted_flux(state.scene, material, element.area, c).raw;
    sum.magnitude += magnitude(flux);
    sum.balance += flux;
  }
  return sum;
}

}  // namespace fixrad
