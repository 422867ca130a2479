// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/bake/bake.h"

namespace fixrad::host {

/// The steps of a solution that cost something, in the order of the data. Names: kWorkNames.
enum WorkUnit : unsigned {
  kEye,         ///< eye points sampled
  kVertex,      ///< vertices turned into directions, once an eye and side
  kFace,        ///< faces asked whether an eye sees them
  kView,        ///< faces in view of an eye: plane and element grid
  kBandVertex,  ///< vertices sorted among the rows of a band
  kBandFace,    ///< faces in view sorted among the rows of a band
  kRow,         ///< rows of the hemisphere
  kInterval,    ///< faces crossing a row
  kMet,         ///< spans on the row before a face is inserted
  kSpan,        ///< visible spans
  kPiece,       ///< pieces of elements on visible spans, or on rows of pixels
  kPixelTest,   ///< pixels of the item buffer that a face covers
  kPixel,       ///< pixels of the item buffer
  kShare,       ///< receipts of flux: elements that a shot reaches, each channel
  kFaceShare,   ///< the same once faces keep account of what their elements have to send
  kElement,     ///< elements passed by at a shot
  kUnshot,      ///< unshot fluxes worked out, of elements or faces, each channel
  kWorkUnits
};
extern const std::array<const char*, kWorkUnits> kWorkNames;

using Work = std::array<std::uint64_t, kWorkUnits>;

/// Writes down what a solution does, so that its work can be counted afterwards. `state` is that of the run;
/// the recorder must stay where it is until the run ends.
class WorkRecorder {
 public:
  struct Eye {
    EyeSample sample;
    DeltaTable table;
  };

  explicit WorkRecorder(const State& state) : state_(&state) {}
  WorkRecorder(const WorkRecorder&) = delete;
  WorkRecorder& operator=(const WorkRecorder&) = delete;

  Observer observer();
  const std::vector<Eye>& eyes() const { return eyes_; }

  /// The part of the work that eyes do not tell: shares and unshot fluxes.
  const Work& transport() const { return transport_; }

 private:
  void take_shot(const Shot& shot);
  std::uint64_t unshot_fluxes(const Shot& shot);

  const State* state_;
  std::vector<Eye> eyes_;
  Work transport_ = {};
  std::optional<EyeSource> last_;  // that has shot in a pass
};

/// Counts the work of a recorded solution by running the geometry of every eye again, on all cores; integer
/// sums, so the order does not matter. Probes for buried eyes and passes without a shot are not counted.
/// Nothing for an engine whose steps are not known here. Cost: about that of the solution.
std::optional<Work> count_work(const BakeResult& result, const BakeOptions& options,
                               const WorkRecorder& recorder);

}  // namespace fixrad::host
