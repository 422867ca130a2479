// SPDX-License-Identifier: MIT
#include "firmware/float_peer/sampling.h"

#include "firmware/float_peer/unshot.h"
#include "lib/fixed/product.h"

namespace fixrad {
namespace peer {
namespace {

constexpr float kBuriedShare = 0.5f;

// As in the core.
constexpr uint32_t kMostGroupEyes = 16;
constexpr uint32_t kEyesOfBuriedGroup = 4;

EyePoint eye_at(State& state, Vec3 position, uint16_t face) {
  const EyePoint eye = {position, face, state.turn};
  state.turn = static_cast<uint8_t>((state.turn + 1) % kTurns);
  return eye;
}

// The coarsest table with at least `rows` rows, or the finest.
LuneTable table_for(const State& state, uint32_t rows) {
  uint8_t log2 = state.coarsest;
  while (log2 < state.finest && (static_cast<uint32_t>(1) << log2) < rows) {
    ++log2;
  }
  return lune_table(log2);
}

Status look(State& state, const LuneTable& table, const EyePoint& eye, Backs open) {
  const Backs backs = state.is_closed ? Backs::none : open;
  const Status status = lune_rows(state.scene, table, eye, backs, state.work, state.row);
  state.eyes += status == Status::ok ? 1u : 0u;
  return status;
}

Status probe(State& state, const EyePoint& eye, bool& is_clear) {
  float share = 0.0f;
  const Status status = hidden_share(state.scene, state.probe, eye, state.is_enclosed, state.work, share);
  is_clear = share <= kBuriedShare;
  state.withdrawn += is_clear ? 0u : 1u;
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

Status look_from_centroid(State& state, uint16_t e, uint32_t rows, Backs open) {
  const Element element = flash_read(state.scene.elements, e);
  return look(state, table_for(state, rows), eye_at(state, vec(element.eye), element.face), open);
}

// The eyes of one element's subdivision, equally strong.
class ElementEyes {
 public:
  ElementEyes(State& state, uint16_t element, unsigned level)
      : state_(state), element_(element), level_(level) {}

  // Probes every candidate, unless all are known to be clear.
  Status choose() {
    const bool all_clear = sight_of(state_.scene, element_) == Sight::all_clear;
    const uint16_t face = flash_at(state_.scene.elements, element_).face;
    for (unsigned i = 0; i < level_ * level_; ++i) {
      const EyeCandidate candidate = eye_candidate(state_.scene, element_, level_, i);
      bool is_clear = candidate.is_used;
      const Status status =
          is_clear && !all_clear ? probe(state_, {candidate.position, face, 0}, is_clear) : Status::ok;
      if (status != Status::ok) {
        return status;
      }
      if (is_clear) {
        chosen_ = static_cast<uint16_t>(chosen_ | 1u << i);
        ++count_;
      }
    }
    return Status::ok;
  }

  unsigned count() const { return count_; }

  Status sample(uint32_t rows) {
    const LuneTable table = table_for(state_, rows / count_);
    const uint16_t face = flash_at(state_.scene.elements, element_).face;
    for (unsigned i = 0; i < level_ * level_; ++i) {
      if ((chosen_ >> i & 1u) == 0) {
        continue;
      }
      const EyeCandidate candidate = eye_candidate(state_.scene, element_, level_, i);
      const Status status = look(state_, table, eye_at(state_, candidate.position, face), Backs::unsealed);
      if (status != Status::ok) {
        return status;
      }
    }
    return Status::ok;
  }

 private:
  State& state_;
  uint16_t element_;
  unsigned level_;
  unsigned count_ = 0;
  uint16_t chosen_ = 0;
};

// All eyes are buried: as in the core, light stays in a contact within an enclosed scene, and leaves from the
// centroid elsewhere.
Status sample_buried(State& state, uint16_t element, uint32_t rows) {
  if (state.is_enclosed) {
    state.row.share[element] = state.row.whole = 1.0f;
    return Status::ok;
  }
  return look_from_centroid(state, element, rows, Backs::all);
}

Status sample_element(State& state, uint16_t element, uint32_t eyes, uint32_t rows) {
  unsigned level = level_for(eyes);
  if (level == 1) {
    bool is_clear = false;
    const Status status = has_clear_centroid(state, element, is_clear);
    if (status != Status::ok || is_clear) {
      return status != Status::ok ? status : look_from_centroid(state, element, rows, Backs::unsealed);
    }
    level = 2;
  }
  for (; level <= kFinestLevel; ++level) {
    ElementEyes set(state, element, level);
    const Status status = set.choose();
    if (status != Status::ok) {
      return status;
    }
    if (set.count() > 0) {
      return set.sample(rows);
    }
  }
  return sample_buried(state, element, rows);
}

// Integers as in the core, so that the running sum of what is drawn from ends where the total says.
uint32_t weight_of(const State& state, uint16_t e, Reflectances& reflectances) {
  constexpr float kFluxOfWeight = 131072.0f;
  if (state.sweep.kind == SourceKind::face) {
    return (flash_at(state.scene.elements, e).area >> 16) + 1;
  }
  const Channels unshot = unshot_of(state, element_source(state.scene, e), reflectances);
  return static_cast<uint32_t>(magnitude_of(state, unshot) * (1 / kFluxOfWeight)) + 1;
}

// Eyes at centroids of a group's elements, drawn in proportion to what each has to send: at equal steps along
// the running sum of weights, from a beginning that changes from shot to shot.
class GroupEyes {
 public:
  GroupEyes(State& state, const EyeSource& source)
      : state_(state), source_(source), reflectances_(state.scene) {}

  Status add_up() {
    for (uint16_t i = 0; i < source_.count; ++i) {
      uint32_t weight = 0;
      const Status status = usable_weight(i, weight);
      if (status != Status::ok) {
        return status;
      }
      total_ += weight;
    }
    return Status::ok;
  }

  uint32_t total() const { return total_; }

  Status sample(uint32_t eyes, uint32_t rows) {
    const LuneTable table = table_for(state_, rows / eyes);
    const uint32_t phase = (state_.shots * 40503u) & 0xffffu;  // golden-ratio steps
    const uint32_t step = total_ / eyes;
    uint32_t target = static_cast<uint32_t>(wide_product(step, phase) >> 16);
    uint32_t running = 0;
    uint16_t i = 0;
    for (uint32_t k = 0; k < eyes; ++k, target += step) {
      const Status status = pass_up_to(target, running, i);
      if (status != Status::ok) {
        return status;
      }
      const Element element = flash_read(state_.scene.elements, source_element(state_.scene, source_, i));
      const Status seen =
          look(state_, table, eye_at(state_, vec(element.eye), element.face), Backs::unsealed);
      if (seen != Status::ok) {
        return seen;
      }
    }
    return Status::ok;
  }

 private:
  // Moves to the element that the running sum of weights passes `target` in.
  Status pass_up_to(uint32_t target, uint32_t& running, uint16_t& i) {
    for (;; ++i) {
      uint32_t weight = 0;
      const Status status = usable_weight(i, weight);
      if (status != Status::ok || running + weight > target) {
        return status;
      }
      running += weight;
    }
  }

  Status usable_weight(uint16_t i, uint32_t& weight) {
    const uint16_t e = source_element(state_.scene, source_, i);
    bool is_clear = false;
    const Status status = has_clear_centroid(state_, e, is_clear);
    weight = is_clear ? weight_of(state_, e, reflectances_) : 0;
    return status;
  }

  State& state_;
  const EyeSource& source_;
  Reflectances reflectances_;
  uint32_t total_ = 0;
};

uint16_t strongest_of(const State& state, const EyeSource& source) {
  Reflectances reflectances(state.scene);
  uint16_t strongest = source_element(state.scene, source, 0);
  uint32_t most = weight_of(state, strongest, reflectances);
  for (uint16_t i = 1; i < source.count; ++i) {
    const uint16_t e = source_element(state.scene, source, i);
    const uint32_t weight = weight_of(state, e, reflectances);
    strongest = weight > most ? e : strongest;
    most = weight > most ? weight : most;
  }
  return strongest;
}

Status sample_group(State& state, const EyeSource& source, uint32_t rows) {
  GroupEyes group(state, source);
  const Status status = group.add_up();
  if (status != Status::ok) {
    return status;
  }
  if (group.total() == 0) {
    return sample_element(state, strongest_of(state, source), kEyesOfBuriedGroup, rows);
  }
  const uint32_t wanted = (rows >> state.coarsest) + 1;
  const uint32_t most = source.count < kMostGroupEyes ? source.count : kMostGroupEyes;
  return group.sample(wanted < most ? wanted : most, rows);
}

// How many rows, or eyes, a flux deserves at one for each such `part`; more than 2^16 are as good as that.
uint32_t deserved(float flux, float part) {
  constexpr float kMost = 65536.0f;
  return flux < kMost * part ? static_cast<uint32_t>(flux / part) + 1 : 65536u;
}

}  // namespace

Status sample_source(State& state, const EyeSource& source, float flux) {
  clear(state.row);
  const uint32_t rows = deserved(flux, state.a_row);
  return source.kind == SourceKind::element
             ? sample_element(state, source.first, deserved(flux, state.an_eye), rows)
             : sample_group(state, source, rows);
}

}  // namespace peer
}  // namespace fixrad
