// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/fixrad.h"

namespace fixrad::host {

/// A class of devices: the memory that the solver may take on them, and what the tool chooses for it.
struct Profile {
  std::string name;
  std::uint32_t ram_bytes;
  std::uint32_t pointer_bytes;  ///< of the typical chip
  int lunes;                    ///< R of lune rows, for the strongest shots
  int hemicube;                 ///< R of a hemicube, whose R rows are 3 R with its sides
  std::uint32_t elements;       ///< that its accuracy needs
  double flux_of_rows;          ///< flux_per_row times the number of elements
  double flux_per_eye;
  std::string chip;
};

/// tiny, small, medium, large, host.
const std::vector<Profile>& profiles();

/// The profile of that name, if there is one.
std::optional<Profile> find_profile(const std::string& name);

/// Bytes that a solver of these sizes takes on the profile's chip, stack and flash apart.
std::uint32_t ram_bytes(const Profile& profile, const Sizes& sizes);

/// The delta form-factor table of R = 8, 16, 32, 64 or 128, of a hemicube or (also R = 4) of lunes; null for
/// others.
const DeltaTable* delta_table(int resolution);
const DeltaTable* lune_table(int resolution);

}  // namespace fixrad::host
