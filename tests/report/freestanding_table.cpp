// SPDX-License-Identifier: MIT
// The generated table in a translation unit of its own, compiled as firmware would be (see CMakeLists.txt).
#include "hand_made.hpp"

static_assert(open_room::vertex_count == 20 && open_room::triangle_count == 10, "five quadrilaterals");
