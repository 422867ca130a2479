// SPDX-License-Identifier: MIT
#include "tests/stability/properties.h"

#include "tests/stability/property_checks.h"

namespace fixrad::host {

const std::vector<Property>& properties() {
  static const std::vector<Property> all = {
      {"KeepsItsBooks",
       "Exact: the ledger balances after every shot; unshot flux never grows without overshooting; shooting "
       "ends; in a closed room nothing escapes or meets a back.",
       keep_books},
      {"SlicesChangeNothing",
       "Exact: nothing of a shot is booked before it is complete, so slices, a shot that is given up and "
       "begun "
       "anew, and a solver that goes on from what was saved in the middle of one, give the same bits.",
       solve_in_slices},
      {"EmissionScalesLight",
       "With one matrix of form factors light is linear in emission, to within what is unshot and a unit an "
       "element and shot, each over 1 - the largest reflectance.",
       scale_light},
      {"OrderOfVerticesAndMaterialsDoesNotMatter",
       "Exact: the order of shots follows the faces; vertices and materials are only referred to.",
       shuffle_vertices},
      {"CyclicAxesGiveTheSameBits",
       "Exact, for tables turned by a third of a turn about a diagonal of the grid: the core adds three "
       "products "
       "for every component of a vector in its eye's frame, whichever comes first. (Other rotations change "
       "signs, "
       "and a product that lies halfway between two numbers is rounded up whatever its sign.)",
       turn_axes},
      {"OrderOfFacesLeavesRowsAlone",
       "What an eye sees does not depend on who is drawn first: exact without bodies; with them rounded "
       "depths may "
       "tie where they touch or run through each other, for 2^-10 of a view at most.",
       shuffle_faces},
      {"ExchangeIsReciprocal",
       "A_i F_ij = A_j F_ji: exchange areas between faces, by one view of 128 lunes from the middle of each "
       "of 300 "
       "elements, are within 6 % of their transpose in sum. The bound is measured, three times the error of "
       "all but "
       "one scene in a hundred: elements that lie half under a body have one eye.",
       reciprocate},
  };
  return all;
}

}  // namespace fixrad::host