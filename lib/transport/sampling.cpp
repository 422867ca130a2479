// SPDX-License-Identifier: MIT
#include "lib/transport/sampling.h"

#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

// More eyes than this do not pay for a patch or a face, whose light is the weak rest of the scene's.
constexpr uint32_t kMostGroupEyes = 16;

EyePoint eye_at(State& state, Vec3 position, uint16_t face) {
  const EyePoint eye = {position, face, state.turn};
  state.turn = static_cast<uint8_t>((state.turn + 1) % kTurns);
  return eye;
}

// The coarsest table with at least `rows` rows, or the finest.
DeltaTable table_for(const Settings& settings, uint32_t rows) {
  uint8_t i = 0;
  const uint8_t coarsest = flash_at(settings.tables, 0).resolution_log2;
  while (i + 1 < settings.table_count && (static_cast<uint32_t>(1) << (coarsest + i)) < rows) {
    ++i;
  }
  return flash_read(settings.tables, i);
}

Status look(State& state, const DeltaTable& table, const EyeSample& sample) {
  const Settings& settings = state.settings;
  const Status status = settings.engine(state.scene, table, sample, state.work, state.row);
  if (status == Status::ok) {
    ++state.eyes;
    if (settings.observer.on_eye != nullptr) {
      settings.observer.on_eye(settings.observer.context, table, sample);
    }
  }
  return status;
}

Status probe(State& state, const EyePoint& eye, bool& is_clear) {
  uint32_t share = 0;
  const Status status = hidden_share(state.scene, flash_read(state.settings.probe, 0), eye, state.is_enclosed,
                                     state.work, share);
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

Status look_from_centroid(State& state, uint16_t e, uint32_t weight, uint32_t rows, bool is_clear) {
  const Element element = flash_read(state.scene.elements, e);
  return look(state, table_for(state.settings, rows),
              {eye_at(state, vec(element.eye), element.face), weight, !state.is_closed, is_clear});
}

// The eyes of one element's subdivision, equally strong.
class ElementEyes {
 public:
  ElementEyes(State& state, uint16_t element, unsigned level)
      : state_(state), element_(element), level_(level) {}

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
    const DeltaTable table = table_for(state_.settings, rows / count_);
    const uint16_t face = flash_at(state_.scene.elements, element_).face;
    uint32_t begin = 0;
    unsigned done = 0;
    for (unsigned i = 0; i < level_ * level_; ++i) {
      if ((chosen_ >> i & 1u) == 0) {
        continue;
      }
      const uint32_t end = kRowOne * ++done / count_;
      const EyePoint eye = eye_at(state_, eye_candidate(state_.scene, element_, level_, i).position, face);
      const Status status = look(state_, table, {eye, end - begin, !state_.is_closed, true});
      if (status != Status::ok) {
        return status;
      }
      begin = end;
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

// All eyes are buried. In an enclosed scene the element lies in contact with another face: its light stays
// there until it is absorbed. Elsewhere what little arrived leaves from the centroid.
Status sample_buried(State& state, uint16_t element, uint32_t rows) {
  if (state.is_enclosed) {
    state.row.share[element] += kRowOne;
    return Status::ok;
  }
  return look_from_centroid(state, element, kRowOne, rows, false);
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

// Eyes at centroids of a group's elements, drawn in proportion to what each has reflected: at equal steps
// along the running sum of weights, from a beginning that changes from shot to shot.
class GroupEyes {
 public:
  GroupEyes(State& state, const EyeSource& source) : state_(state), source_(source) {}

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

  FIXRAD_MODULO Status sample(uint32_t eyes, uint32_t rows) {
    const uint32_t phase = (state_.shots * 40503u) & 0xffffu;  // golden-ratio steps
    const uint32_t step = total_ / eyes;
    uint32_t target = static_cast<uint32_t>(wide_product(step, phase) >> 16);
    uint32_t running = 0;
    uint16_t i = 0;
    for (uint32_t k = 0; k < eyes; ++k, target += step) {
      uint32_t weight = 0;
      for (;; ++i) {
        const Status status = usable_weight(i, weight);
        if (status != Status::ok) {
          return status;
        }
        if (running + weight > target) {
          break;
        }
        running += weight;
      }
      const Status status =
          look_from_centroid(state_, source_element(state_.scene, source_, i),
                             kRowOne * (k + 1) / eyes - kRowOne * k / eyes, rows / eyes, true);
      if (status != Status::ok) {
        return status;
      }
    }
    return Status::ok;
  }

 private:
  Status usable_weight(uint16_t i, uint32_t& weight) {
    const uint16_t e = source_element(state_.scene, source_, i);
    bool is_clear = false;
    const Status status = has_clear_centroid(state_, e, is_clear);
    weight = is_clear ? weight_of(state_, e) : 0;
    return status;
  }

  State& state_;
  const EyeSource& source_;
  uint32_t total_ = 0;
};

uint16_t strongest_of(const State& state, const EyeSource& source) {
  uint16_t strongest = source_element(state.scene, source, 0);
  for (uint16_t i = 1; i < source.count; ++i) {
    const uint16_t e = source_element(state.scene, source, i);
    strongest = weight_of(state, e) > weight_of(state, strongest) ? e : strongest;
  }
  return strongest;
}

// `is_buried` where no element has an eye to send from.
__attribute__((noinline)) Status sample_group(State& state, const EyeSource& source, uint32_t rows,
                                              bool& is_buried) {
  GroupEyes group(state, source);
  const Status status = group.add_up();
  if (status != Status::ok) {
    return status;
  }
  is_buried = group.total() == 0;
  if (is_buried) {
    return Status::ok;
  }
  const uint32_t wanted = (rows >> flash_at(state.settings.tables, 0).resolution_log2) + 1;
  const uint32_t most = source.count < kMostGroupEyes ? source.count : kMostGroupEyes;
  return group.sample(wanted < most ? wanted : most, rows);
}

void withdraw(State& state) {
  clear(state.row);
  const Observer& observer = state.settings.observer;
  if (observer.on_withdraw != nullptr) {
    observer.on_withdraw(observer.context);
  }
}

}  // namespace

Status sample_element(State& state, uint16_t element, uint32_t eyes, uint32_t rows) {
  withdraw(state);  // what an abandoned shot may have left
  unsigned level = level_for(eyes);
  if (level == 1) {
    bool is_clear = false;
    const Status status = has_clear_centroid(state, element, is_clear);
    if (status != Status::ok || is_clear) {
      return status != Status::ok ? status : look_from_centroid(state, element, kRowOne, rows, true);
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

Status sample_source(State& state, const EyeSource& source, uint64_t flux) {
  const uint64_t quarter = flux >> 2;
  const uint32_t all = quarter < 0xffffffffu ? static_cast<uint32_t>(quarter) : 0xffffffffu;
  const uint32_t rows = all / state.a_row + 1;
  if (source.kind == SourceKind::element) {
    const uint32_t eyes = all / state.an_eye + 1;
    return sample_element(state, source.first, eyes, rows);
  }
  withdraw(state);
  bool is_buried = false;
  const Status status = sample_group(state, source, rows, is_buried);
  return is_buried ? sample_element(state, strongest_of(state, source), 4, rows) : status;
}

}  // namespace fixrad
