// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/report/picture_table.h"
#include "lib/fixrad.h"

namespace fixrad::host {

/// A scene in the core's records with all that a firmware needs to solve it, and what must come out there.
/// Its pointers belong to the caller.
struct SceneTable {
  std::string source;         ///< the file that the scene was read from, without folder
  std::string profile;        ///< whose memory it was planned for
  std::string chip;           ///< that the profile stands for
  Scene scene = {};           ///< load() accepts it
  VertexMap map = {};         ///< of the same scene
  Sizes sizes = {};           ///< of the solver: the parameters of Limits
  Settings settings;          ///< but for the observer, which has no place on a device
  double unit_watts = 1;      ///< one unit of flux, W
  double unit_radiosity = 1;  ///< one unit of radiosity, W/m^2
  std::uint64_t digest = 0;
  std::uint32_t shots = 0, eyes = 0;
  std::vector<Ledger> ledger;           ///< one a channel
  std::vector<std::int32_t> received;   ///< [element][channel]
  std::optional<PictureTable> picture;  ///< what the device is to draw
  std::uint64_t picture_digest = 0;     ///< of its pixels
};

/// A freestanding C++17 header: the scene as constexpr tables for flash, the type of its solver, and the
/// expected solution as the namespace `expected`. Its namespace is namespace_name() of the file's stem. The
/// same bytes for the same table on every machine. Throws InputError if the file cannot be written, as the
/// writers of writers.h do.
void write_scene(const std::filesystem::path& target, const SceneTable& table);

}  // namespace fixrad::host
