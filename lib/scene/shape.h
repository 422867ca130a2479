// SPDX-License-Identifier: MIT
#pragma once

#include "lib/scene/scene.h"

namespace fixrad {

/// A scene is closed if every edge belongs to two faces that run along it in opposite directions (as many one
/// way as the other, where several meet). Cost: quadratic in the number of corners, stops at the first open
/// edge.
bool is_closed(const Scene& scene);

/// Closed, and light is inside: the faces, taken together, bound their volume from within, as a room does. A
/// body in empty space is closed, but its light escapes.
bool is_enclosed(const Scene& scene);

/// A scene is convex if no face can hide another, or bury its eyes, seen from any lit side: every vertex lies
/// in or before the plane of every face, and faces in one plane that look the same way lie side by side; all
/// within kPlaneTolerance. Plates that face each other are convex as well as a room. Cost: faces x vertices
/// and pairs of faces, three products each, where it holds; stops at the first vertex behind a face.
bool is_convex(const Scene& scene);

}  // namespace fixrad
