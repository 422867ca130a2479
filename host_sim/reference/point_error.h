// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "host_sim/reference/path_tracer.h"
#include "host_sim/reference/surface_points.h"

namespace fixrad::host {

/// How far irradiance at points is from the truth. Channels in which a point does not reflect are left out:
/// no colour tells the light that arrives there.
struct PointError {
  double mean = 0;    ///< sum |prediction - truth| over sum of truth, all points and channels
  double median = 0;  ///< of |prediction - truth| / truth a point, channels summed; dark points are left out
  double percentile95 = 0;  ///< of the same
};

/// A point with less than this part of the mean irradiance is dark: its relative error says nothing.
constexpr double kDarkPoint = 0.1;

/// `irradiance`, `truth.mean`: [points], W/m^2.
PointError compare_points(const std::vector<SamplePoint>& points, const std::vector<glm::dvec3>& irradiance,
                          const Traced& truth);

/// The standard error of the truth, relative as PointError::mean. A prediction without any error would show
/// about 0.8 of it.
double truth_error(const std::vector<SamplePoint>& points, const Traced& truth);

/// The irradiance that explains a radiosity at a point: (B - emission) / reflectance, 0 where nothing is
/// reflected.
glm::dvec3 irradiance_of(const SamplePoint& point, glm::dvec3 radiosity);

/// Triangles with a value at each vertex, as a renderer interpolates them.
/// @return [points] the value at each; of the triangle that is nearest among those that face the same way
/// Cost: points x triangles.
std::vector<glm::dvec3> interpolate(const std::vector<glm::dvec3>& positions,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    const std::vector<glm::dvec3>& values,
                                    const std::vector<SamplePoint>& points);

/// The element on which each point lies (nearest of those that face the same way).
std::vector<std::uint32_t> elements_at(const std::vector<MeshElement>& elements,
                                       const std::vector<SamplePoint>& points);

}  // namespace fixrad::host
