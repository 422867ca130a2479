// SPDX-License-Identifier: MIT
#include "firmware/float_peer/sampling.h"

namespace fixrad {
namespace peer {
namespace {

constexpr float kBuriedShare = 0.5f;

// What an element that has received nothing yet counts for, as in the core.
constexpr float kLeastWeight = 8192.0f;

float weight_of(const State& state, uint16_t element) {
  float sum = kLeastWeight;
  for (uint8_t c = 0; c < state.scene.channels; ++c) {
    sum += exitent_flux(state, element, c);
  }
  return sum;
}

EyePoint eye_at(State& state, Vec3 position, uint16_t face) {
  const EyePoint eye = {position, face, state.turn};
  state.turn = static_cast<uint8_t>((state.turn + 1) % kTurns);
  return eye;
}

Status look(State& state, const LuneTable& table, const EyePoint& eye, float weight, bool is_whole) {
  const EyeSample sample = {eye, weight, is_whole, !state.is_closed};
  const Status status = lune_rows(state.scene, table, sample, state.work, state.row);
  state.eyes += status == Status::ok ? 1u : 0u;
  return status;
}

Status is_buried(State& state, const EyePoint& eye, bool& buried) {
  float share = 0.0f;
  const Status status = hidden_share(state.scene, state.probe, eye, state.is_enclosed, state.work, share);
  buried = share > kBuriedShare;
  state.withdrawn += buried ? 1u : 0u;
  return status;
}

// One eye at the centroid. In a closed scene back faces are left out of the view, so a probe has to ask
// first; in an open one the row itself tells.
Status sample_centroid(State& state, const EyeSource& source, KnownEyes& known) {
  const EyePoint eye = eye_at(state, vec(source.centre), source.face);
  if (state.is_closed && (known & kCentroidClear) == 0) {
    bool buried = false;
    const Status status = is_buried(state, eye, buried);
    if (status != Status::ok) {
      return status;
    }
    known = static_cast<KnownEyes>(known | (buried ? kCentroidBuried : kCentroidClear));
    if (buried) {
      return Status::ok;
    }
  }
  const Status status = look(state, state.coarse, eye, 1.0f, true);
  if (status == Status::ok && (known & kCentroidClear) == 0) {
    const bool buried = state.row.back > kBuriedShare * state.row.whole;
    known = static_cast<KnownEyes>(known | (buried ? kCentroidBuried : kCentroidClear));
    if (buried) {
      ++state.withdrawn;
      clear(state.row);
    }
  }
  return status;
}

void keep_light(State& state, const EyeSource& source) {
  const float part = 1.0f / static_cast<float>(source.count);  // row.whole is 1
  for (uint16_t i = 0; i < source.count; ++i) {
    state.row.share[source_element(state.scene, source, i)] += part;
  }
}

class EyeSet {
 public:
  EyeSet(State& state, const EyeSource& source, int level)
      : state_(state), source_(source), level_(level), count_(candidate_count(source, level)) {}

  // Probes every candidate, unless all are known to be clear; `total` is the weight of those that are.
  Status choose() {
    for (uint16_t i = 0; i < count_; ++i) {
      const EyeCandidate candidate = eye_candidate(state_.scene, source_, level_, i);
      if (candidate.weight == 0) {
        continue;
      }
      bool buried = false;
      const Status status =
          source_.is_clear ? Status::ok : is_buried(state_, {candidate.position, source_.face, 0}, buried);
      if (status != Status::ok) {
        return status;
      }
      if (!buried) {
        chosen_[i / 8] = static_cast<uint8_t>(chosen_[i / 8] | 1u << (i % 8));
        total_ += weight_of(state_, candidate.element) * static_cast<float>(candidate.weight);
      }
    }
    return Status::ok;
  }

  float total() const { return total_; }

  Status sample() {
    const float scale = 1.0f / total_;
    for (uint16_t i = 0; i < count_; ++i) {
      if ((chosen_[i / 8] >> (i % 8) & 1u) == 0) {
        continue;
      }
      const EyeCandidate candidate = eye_candidate(state_.scene, source_, level_, i);
      const float weight =
          weight_of(state_, candidate.element) * static_cast<float>(candidate.weight) * scale;
      const Status status =
          look(state_, state_.table, eye_at(state_, candidate.position, source_.face), weight, false);
      if (status != Status::ok) {
        return status;
      }
    }
    return Status::ok;
  }

 private:
  State& state_;
  const EyeSource& source_;
  int level_;
  uint16_t count_;
  uint8_t chosen_[kMaxEyes / 8] = {};
  float total_ = 0.0f;
};

}  // namespace

Status sample_source(State& state, const EyeSource& source, uint16_t wanted, KnownEyes& known) {
  clear(state.row);
  known = source.is_clear ? kCentroidClear : known;
  int level = level_for(source, wanted);
  if (level == 0) {
    if ((known & kCentroidBuried) == 0) {
      const Status status = sample_centroid(state, source, known);
      if (status != Status::ok || (known & kCentroidClear) != 0) {
        return status;
      }
    }
    level = source.count > 1 ? 1 : 2;
  }
  for (; level <= kFinestLevel && candidate_count(source, level) <= kMaxEyes; ++level) {
    EyeSet eyes(state, source, level);
    const Status status = eyes.choose();
    if (status != Status::ok) {
      return status;
    }
    if (eyes.total() > 0.0f) {
      return eyes.sample();
    }
  }
  // All buried: as in the core, light stays in a contact within an enclosed scene, and leaves from the
  // centroid elsewhere.
  if (state.is_enclosed) {
    keep_light(state, source);
    return Status::ok;
  }
  return look(state, state.coarse, eye_at(state, vec(source.centre), source.face), 1.0f, true);
}

}  // namespace peer
}  // namespace fixrad
