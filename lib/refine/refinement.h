// SPDX-License-Identifier: MIT
#pragma once

#include "lib/refine/refined_scene.h"
#include "lib/transport/irradiance.h"

namespace fixrad {

// Adaptive subdivision while a solution goes on (two levels as in Cohen, Greenberg, Immel, Brock 1986:
// patches shoot, elements receive): split the element with the largest error of its own in two, again and
// again, within fixed capacities. Nothing is solved anew: the parts share what their whole has received and
// sent, in proportion to the irradiance gathered at their centroids, so the ledger balances through every
// split.
//
//     make_refinable(state.scene, tables);
//     status = start_refining(state, tables, table);             // once the strongest light has been shot
//     while (status == Status::ok) {
//       status = split_worst(state, tables, table);              // until there is room no more
//     }
//     while (shoot(state) == Status::ok) {
//     }

/// Estimates the error of every element: the range of irradiance within it, gathered with `table` at its
/// centroid and on the way from there to its corners, times reflectance and area. (A difference between
/// neighbours cannot see a face of one element.) Emitters have none: what they still have to send is not to
/// be divided. Needs a scene made refinable and sweep.kind != face. Statuses: ok, span_pool_full. Cost: about
/// five views an element.
Status start_refining(State& state, RefinedScene& tables, const DeltaTable& table);

/// Splits the element with the largest error at its centroid, across that axis of its face's grid along which
/// the light changes more. Elements from three times as long as wide are split across their length; parts
/// below 1/16 of a cell's side are not made. Statuses: ok; converged (no element has an error or may be
/// split); too_many_elements (no room); span_pool_full. Cost: a dozen views, and linear in the elements.
Status split_worst(State& state, RefinedScene& tables, const DeltaTable& table);

}  // namespace fixrad
