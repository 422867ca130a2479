// SPDX-License-Identifier: MIT
#include "tests/lib/sources.h"

#include <algorithm>

namespace fixrad::host {

std::uint64_t unshot_flux(const State& state, const EyeSource& source) {
  std::uint64_t sum = 0;
  if (source.kind == SourceKind::face && state.sweep.kind == SourceKind::face) {
    Flux unshot[kMaxChannels];
    return unshot_of(state, source, unshot);
  }
  for (int c = 0; c < state.scene.channels; ++c) {
    std::int64_t flux = 0;
    for (std::uint16_t i = 0; i < source.count; ++i) {
      const std::uint16_t e = source_element(state.scene, source, i);
      flux += std::int64_t{reflected_flux(state, e, c).raw} - std::int64_t{sent_flux(state, e, c)};
    }
    sum += static_cast<std::uint64_t>(std::abs(flux));
  }
  return sum;
}

std::vector<EyeSource> sources_of(const Scene& scene, SourceKind kind) {
  std::vector<EyeSource> sources;
  if (kind == SourceKind::patch) {
    for (std::uint16_t p = 0; p < scene.patch_count; ++p) {
      sources.push_back(patch_source(scene, p));
    }
    return sources;
  }
  for (std::uint16_t e = 0; e < scene.element_count;) {
    sources.push_back(kind == SourceKind::face ? face_source(scene, e) : element_source(scene, e));
    e = static_cast<std::uint16_t>(e + sources.back().count);
  }
  return sources;
}

std::uint64_t largest_unshot(const State& state, SourceKind kind) {
  std::uint64_t largest = 0;
  for (const EyeSource& source : sources_of(state.scene, kind)) {
    largest = std::max(largest, unshot_flux(state, source));
  }
  return largest;
}

ShotWatch::ShotWatch(Solution& solution) : state_(solution.state()) {
  state_.settings.observer.context = this;
  state_.settings.observer.on_shot = [](void* self, const Shot& shot) {
    static_cast<ShotWatch*>(self)->shot_ = shot;
  };
}

// Which kind comes next is not known before the shot, so the largest of each is looked up. A pass whose
// threshold is that of the last one needs no telling apart.
Status ShotWatch::next(SeenShot& seen) {
  constexpr SourceKind kKinds[] = {SourceKind::element, SourceKind::patch, SourceKind::face};
  std::uint64_t largest[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_over = static_cast<int>(kKinds[k]) < static_cast<int>(state_.sweep.kind);
    largest[k] = is_over ? 0 : largest_unshot(state_, kKinds[k]);
  }
  const Status status = shoot(state_);
  if (status != Status::ok) {
    return status;
  }
  const EyeSource &now = shot_.source, &before = last_.shot.source;
  seen.shot = shot_;
  seen.begins_pass =
      !shot_.is_emission && (last_.shot.is_emission || now.kind != before.kind || now.first <= before.first ||
                             state_.sweep.threshold != last_threshold_);
  seen.largest = seen.begins_pass ? largest[static_cast<std::size_t>(now.kind)] : last_.largest;
  last_ = seen;
  last_threshold_ = state_.sweep.threshold;
  return Status::ok;
}

}  // namespace fixrad::host
