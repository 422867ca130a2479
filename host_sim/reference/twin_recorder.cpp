// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_recorder.h"

namespace fixrad::host {

Observer Recorder::observer() {
  Observer observer = {};
  observer.context = this;
  observer.on_eye = [](void* self, const DeltaTable& table, const EyeSample& sample) {
    static_cast<Recorder*>(self)->eyes_.push_back({sample, 1 << table.resolution_log2});
  };
  observer.on_shot = [](void* self, const Shot& shot) { static_cast<Recorder*>(self)->take_shot(shot); };
  observer.on_withdraw = [](void* self) { static_cast<Recorder*>(self)->withdraw(); };
  return observer;
}

void Recorder::forget_shots() {
  shots_.clear();
  eyes_.erase(eyes_.begin(), eyes_.begin() + static_cast<std::ptrdiff_t>(shot_eyes_));
  shot_eyes_ = 0;
}

void Recorder::take_shot(const Shot& shot) {
  RecordedShot recorded = {shot.is_emission, {}, shot_eyes_, eyes_.size() - shot_eyes_, {0, 0, 0}};
  for (std::uint16_t i = 0; i < shot.source.count; ++i) {
    recorded.elements.push_back(source_element(state_->scene, shot.source, i));
  }
  for (unsigned c = 0; c < state_->scene.channels; ++c) {
    recorded.more[c] = shot.amount[c].raw - shot.unshot[c].raw;
  }
  shots_.push_back(std::move(recorded));
  shot_eyes_ = eyes_.size();
}

}  // namespace fixrad::host
