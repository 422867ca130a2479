// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/irradiance.h"

namespace fixrad {

/// Where a vertex of the displayed mesh gathers: a point of an element that meets there, so little inside it
/// that it stands for the vertex, and lifted off the face as an element's eye is. At the vertex itself the
/// faces of a corner are seen edge-on. In flash, made by the host tool.
struct GatherPoint {
  uint16_t position[3];  ///< quarters of a grid unit
  uint16_t element;
};

/// What a vertex has gathered, the scene's radiosity unit.
struct VertexLight {
  Radiosity irradiance[kMaxChannels];
  Radiosity radiosity[kMaxChannels];
  uint8_t clear_points;  ///< how many points it is the mean of; 0: all are buried, and all light is 0
};

/// Radiosity at a vertex by a gather there (Cohen & Wallace 1993, section 10.3.2), in place of the mean round
/// it: emission + reflectance x the mean irradiance of the first `enough` of its `points` [count, 1..255]
/// that are clear. They lie on elements of one material. Points that stand in or under something
/// (settings.probe) are left out: beside a contact only the lit side counts. Nothing is extrapolated, so the
/// result is at least the emission and at most what the brightest element would give by itself; the means
/// round down, the products too. `table`: for the solver's engine; each point has its own turn of the axis,
/// the first point turn 0, so that a vertex depends on nothing but the solution. `direct` and `ambient`
/// [channels] as in gather_irradiance(), whose scratch memory and statuses these are. Cost: a probe and a
/// view a point.
Status gather_vertex(State& state, const DeltaTable& table, DirectLight direct,
                     const FIXRAD_FLASH GatherPoint* points, uint8_t count, uint8_t enough,
                     const Radiosity* ambient, VertexLight& light);

}  // namespace fixrad
