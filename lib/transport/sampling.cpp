// SPDX-License-Identifier: MIT
#include "lib/transport/sampling.h"

namespace fixrad {
namespace {

constexpr uint32_t kBuriedShare = kRowOne / 2;

// The flux an element has to send, cut to 20 bits so that the weights of 64 eyes stay below 2^26; at
// least 1, so that an element that has received nothing yet still has an eye.
uint32_t weight_of(const State& state, uint16_t element) {
  uint64_t sum = 0;
  for (int c = 0; c < state.scene.channels; ++c) {
    sum += static_cast<uint64_t>(exitent_flux(state, element, c).raw);
  }
  return static_cast<uint32_t>(sum >> 13) + 1;  // three fluxes below 2^31
}

EyePoint eye_at(State& state, Vec3 position, uint16_t face) {
  const EyePoint eye = {position, face, state.turn};
  state.turn = static_cast<uint8_t>((state.turn + 1) % kTurns);
  return eye;
}

const FIXRAD_FLASH DeltaTable* weak_table(const Settings& settings) {
  return settings.coarse != nullptr ? settings.coarse : settings.table;
}

Status look(State& state, const FIXRAD_FLASH DeltaTable* from, const EyeSample& sample) {
  const Settings& settings = state.settings;
  const DeltaTable table = flash_read(from, 0);
  const Status status = settings.engine(state.scene, table, sample, state.work, state.row);
  if (status == Status::ok) {
    ++state.eyes;
    if (settings.observer.on_eye != nullptr) {
      settings.observer.on_eye(settings.observer.context, table, sample);
    }
  }
  return status;
}

Status is_buried(State& state, const EyePoint& eye, bool& buried) {
  uint32_t share = 0;
  const Status status = hidden_share(state.scene, flash_read(state.settings.probe, 0), eye, state.is_enclosed,
                                     state.work, share);
  buried = share > kBuriedShare;
  state.withdrawn += buried ? 1u : 0u;
  return status;
}

void withdraw(State& state) {
  clear(state.row);
  const Observer& observer = state.settings.observer;
  if (observer.on_withdraw != nullptr) {
    observer.on_withdraw(observer.context);
  }
}

// One eye at the centroid. In a closed scene back faces are left out of the view, so a probe has to ask
// first; in an open one the row itself tells.
Status sample_centroid(State& state, const EyeSource& source, KnownEyes& known) {
  const EyeSample sample = {eye_at(state, vec(source.centre), source.face), kRowOne, !state.is_closed};
  if (state.is_closed && (known & kCentroidClear) == 0) {
    bool buried = false;
    const Status status = is_buried(state, sample.eye, buried);
    if (status != Status::ok) {
      return status;
    }
    known = static_cast<KnownEyes>(known | (buried ? kCentroidBuried : kCentroidClear));
    if (buried) {
      return Status::ok;
    }
  }
  const Status status = look(state, weak_table(state.settings), sample);
  if (status == Status::ok && (known & kCentroidClear) == 0) {
    const bool buried = state.row.back > kBuriedShare;
    known = static_cast<KnownEyes>(known | (buried ? kCentroidBuried : kCentroidClear));
    if (buried) {
      ++state.withdrawn;
      withdraw(state);
    }
  }
  return status;
}

void keep_light(State& state, const EyeSource& source) {
  uint32_t given = 0;
  for (uint16_t i = 0; i < source.count; ++i) {
    const uint32_t end = kRowOne * (i + 1u) / source.count;
    state.row.share[source_element(state.scene, source, i)] += end - given;
    given = end;
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
        chosen_[i / 32] |= static_cast<uint32_t>(1) << (i % 32);
        total_ += weight_of(state_, candidate.element) * candidate.weight;
      }
    }
    return Status::ok;
  }

  uint32_t total() const { return total_; }

  // Eye i owns the part of kRowOne between its running weights, rounded down.
  Status sample() {
    uint32_t running = 0;
    for (uint16_t i = 0; i < count_; ++i) {
      if ((chosen_[i / 32] >> (i % 32) & 1u) == 0) {
        continue;
      }
      const EyeCandidate candidate = eye_candidate(state_.scene, source_, level_, i);
      const uint32_t begin = part(running);
      running += weight_of(state_, candidate.element) * candidate.weight;
      const uint32_t weight = part(running) - begin;
      const EyePoint eye = eye_at(state_, candidate.position, source_.face);
      const Status status =
          weight == 0 ? Status::ok : look(state_, state_.settings.table, {eye, weight, !state_.is_closed});
      if (status != Status::ok) {
        return status;
      }
    }
    return Status::ok;
  }

 private:
  // 16 bits of a weight are enough, and keep the quotient in 32.
  uint32_t part(uint32_t running) const {
    const int bits = bit_length(total_);
    const int shift = bits > 16 ? bits - 16 : 0;
    return (((running >> shift) << 16) / (total_ >> shift)) << 4;
  }

  State& state_;
  const EyeSource& source_;
  int level_;
  uint16_t count_;
  uint32_t chosen_[kMaxEyes / 32] = {0, 0};
  uint32_t total_ = 0;
};

}  // namespace

Status sample_source(State& state, const EyeSource& source, uint32_t wanted, KnownEyes& known) {
  withdraw(state);  // what an abandoned shot may have left
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
    if (eyes.total() > 0) {
      return eyes.sample();
    }
  }
  // All buried. In an enclosed scene the face lies in contact with another: its light stays there until it is
  // absorbed. Elsewhere what little arrived leaves from the centroid.
  if (state.is_enclosed) {
    keep_light(state, source);
    return Status::ok;
  }
  return look(state, weak_table(state.settings),
              {eye_at(state, vec(source.centre), source.face), kRowOne, !state.is_closed});
}

}  // namespace fixrad
