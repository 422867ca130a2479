// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/scene/scene.h"
#include "lib/scene/status.h"

namespace fixrad {

/// The tables of a scene that change when elements are split, in RAM and owned by the caller. Not for AVR,
/// where the solver reads tables from program memory.
struct RefinedScene {
  Element* elements;         ///< [element_capacity]
  uint16_t* patch_elements;  ///< [element_capacity]
  Sight* sights;             ///< [element_capacity]
  uint32_t* errors;          ///< [element_capacity], see refinement.h
  Patch* patches;            ///< [patch_capacity]
  uint16_t* roots;           ///< [cell_capacity], one a cell of the grids
  Cut* cuts;                 ///< [cut_capacity], one a split
  uint16_t element_capacity, patch_capacity, cell_capacity, cut_capacity;
};

/// Copies what may change into `tables` and lets `scene` point there. Statuses: ok, too_many_elements (also
/// for patches, cells and cuts); `scene` is then as it was. Cost: linear.
Status make_refinable(Scene& scene, RefinedScene& tables);

/// A new element to the right of a cut through element `parent`, which keeps the left part; both are given.
struct Split {
  uint16_t parent;
  Cut cut;  ///< sides are filled in
  uint32_t left_area, right_area;
  uint16_t left_eye[3], right_eye[3];
};

/// Whether there is room for one more element on the patch of `parent`.
bool has_room(const Scene& scene, const RefinedScene& tables, uint16_t parent);

/// Enters the split: the new element is parent + 1, those behind move up by one. Both parts' sights become
/// unknown. Needs has_room(). Cost: linear.
void enter_split(Scene& scene, RefinedScene& tables, const Split& split);

}  // namespace fixrad
