// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// What a line parts. Umbra: nothing of the lamp is seen on one side of it; penumbra: all of the lamp is seen
/// on one side; inner: the part that is seen changes its shape there; contact: something stands on the face
/// there.
enum class CriticalKind : std::uint8_t { umbra, penumbra, inner, contact };

/// A straight line on a face where the direct light of a lamp is not smooth: the trace of a vertex-edge
/// event.
struct CriticalLine {
  std::uint32_t face = 0;     ///< into PreparedScene::faces
  glm::dvec2 a{0.0}, b{0.0};  ///< its ends, (s, t) of the face's frame
  CriticalKind kind = CriticalKind::inner;
  /// Which derivative of the irradiance jumps: 0 the irradiance itself, 1 its slope (an edge of the lamp and
  /// an edge that casts the shadow lie in one plane), 2 its curvature.
  int order = 2;
  double irradiance =
      0;              ///< what the whole lamp would give to the line's middle, W/m^2, mean of the channels
  double width = 1;   ///< across which the light changes by that much, grid units, >= 1
  double length = 0;  ///< grid units
};

struct CriticalLineOptions {
  std::size_t most_lamps = 16;  ///< faces of most emitted flux whose events are traced
  double separation = 4;        ///< grid units; a line that runs this near to a stronger one is left out
};

/// The critical lines of a scene's lamps (every face with emission is one): for each vertex of a lamp and
/// each edge that casts a shadow, and for each edge of a lamp and each vertex that does, the plane through
/// both is cut with all faces, and what its light falls on becomes a line (P. Heckbert, "Discontinuity
/// meshing for radiosity", Eurographics Workshop on Rendering 1992; D. Lischinski, F. Tampieri, D. Greenberg,
/// IEEE CG&A 12(6), 1992). Contact lines come with them. Left out: events of three edges, whose surfaces are
/// curved, and those of reflected light.
///
/// Pieces of one line are joined; lines along the border of their own face are left out. Ordered by face,
/// then by falling importance; the same input gives the same lines in the same order. Never throws for a
/// prepared scene. Cost: lamp vertices x shadow edges x faces.
std::vector<CriticalLine> find_critical_lines(const PreparedScene& scene,
                                              const CriticalLineOptions& options = {});

/// About how much light, in W/m^2 x square grid units, lies on the wrong side if elements of size `h` (grid
/// units) ignore the line: the irradiance that changes across one element, times the strip of elements that
/// it crosses.
double misplaced_light(const CriticalLine& line, double h);

}  // namespace fixrad::host
