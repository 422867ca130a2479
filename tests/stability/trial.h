// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lib/scene/status.h"
#include "tests/stability/hard_case.h"

namespace fixrad::host {

/// How one arithmetic fared with a case.
struct Verdict {
  bool has_solved = false;        ///< every model came to its end; the rest means something only then
  std::vector<Finding> findings;  ///< what theory expects; those of the twin and peer bind nobody
  double imbalance = 0;           ///< of the ledger, over what is emitted, worst channel and model
  double escaped = 0, back = 0;   ///< over what is emitted, likewise

  /// The finding that uses up most of its bound.
  const Finding& worst() const;
};

/// What came of a case: the fixed-point core, its twin in double (the same shots), the float peer.
struct Trial {
  Verdict fixed, twin, peer;
  Status status = Status::ok;  ///< converged, or why the core did not come to its end
  Status peer_status =
      Status::ok;  ///< likewise of the peer; ok: it was still shooting after four times as many shots
  std::uint64_t shots = 0;      ///< of all models
  std::int64_t imbalance = 0;   ///< largest of all channels' ledgers, flux units, at any look
  std::uint32_t saturated = 0;  ///< elements whose radiosity is the largest that 32 bits hold
  std::uint32_t rises = 0;      ///< shots after which the sum of |unshot| had grown
};

/// Who takes part beside the core.
struct Rivals {
  bool twin = true, peer = true;
};

/// More than any case takes: shooting that does not come to its end is to fail, not to hang.
constexpr std::uint64_t kMostShots = 20000000;

/// Solves all models of a case in arrays that hold them exactly. Cost: the shots, about twenty times as much
/// with the twin.
Trial try_case(const HardCase& hard, Rivals rivals);

/// The scene as the case wants it meshed, with what the tool finds out about its eyes beforehand.
DeviceScene mesh_case(const PreparedScene& prepared, const CaseSettings& settings);

/// The core's settings for a case.
Settings settings_of(const CaseSettings& settings);

}  // namespace fixrad::host
