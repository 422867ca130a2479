// SPDX-License-Identifier: MIT
#include "host_sim/simulate/profile.h"

namespace fixrad::host {

const std::vector<Profile>& profiles() {
  static const std::vector<Profile> all = {
      {"tiny", 6 * 1024, 2, 32, 16, 120, 0.06, 0.05, "ATmega2560"},
      {"small", 13 * 1024, 4, 32, 16, 255, 0.04, 0.005, "Cortex-M0 (micro:bit)"},
      {"medium", 60 * 1024, 4, 64, 32, 800, 0.02, 0.005, "Cortex-M3, ESP8266, RV32IMC"},
      {"large", 480 * 1024, 4, 64, 32, 2000, 0.02, 0.005, "Cortex-M4F, M7"},
      {"host", 64 * 1024 * 1024, 8, 128, 64, 6000, 0.02, 0.002, "PC"},
  };
  return all;
}

std::optional<Profile> find_profile(const std::string& name) {
  for (const Profile& profile : profiles()) {
    if (profile.name == name) {
      return profile;
    }
  }
  return std::nullopt;
}

std::uint32_t ram_bytes(const Profile& profile, const Sizes& sizes) {
  return pool_bytes(sizes) + state_bytes(profile.pointer_bytes);
}

const DeltaTable* delta_table(int resolution) {
  switch (resolution) {
    case 8:
      return &kDelta8;
    case 16:
      return &kDelta16;
    case 32:
      return &kDelta32;
    case 64:
      return &kDelta64;
    case 128:
      return &kDelta128;
    default:
      return nullptr;
  }
}

const DeltaTable* lune_table(int resolution) {
  for (const DeltaTable& table : kLunes) {
    if (1 << table.resolution_log2 == resolution) {
      return &table;
    }
  }
  return nullptr;
}

}  // namespace fixrad::host
