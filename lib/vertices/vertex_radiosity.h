// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/transport/state.h"

namespace fixrad {

constexpr uint32_t kNoVertex = 0xffffffff;

/// A vertex of the displayed mesh: the elements that meet there, all of one smooth surface. A vertex at the
/// border of its surface also names the interior vertex on the other side of its elements.
struct MeshVertex {
  uint32_t first;  ///< into VertexMap::elements
  uint32_t inner;  ///< an interior vertex, or kNoVertex
  uint8_t count;   ///< 1..255
};

/// The displayed mesh, in flash. Made by the host tool.
struct VertexMap {
  const FIXRAD_FLASH MeshVertex* vertices;
  const FIXRAD_FLASH uint16_t* elements;
  uint32_t vertex_count;
};

/// Radiosity at a vertex, one channel (Cohen & Greenberg 1985, section 7): the mean of the elements round it;
/// at the border of a smooth surface extrapolated, twice that mean less the interior vertex opposite, kept
/// within 0 and twice the mean so that it neither goes dark nor rings. Cost: one division an element met.
Radiosity vertex_radiosity(const State& state, const VertexMap& map, uint32_t vertex, int channel,
                           Radiosity ambient);

}  // namespace fixrad
