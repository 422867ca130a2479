// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace fixrad {

/// Outcome of load() and of a shot. Everything but `ok` leaves the solution as it was.
enum class Status : uint8_t {
  ok,                         ///< done
  converged,                  ///< nothing left to do: unshot flux is under the wanted fraction
  too_many_vertices,          ///< more than the storage has room for
  too_many_faces,             ///< more than the storage has room for
  too_many_elements,          ///< more than the storage has room for
  bad_channel_count,          ///< neither 1 nor the number that the storage was made for
  bad_index,                  ///< a record points outside its table
  bad_grid,                   ///< an element grid has no cells, or its rows do not fit the face
  vertex_off_grid,            ///< a coordinate outside [0, kGridMax]
  repeated_corner,            ///< a face uses a vertex twice
  zero_area,                  ///< a face or an element without area
  not_planar,                 ///< a corner is further than kPlaneTolerance from the plane of its face
  not_convex,                 ///< a corner turns the wrong way round the normal
  reflectance_not_below_one,  ///< leaves no headroom: flux / (1 - reflectance) would overflow
  no_emitter,                 ///< no flux at all is emitted
  flux_overflow,          ///< emitted flux too large for 1/(1 - reflectance) headroom; use a larger flux unit
  span_pool_full,         ///< a row shows more spans than the pool holds
  item_buffer_too_small,  ///< hemicube_pixels needs R x R items; raise Limits::pixel_resolution
  bad_frame,              ///< a tangent that is not perpendicular to its normal, or axes beyond the grid
  bad_unit,               ///< emission_shift above 63 or radiosity_shift above 32
  bad_eye,                ///< an eye point that does not lie on the lit side of its face
  in_progress,            ///< the budget is used up before the shot is complete: call again
};

}  // namespace fixrad
