// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/report/baked_mesh.h"
#include "host_sim/report/camera.h"

namespace fixrad::host {

/// A camera that shows the whole mesh (at least one triangle) with a small margin in a picture of `aspect` =
/// width / height.
///
/// A room (its faces look inwards) with a ceiling is seen along the horizontal axis through its most open
/// side, or, all closed, through the widest one, whose back faces are culled. Anything else (an object, a
/// room without a ceiling) is seen three-quarter from above, or from below if only that shows lit sides, from
/// the corner that shows most of them.
Camera automatic_camera(const BakedMesh& mesh, bool z_up, double aspect);

}  // namespace fixrad::host
