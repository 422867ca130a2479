// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/sweep/cost_model.h"

namespace fixrad::host {

/// A part of the general solution that a scene does without, and what that saves on a target.
struct Omission {
  std::string name;            ///< channels | backs | sealed_backs | depth
  std::string text;            ///< what is left out, and why
  std::uint32_t ram = 0;       ///< bytes
  std::optional<double> cost;  ///< in the unit of the cost model; nothing for an engine that it does not know
};

/// The smallest and the largest of something.
struct Extent {
  double least = 0, most = 0;
};

/// What a scene needs of the solver, measured on one solution.
struct SceneNeeds {
  BakeResult result;
  bool is_grey = false;
  bool is_convex = false;                 ///< no face hides another
  bool is_enclosed = false;               ///< as State::is_enclosed
  std::size_t edges = 0, open_edges = 0;  ///< open: not run along as often one way as the other
  std::size_t sealed_faces = 0;           ///< of bodies into which no eye sees
  std::size_t buried_elements = 0;        ///< under or in something: they send no light from their centroid
  std::size_t lamp_elements = 0;
  Extent lamp_watts;                    ///< that an element of a lamp emits, mean of the channels
  Extent element_area;                  ///< scene units
  Extent radiosity;                     ///< of elements that light reaches or that emit, mean of the channels
  std::int32_t darkest_units = 0;       ///< least flux > 0 that an element has received, flux units
  std::size_t views = 0;                ///< from eye points, one for each
  std::size_t views_without_depth = 0;  ///< of these: no two faces meet on a row
  std::optional<double> cost;           ///< of the solution, in the unit of the cost model
  std::vector<Omission> omissions;
};

/// Solves `scene` and finds out what it needs and what was left out. What an omission saves in instructions
/// is the difference to a solution with it, counted in the same way; the depth of faces is put at
/// kDepthOfView of a face in view. Returns with result.interrupted where `progress` stops it. Throws
/// InputError as bake(). Cost: two to four solutions.
SceneNeeds find_needs(const PreparedScene& scene, const BakeOptions& options, const CostModel& model,
                      const Progress& progress);

/// What the depth of a face costs, as a part of all that a face in view costs once an eye: measured on a
/// Cortex-M0, where 3,915 depths of a closed box took 1.1 million instructions.
constexpr double kDepthOfView = 0.27;

}  // namespace fixrad::host
