// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"

namespace fixrad {

/// What shoots: one element by itself, the elements of a patch, or all elements of a face.
enum class SourceKind : uint8_t { element, patch, face };

/// Elements of one face that send light together.
struct EyeSource {
  SourceKind kind;
  uint16_t face;
  uint16_t first;  ///< element, or for a patch: into Scene::patch_elements
  uint16_t count;  ///< number of elements
};

EyeSource element_source(const Scene& scene, uint16_t element);
EyeSource patch_source(const Scene& scene, uint16_t patch);

/// All elements of the face whose first element is `first`; the elements of a face follow each other. Cost:
/// linear in them.
EyeSource face_source(const Scene& scene, uint16_t first);

/// The i-th element of the source.
inline uint16_t source_element(const Scene& scene, const EyeSource& source, uint16_t i) {
  const unsigned index = static_cast<unsigned>(source.first) + i;
  return source.kind == SourceKind::patch ? flash_read(scene.patch_elements, index)
                                          : static_cast<uint16_t>(index);
}

/// How finely an element is represented: level x level eyes. At 1 the eye is the centroid.
constexpr unsigned kFinestLevel = 3;

/// The coarsest level that has at least `wanted` eyes, or the finest.
unsigned level_for(uint32_t wanted);

/// One eye of an element: quarters of a grid unit.
struct EyeCandidate {
  Vec3 position;
  /// An element that is not a whole cell has its centroid for all eyes, and only one counts: others might lie
  /// outside of it, and behind a wall.
  bool is_used;
};

/// Eye `index` (0 .. level^2 - 1) of `element`. Eyes of a whole cell are the centres of a level x level
/// subdivision, so their mean is the centroid.
EyeCandidate eye_candidate(const Scene& scene, uint16_t element, unsigned level, unsigned index);

}  // namespace fixrad
