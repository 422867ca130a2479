// SPDX-License-Identifier: MIT
#pragma once

#include "lib/form_factor/engine.h"
#include "lib/form_factor/pair_factor.h"

namespace fixrad {

/// The pairs of one eye of ray_row(): its element as a source, and what lies between it and a target. Large
/// (700 bytes), meant for the stack.
class RayPairs {
 public:
  /// 2^`log2` rays a pair. Uses work.views. Cost: a cut of the eye's element, and
  /// RayBlockers::enter_source().
  RayPairs(const Scene& scene, const EyeSample& sample, int log2, Workspace& work);

  const ContourPoint& eye() const { return eye_; }
  const AreaSource& source() const { return source_; }
  int log2() const { return log2_; }

  /// Targets lie on face `index` until the next call.
  void enter_target(uint16_t index) { blockers_.enter_target(index); }

  /// An eye that stands for a whole element alone is too little where the other is nearer than twice the
  /// larger one's size: then the mean over the source counts.
  bool is_near(uint16_t element) const;

  /// How many of the rays to `target` arrive; `slot` (an element, or kBackSlot) names the pair.
  uint32_t free_rays(uint16_t slot, const Polygon& target);

 private:
  const Scene& scene_;
  const EyeSample& sample_;
  int log2_;
  Face face_;
  ContourPoint eye_;
  ElementCells cells_;
  AreaSource source_;
  RayBlockers blockers_;
};

}  // namespace fixrad
