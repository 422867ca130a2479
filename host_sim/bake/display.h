// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/bake/bake.h"

namespace fixrad::host {

/// As DisplayOptions::shortest_edge: nothing is cut.
constexpr double kCornersOnly = 1.0;

/// How finely the displayed mesh may be cut.
struct DisplayOptions {
  /// No edge is cut into parts shorter than this fraction of the scene's longest side; kCornersOnly
  /// leaves those of the elements alone.
  double shortest_edge = 1.0 / 64;
};

/// Replaces the mean round each vertex of `result` by a gather at each vertex, on a mesh that is cut where
/// the gathered light bends: an edge is halved, with the triangles on both its sides, while the irradiance in
/// its middle is off the mean of its ends by more than a sixtieth of its own and the scene's mean together,
/// halved; also where one end lies under something, whose border then runs through the edge. A vertex of
/// which all gather points are buried takes the mean of its neighbours that are not, so that no darkness
/// leaks from under an object onto the floor beside it. Solution, elements and digest stay as they are;
/// surface, vertex_radiosity, display, display_seconds and display_digest change. The same bits on every
/// machine, with any number of threads.
/// @return false if `progress` said to stop; `result` is then as it was
/// Cost: two to four views of 64 lunes a vertex, of which there are three to seven times as many as corners
/// of elements.
bool gather_display(BakeResult& result, const DisplayOptions& options = {}, const Progress& progress = {});

}  // namespace fixrad::host
