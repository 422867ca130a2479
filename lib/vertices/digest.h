// SPDX-License-Identifier: MIT
#pragma once

#include "lib/vertices/vertex_radiosity.h"

namespace fixrad {

/// FNV-1a, 64 bits, over the received flux of every element and channel, then every vertex radiosity and
/// channel, each as four bytes, least significant first. Equal digests: the same solution, bit for bit.
uint64_t digest(const State& state, const VertexMap& map);

/// The same with radiosities that stand in place of the mean round each vertex, such as gather_vertex()
/// gives.
/// @param displayed  [count], vertex by vertex, the scene's channels of each
uint64_t digest(const State& state, const Radiosity* displayed, uint32_t count);

}  // namespace fixrad
