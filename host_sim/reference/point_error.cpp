// SPDX-License-Identifier: MIT
#include "host_sim/reference/point_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace fixrad::host {
namespace {

constexpr double kSameWay =
    0.7;  // cosine; smooth shading does not move triangles, so they are parallel or far

using Corners = std::array<glm::dvec3, 3>;

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t triangle = 0;
  glm::dvec3 weights{0.0};  // of its corners
};

// Keeps the triangle if it is nearer. Outside of a triangle the weights are cut to it, which is a point of it
// near enough: only rounding to the grid leads there.
void take_nearer(const Corners& t, const SurfacePoint& point, std::size_t index, Nearest& nearest) {
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double squared = glm::dot(normal, normal);
  if (!(squared > 0) || glm::dot(normal, point.normal) < kSameWay * std::sqrt(squared)) {
    return;
  }
  const double u = glm::dot(glm::cross(t[2] - t[1], point.position - t[1]), normal) / squared;
  const double v = glm::dot(glm::cross(t[0] - t[2], point.position - t[2]), normal) / squared;
  glm::dvec3 weights = glm::max(glm::dvec3(u, v, 1 - u - v), 0.0);
  weights /= weights.x + weights.y + weights.z;
  const double distance =
      glm::distance(point.position, weights.x * t[0] + weights.y * t[1] + weights.z * t[2]);
  if (distance < nearest.distance) {
    nearest = {distance, index, weights};
  }
}

// Of the channels in which the point reflects.
double sum(const SamplePoint& point, glm::dvec3 a) {
  double total = 0;
  for (int c = 0; c < 3; ++c) {
    total += point.reflectance[c] > 0 ? std::abs(a[c]) : 0.0;
  }
  return total;
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) {
    return 0;
  }
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

}  // namespace

PointError compare_points(const std::vector<SamplePoint>& points, const std::vector<glm::dvec3>& irradiance,
                          const Traced& truth) {
  double error = 0, light = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    error += sum(points[i], irradiance[i] - truth.mean[i]);
    light += sum(points[i], truth.mean[i]);
  }
  std::vector<double> relative;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double here = sum(points[i], truth.mean[i]);
    if (here * static_cast<double>(points.size()) > kDarkPoint * light) {
      relative.push_back(sum(points[i], irradiance[i] - truth.mean[i]) / here);
    }
  }
  return {light > 0 ? error / light : 0, quantile(relative, 0.5), quantile(relative, 0.95)};
}

double truth_error(const std::vector<SamplePoint>& points, const Traced& truth) {
  double error = 0, light = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    error += sum(points[i], truth.standard_error[i]);
    light += sum(points[i], truth.mean[i]);
  }
  return light > 0 ? error / light : 0;
}

glm::dvec3 irradiance_of(const SamplePoint& point, glm::dvec3 radiosity) {
  glm::dvec3 irradiance(0.0);
  for (int c = 0; c < 3; ++c) {
    if (point.reflectance[c] > 0) {
      irradiance[c] = (radiosity[c] - point.emission[c]) / point.reflectance[c];
    }
  }
  return irradiance;
}

std::vector<glm::dvec3> interpolate(const std::vector<glm::dvec3>& positions,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    const std::vector<glm::dvec3>& values,
                                    const std::vector<SamplePoint>& points) {
  std::vector<glm::dvec3> result(points.size(), glm::dvec3(0.0));
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    Nearest nearest;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      take_nearer({positions[a], positions[b], positions[c]}, points[i].surface, t, nearest);
    }
    if (!triangles.empty()) {
      const auto& [a, b, c] = triangles[nearest.triangle];
      result[i] =
          nearest.weights.x * values[a] + nearest.weights.y * values[b] + nearest.weights.z * values[c];
    }
  });
  return result;
}

std::vector<std::uint32_t> elements_at(const std::vector<MeshElement>& elements,
                                       const std::vector<SamplePoint>& points) {
  std::vector<std::uint32_t> result(points.size(), 0);
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    Nearest nearest;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const std::vector<glm::dvec3>& p = elements[e].polygon;
      for (std::size_t k = 1; k + 1 < p.size(); ++k) {
        take_nearer({p[0], p[k], p[k + 1]}, points[i].surface, e, nearest);
      }
    }
    result[i] = static_cast<std::uint32_t>(nearest.triangle);
  });
  return result;
}

}  // namespace fixrad::host
