// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/reference/twin_hemisphere.h"
#include "host_sim/reference/twin_pairs.h"
#include "host_sim/reference/twin_recorder.h"
#include "host_sim/reference/twin_scene.h"

namespace fixrad::host {

/// Reference 1: the core's form factors and shooting in double precision. It replays the shots of a
/// fixed-point run, with the same eye points, axes and resolution, so that only the arithmetic differs; what
/// each element has to send is the twin's own.
class Twin {
 public:
  /// Starts from the emitted flux. Of `settings` only the engine counts; throws std::invalid_argument if it
  /// is none of the core's, or if rows are corrected afterwards, which the twin does not know. The tables of
  /// `scene` must outlive the twin.
  Twin(const Scene& scene, const Settings& settings);
  Twin(const Twin&) = delete;
  Twin& operator=(const Twin&) = delete;

  /// Fires all recorded shots in order. Cost: as the fixed run, less its search for buried eye points.
  void replay(const Recorder& recorder);

  /// Fires one shot. eyes [shot.eye_count], whose weights sum to kRowOne.
  void shoot(const RecordedShot& shot, const RecordedEye* eyes);

  /// Form factors of the last shot; with `escaped` and `back` they sum to 1.
  const TwinFormFactors& form_factors() const { return row_; }

  const TwinScene& scene() const { return scene_; }
  /// Flux units of the scene, channel `c`.
  double received(std::size_t element, std::size_t c) const {
    return received_[element * scene_.channels + c];
  }
  /// Emitted and reflected in all; never negative.
  double exitent_flux(std::size_t element, std::size_t c) const;
  /// Emission that is still to come included.
  double unshot(std::size_t element, std::size_t c) const;
  double emitted(std::size_t c) const;   ///< by all elements
  double absorbed(std::size_t c) const;  ///< by all elements
  double escaped(std::size_t c) const { return escaped_[c]; }
  double back(std::size_t c) const { return back_[c]; }

  /// Radiosity of every element, W/m^2 (or what `unit_watts` / `area_unit` make of it), for a flux unit of
  /// `unit_watts` and a raw area unit (1/8 square grid unit) of `area_unit`. One channel is repeated three
  /// times.
  std::vector<glm::dvec3> element_radiosity(double unit_watts, double area_unit) const;

 private:
  double send(const RecordedShot& shot, std::size_t c);
  void add_eye(const RecordedEye& eye);

  TwinScene scene_;
  Engine engine_;
  TwinHemisphere hemisphere_;
  TwinPairs pairs_;
  TwinFormFactors row_;
  std::vector<double> received_;  // [element][channel]
  std::vector<double> sent_;      // [element][channel], of what it reflects
  std::vector<bool> has_emitted_;
  double escaped_[kMaxChannels] = {};
  double back_[kMaxChannels] = {};
};

/// Error of the fixed-point arithmetic: |fixed - twin| of element radiosities over the scene's mean
/// radiosity.
struct ArithmeticError {
  double mean = 0, max = 0;       ///< of the worst channel
  std::size_t worst_element = 0;  ///< where max is
};

/// `fixed`, `twin` [elements] in one unit, `areas` [elements]: means are weighted by area. A channel without
/// light does not count. Throws std::invalid_argument if the sizes differ.
ArithmeticError compare_arithmetic(const std::vector<glm::dvec3>& fixed, const std::vector<glm::dvec3>& twin,
                                   const std::vector<double>& areas);

}  // namespace fixrad::host
