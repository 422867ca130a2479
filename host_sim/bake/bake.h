// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/meshing/device_scene.h"
#include "host_sim/meshing/surface_mesh.h"
#include "host_sim/simulate/profile.h"
#include "host_sim/simulate/simulated_device.h"

namespace fixrad::host {

/// Where a solution goes on from and is saved to, files as of state_file.h; shooting only.
struct StateOptions {
  std::string resume;                  ///< empty: starts anew
  std::string save;                    ///< written at the end, interrupted or not; empty: nowhere
  std::uint32_t save_every = 0;        ///< and after so many shots; 0: at the end only
  std::optional<std::uint32_t> shots;  ///< ends once there are so many, those before `resume` included
};

/// What the user may choose; everything left out follows from the profile.
struct BakeOptions {
  std::string profile = "large";
  std::string engine = "lunes";     ///< lunes | rows | pixels | rays | contour
  std::string solver = "shooting";  ///< shooting | gathering
  std::string mesh = "uniform";     ///< uniform | contacts | adaptive
  std::optional<int> resolution;    ///< R, or rays a pair
  std::optional<std::uint32_t> elements;
  double unshot = 0.001;               ///< stop fraction
  std::optional<double> flux_per_row;  ///< one row of samples for each such part of the emitted flux
  std::optional<double> flux_per_eye;  ///< an element has one eye point for each such part
  bool overshoot = true;
  bool near_field = false;  ///< correct the rows of near pairs
  bool ambient = false;     ///< add the ambient estimate of the rest to the result
  StateOptions state;
};

/// How a scene is put into a profile's memory.
struct BakePlan {
  Profile profile;
  int resolution = 0;
  Meshing meshing;
  Sizes sizes = {};
  bool overshoot = false;
  std::uint32_t matrix_bytes = 0;  ///< of `gathering`, 0 for `shooting`

  std::uint32_t ram() const { return ram_bytes(profile, sizes) + matrix_bytes; }
};

/// Whether the engine can be asked for this resolution: 8 to 128 rows, or 4 to 32 rays a pair, a power of
/// two.
bool has_resolution(const std::string& engine, int resolution);

/// Chooses elements, patches and pools. Throws InputError if the scene does not fit, with the bytes that it
/// needs, or if faces hide each other and the engine is `contour`.
BakePlan make_plan(const PreparedScene& scene, const BakeOptions& options);

/// Called now and then; returns false to stop.
using Progress = std::function<bool(std::uint32_t shots, double unshot_fraction, double seconds)>;

/// A finished (or interrupted) solution and everything measured about it.
struct BakeResult {
  BakePlan plan;
  DeviceScene device;
  SurfaceMesh surface;
  std::vector<glm::dvec3> element_radiosity;  ///< W/m^2, always three channels
  std::vector<glm::dvec3> vertex_radiosity;   ///< [surface.positions]
  std::vector<std::int32_t> received;         ///< flux units, [element][channel]
  std::vector<Ledger> ledger;                 ///< one a carried channel
  std::uint32_t shots = 0, eyes = 0, withdrawn = 0, gaps_closed = 0, spans_used = 0;
  double seconds = 0;  ///< of the solver alone
  double unshot_fraction = 0;
  std::uint64_t digest = 0;                          ///< of the solution and the means round its vertices
  std::array<Radiosity, kMaxChannels> ambient = {};  ///< added to the results; 0 unless asked for
  std::string display = "mean";      ///< how vertex_radiosity was made: mean | gather (gather_display())
  double display_seconds = 0;        ///< of gather_display()
  std::uint64_t display_digest = 0;  ///< as digest, of what is displayed
  bool is_closed = false;
  bool interrupted = false;
};

/// Runs the integer core on `scene`. `observer` may watch the shots (the twin does). Throws InputError as
/// make_plan, if the core refuses the scene, or if a state cannot be resumed or saved.
BakeResult bake(const PreparedScene& scene, const BakeOptions& options, const Progress& progress = {},
                const std::function<Observer(const State&)>& observer = {});

/// The classical beginner's results, recognised: a line each, with what to do.
std::vector<std::string> explain(const PreparedScene& scene, const BakeResult& result);

/// The core's settings for these options.
Settings make_settings(const BakeOptions& options, const BakePlan& plan);

}  // namespace fixrad::host
