// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"

namespace fixrad {

/// Elements that send light together: a patch, or one element by itself.
struct EyeSource {
  uint16_t face;
  uint16_t first;      ///< into Scene::patch_elements, or the element itself
  uint16_t count;      ///< number of elements
  bool is_single;      ///< `first` is an element
  bool is_clear;       ///< none of its eye points is buried
  uint16_t centre[3];  ///< centroid, lifted off the face; quarters of a grid unit
};

EyeSource patch_source(const Scene& scene, uint16_t patch);
EyeSource element_source(const Scene& scene, uint16_t element);

/// The i-th element of the source.
uint16_t source_element(const Scene& scene, const EyeSource& source, uint16_t i);

/// How finely a source is represented: 0 one eye at its centroid, n > 0: n x n eyes in every element.
constexpr int kFinestLevel = 3;
constexpr uint16_t kMaxEyes = 64;

/// Number of candidate eyes at `level`.
inline uint16_t candidate_count(const EyeSource& source, int level) {
  return level == 0 ? static_cast<uint16_t>(1)
                    : static_cast<uint16_t>(source.count * static_cast<unsigned>(level * level));
}

/// The coarsest level that has at least `wanted` eyes, as far as kMaxEyes allows.
int level_for(const EyeSource& source, uint32_t wanted);

/// One candidate: where it is, which element it stands for (level > 0), and its weight among the level^2 eyes
/// of that element; 0: not used. Eyes of a whole cell are the centres of a level x level subdivision, so
/// their mean is the centroid; a cell cut by the face's border uses its centroid alone.
struct EyeCandidate {
  Vec3 position;  ///< quarters of a grid unit
  uint16_t element;
  uint8_t weight;
};
EyeCandidate eye_candidate(const Scene& scene, const EyeSource& source, int level, uint16_t index);

}  // namespace fixrad
