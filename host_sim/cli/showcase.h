// SPDX-License-Identifier: MIT
// The settings of a sweep that its page shows in pictures.
#pragma once

#include <string>
#include <vector>

#include "host_sim/cli/session.h"
#include "host_sim/report/camera.h"
#include "host_sim/sweep/sweep.h"

namespace fixrad::host {

/// A solution as the page shows it: PNG pictures as data URLs, the model as base64.
struct Views {
  std::string picture, model;
  std::string point_errors;  ///< against the reference, point by point; empty for the reference itself
  std::string face_errors;   ///< face means against the path-traced truth
};

/// Everything in pictures, seen by one camera at one exposure and with one scale a kind of error.
struct Showcase {
  std::vector<std::size_t> points;  ///< indices of the sweep's points, by falling error
  std::vector<Views> views;         ///< [points]
  Views reference;                  ///< a much finer solution
  std::uint32_t reference_elements = 0;
  double reference_error = 0;  ///< of its face means against the truth
  double point_limit = 0;      ///< where the scale of point_errors ends, relative
  double face_limit = 0;       ///< of face_errors
  int width = 0, height = 0;   ///< of the pictures, pixels
  Camera camera;               ///< of all pictures
};

/// Chooses a few points along the frontier of host seconds, one of each profile and engine among them, solves
/// them again and draws them. False once the user has interrupted.
bool make_showcase(const CommonOptions& options, const LoadedScene& scene, const Truth& truth,
                   const std::vector<SweepPoint>& points, Showcase& showcase);

}  // namespace fixrad::host
