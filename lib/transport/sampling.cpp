// SPDX-License-Identifier: MIT
#include "lib/transport/sampling.h"

#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

// More eyes than this do not pay for a patch or a face, whose light is the weak rest of the scene's.
constexpr uint32_t kMostGroupEyes = 16;

constexpr uint32_t kMostRows = 0xffff;

// The coarsest table with at least `rows` rows, or the finest.
DeltaTable table_for(const Settings& settings, uint32_t rows) {
  uint8_t i = 0;
  const uint8_t coarsest = flash_at(settings.tables, 0).resolution_log2;
  while (i + 1 < settings.table_count && (static_cast<uint32_t>(1) << (coarsest + i)) < rows) {
    ++i;
  }
  return flash_read(settings.tables, i);
}

// The eye at `position` of a face, which takes this part of the row and as many rows at least.
struct Eye {
  Vec3 position;
  uint16_t face;
  uint32_t weight, rows;
  bool is_clear;
};

Status look(State& state, const Eye& eye) {
  const Settings& settings = state.settings;
  Sampling& sampling = state.sampling;
  const DeltaTable table = table_for(settings, eye.rows);
  const EyeSample sample = {
      {eye.position, eye.face, sampling.turn}, eye.weight, !state.is_closed, eye.is_clear};
  const Status status = settings.engine(state.scene, table, sample, state.work, state.row);
  if (status == Status::ok) {
    ++sampling.eyes;
    sampling.turn = static_cast<uint8_t>((sampling.turn + 1) % kTurns);
    if (settings.observer.on_eye != nullptr) {
      settings.observer.on_eye(settings.observer.context, table, sample);
    }
  }
  return status;
}

Status look_from_centroid(State& state, uint16_t e, uint32_t weight, uint32_t rows, bool is_clear) {
  const Element element = flash_read(state.scene.elements, e);
  return look(state, {vec(element.eye), element.face, weight, rows, is_clear});
}

Status probe(State& state, const EyePoint& eye, bool& is_clear) {
  uint32_t share = 0;
  const Status status = hidden_share(state.scene, flash_read(state.settings.probe, 0), eye, state.is_enclosed,
                                     state.work, share);
  if (status == Status::ok) {
    is_clear = share <= kBuriedShare;
    state.sampling.withdrawn = static_cast<uint16_t>(state.sampling.withdrawn + (is_clear ? 0u : 1u));
  }
  return status;
}

Status has_clear_centroid(State& state, uint16_t e, bool& is_clear) {
  const Sight sight = sight_of(state.scene, e);
  is_clear = sight == Sight::centroid_clear || sight == Sight::all_clear;
  if (sight != Sight::unknown) {
    return Status::ok;
  }
  const Element element = flash_read(state.scene.elements, e);
  return probe(state, {vec(element.eye), element.face, 0}, is_clear);
}

// The row of one element from a subdivision into at least `eyes` parts.
void begin_parts(State& state, uint16_t element, uint32_t eyes) {
  Sampling& sampling = state.sampling;
  sampling.level = static_cast<uint8_t>(level_for(eyes));
  sampling.index = 0;
  sampling.parts = {element, 0};
  sampling.stage = sampling.level == 1 ? SamplingStage::try_centroid : SamplingStage::choose;
}

Status try_centroid(State& state) {
  Sampling& sampling = state.sampling;
  bool is_clear = false;
  const Status status = has_clear_centroid(state, sampling.parts.element, is_clear);
  if (status == Status::ok) {
    sampling.level = 2;
    sampling.stage = is_clear ? SamplingStage::look_centroid : SamplingStage::choose;
  }
  return status;
}

// All eyes are buried. In an enclosed scene the element lies in contact with another face: its light stays
// there until it is absorbed. Elsewhere what little arrived leaves from the centroid.
void end_choice(State& state) {
  Sampling& sampling = state.sampling;
  sampling.index = 0;
  if (sampling.parts.chosen != 0) {
    sampling.stage = SamplingStage::look_chosen;
  } else if (sampling.level < kFinestLevel) {
    ++sampling.level;
  } else if (state.is_enclosed) {
    state.row.share[sampling.parts.element] += kRowOne;
    sampling.stage = SamplingStage::complete;
  } else {
    sampling.stage = SamplingStage::look_buried;
  }
}

unsigned places_of(const Sampling& sampling) {
  const unsigned level = sampling.level;
  return level * level;
}

Status choose_eyes(State& state) {
  Sampling& sampling = state.sampling;
  const uint16_t element = sampling.parts.element;
  const bool all_clear = sight_of(state.scene, element) == Sight::all_clear;
  const uint16_t face = flash_at(state.scene.elements, element).face;
  for (; sampling.index < places_of(sampling); ++sampling.index) {
    const EyeCandidate candidate = eye_candidate(state.scene, element, sampling.level, sampling.index);
    bool is_clear = candidate.is_used;
    const Status status =
        is_clear && !all_clear ? probe(state, {candidate.position, face, 0}, is_clear) : Status::ok;
    if (status != Status::ok) {
      return status;
    }
    sampling.parts.chosen =
        static_cast<uint16_t>(sampling.parts.chosen | (is_clear ? 1u : 0u) << sampling.index);
  }
  end_choice(state);
  return Status::ok;
}

uint32_t count_bits(uint16_t set) {
  uint32_t count = 0;
  for (; set != 0; set = static_cast<uint16_t>(set & (set - 1u))) {
    ++count;
  }
  return count;
}

// The chosen eyes of a subdivision are equally strong.
Status look_from_chosen(State& state) {
  Sampling& sampling = state.sampling;
  const uint32_t count = count_bits(sampling.parts.chosen);
  const uint16_t element = sampling.parts.element;
  const uint16_t face = flash_at(state.scene.elements, element).face;
  for (; sampling.index < places_of(sampling); ++sampling.index) {
    if ((static_cast<unsigned>(sampling.parts.chosen) >> sampling.index & 1u) == 0) {
      continue;
    }
    const uint32_t begin = kRowOne * sampling.eyes / count, end = kRowOne * (sampling.eyes + 1u) / count;
    const Vec3 position = eye_candidate(state.scene, element, sampling.level, sampling.index).position;
    const Status status = look(state, {position, face, end - begin, sampling.rows / count, true});
    if (status != Status::ok) {
      return status;
    }
  }
  sampling.stage = SamplingStage::complete;
  return Status::ok;
}

// Where a group's light leaves from: what an element has to send, all channels, cut to 25 bits, so that sums
// over a patch's elements fit 32; once faces alone keep account of that, its area, cut to 16 bits for the
// elements of a face.
uint32_t weight_of(const State& state, uint16_t e) {
  if (state.sweep.kind == SourceKind::face) {
    return (flash_at(state.scene.elements, e).area >> 16) + 1;
  }
  Flux unshot[kMaxChannels];
  return static_cast<uint32_t>(unshot_of(state, element_source(state.scene, e), unshot) >> 8) + 1;
}

uint16_t strongest_of(const State& state, const EyeSource& source) {
  uint16_t strongest = source_element(state.scene, source, 0);
  for (uint16_t i = 1; i < source.count; ++i) {
    const uint16_t e = source_element(state.scene, source, i);
    strongest = weight_of(state, e) > weight_of(state, strongest) ? e : strongest;
  }
  return strongest;
}

// The weight of the group's next element; 0 if its centroid is buried.
Status usable_weight(State& state, const EyeSource& source, uint32_t& weight) {
  if (is_used_up(state.work)) {
    return Status::in_progress;
  }
  const uint16_t e = source_element(state.scene, source, state.sampling.index);
  bool is_clear = false;
  const Status status = has_clear_centroid(state, e, is_clear);
  weight = is_clear ? weight_of(state, e) : 0;
  return status;
}

void to_next_element(State& state) {
  spend_on_stretch(state.work, ++state.sampling.index);
}

// Where no element has an eye to send from, the strongest one sends for all.
Status add_up_weights(State& state, const EyeSource& source) {
  Sampling& sampling = state.sampling;
  while (sampling.index < source.count) {
    uint32_t weight = 0;
    const Status status = usable_weight(state, source, weight);
    if (status != Status::ok) {
      return status;
    }
    sampling.total += weight;
    to_next_element(state);
  }
  if (sampling.total == 0) {
    begin_parts(state, strongest_of(state, source), 4);
  } else {
    sampling.index = 0;
    sampling.running = 0;
    sampling.stage = SamplingStage::draw;
  }
  return Status::ok;
}

uint32_t group_eyes(const State& state, const EyeSource& source) {
  const uint32_t rows = state.sampling.rows;
  const uint32_t wanted = (rows >> flash_at(state.settings.tables, 0).resolution_log2) + 1;
  const uint32_t most = source.count < kMostGroupEyes ? source.count : kMostGroupEyes;
  return wanted < most ? wanted : most;
}

// Golden-ratio steps from shot to shot, 1/65536 of a turn.
FIXRAD_MODULO uint32_t phase_of(uint32_t shots) {
  return (shots * 40503u) & 0xffffu;
}

// Eyes at centroids of a group's elements, drawn in proportion to what each has reflected: at equal steps
// along the running sum of weights, from a beginning that changes from shot to shot.
Status draw_eye(State& state, const EyeSource& source) {
  Sampling& sampling = state.sampling;
  const uint32_t eyes = group_eyes(state, source);
  if (sampling.eyes == eyes) {
    sampling.stage = SamplingStage::complete;
    return Status::ok;
  }
  const uint32_t step = sampling.total / eyes;
  const uint32_t target =
      static_cast<uint32_t>(wide_product(step, phase_of(state.shots)) >> 16) + sampling.eyes * step;
  for (;;) {
    uint32_t weight = 0;
    const Status status = usable_weight(state, source, weight);
    if (status != Status::ok) {
      return status;
    }
    if (sampling.running + weight > target) {
      sampling.stage = SamplingStage::look_drawn;
      return Status::ok;
    }
    sampling.running += weight;
    to_next_element(state);
  }
}

Status look_from_drawn(State& state, const EyeSource& source) {
  Sampling& sampling = state.sampling;
  const uint32_t eyes = group_eyes(state, source), k = sampling.eyes;
  const Status status =
      look_from_centroid(state, source_element(state.scene, source, sampling.index),
                         kRowOne * (k + 1) / eyes - kRowOne * k / eyes, sampling.rows / eyes, true);
  if (status == Status::ok) {
    sampling.stage = SamplingStage::draw;
  }
  return status;
}

Status look_from_whole(State& state, bool is_clear) {
  Sampling& sampling = state.sampling;
  const Status status = look_from_centroid(state, sampling.parts.element, kRowOne, sampling.rows, is_clear);
  if (status == Status::ok) {
    sampling.stage = SamplingStage::complete;
  }
  return status;
}

// Not a switch: its table of jumps would need a routine that an AVR's library alone has.
Status do_stage(State& state, const EyeSource& source) {
  const SamplingStage stage = state.sampling.stage;
  if (stage == SamplingStage::add_up) {
    return add_up_weights(state, source);
  }
  if (stage == SamplingStage::draw) {
    return draw_eye(state, source);
  }
  if (stage == SamplingStage::look_drawn) {
    return look_from_drawn(state, source);
  }
  if (stage == SamplingStage::try_centroid) {
    return try_centroid(state);
  }
  if (stage == SamplingStage::choose) {
    return choose_eyes(state);
  }
  if (stage == SamplingStage::look_chosen) {
    return look_from_chosen(state);
  }
  return look_from_whole(state, stage == SamplingStage::look_centroid);
}

// What an abandoned shot may have left goes.
void begin_row(State& state, uint32_t rows) {
  clear(state.row);
  forget_view(state.work);
  state.sampling = {};
  state.sampling.turn = state.turn;
  state.sampling.rows = static_cast<uint16_t>(rows < kMostRows ? rows : kMostRows);
  const Observer& observer = state.settings.observer;
  if (observer.on_withdraw != nullptr) {
    observer.on_withdraw(observer.context);
  }
}

}  // namespace

void begin_source(State& state, const EyeSource& source, uint64_t flux) {
  const uint64_t quarter = flux >> 2;
  const uint32_t all = quarter < 0xffffffffu ? static_cast<uint32_t>(quarter) : 0xffffffffu;
  begin_row(state, all / state.a_row + 1);
  if (source.kind == SourceKind::element) {
    begin_parts(state, source.first, all / state.an_eye + 1);
  } else {
    state.sampling.stage = SamplingStage::add_up;
  }
}

Status go_on_with_source(State& state, const EyeSource& source) {
  while (state.sampling.stage < SamplingStage::complete) {
    const Status status = do_stage(state, source);
    if (status != Status::ok) {
      if (status != Status::in_progress) {
        state.sampling.stage = SamplingStage::none;
      }
      return status;
    }
  }
  return Status::ok;
}

void book_eyes(State& state) {
  state.turn = state.sampling.turn;
  state.eyes += state.sampling.eyes;
  state.withdrawn += state.sampling.withdrawn;
  state.sampling.stage = SamplingStage::none;
}

Status sample_element(State& state, uint16_t element, uint32_t eyes, uint32_t rows) {
  begin_row(state, rows);
  begin_parts(state, element, eyes);
  state.work.budget = 0;
  const Status status = go_on_with_source(state, element_source(state.scene, element));
  if (status == Status::ok) {
    book_eyes(state);
  }
  return status;
}

}  // namespace fixrad
