// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// A mesh of at most `elements` elements (but at least one a face) that are small where the light changes: a
/// uniform mesh of some of them is solved roughly by the core; then the element with the largest error of its
/// own is cut in two until there are enough, with a second solution on the way.
///
/// The error of an element is the range of irradiance within it, times reflectance and area: irradiance is
/// gathered by the core (gather_irradiance) at its centroid, between that and its corners, and on both sides
/// of contact lines. Differences between neighbours would not see a face of one element. An element is cut
/// along a contact line if one crosses it, else across the axis of the grid along which the light changes
/// more. Sources: Cohen, Greenberg, Immel, Brock, "An efficient radiosity approach for realistic image
/// synthesis", 1986; Vedel & Puech, "A testbed for adaptive subdivision in progressive radiosity", 1991.
///
/// Elements are grouped into patches as make_uniform() does. Where the core refuses the scene the mesh stays
/// uniform. Cost: two rough solutions, and about six views an element.
Meshing make_adaptive(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches);

/// The uniform mesh that, cut at contacts, has at most `elements` elements; uncut where that cannot be.
Meshing make_contact_mesh(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches);

}  // namespace fixrad::host
