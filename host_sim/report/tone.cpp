// SPDX-License-Identifier: MIT
#include "host_sim/report/tone.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace fixrad::host {
namespace {

/// Share of the lit area that the middle leaves out at the dark and at the bright end.
constexpr double kDarkShare = 0.05;
constexpr double kBrightShare = 0.15;
/// Luminance up to which a surface counts as unlit; keeps the logarithm and the scale finite.
constexpr double kUnlit = 1e-30;
/// How late colours fade to white on the shoulder: the exponent of the way from kShoulderStart to 1.
constexpr double kFadeExponent = 6.0;

struct Sample {
  double luminance;
  double area;
};

void add_if_lit(std::vector<Sample>& samples, const glm::dvec3& radiosity, double area) {
  const double value = luminance(radiosity);
  if (value > kUnlit && area > 0.0) {
    samples.push_back({value, area});
  }
}

std::vector<Sample> element_samples(const BakedMesh& mesh, bool lamps) {
  std::vector<Sample> samples;
  for (const BakedElement& element : mesh.elements) {
    if (element.lamp == lamps) {
      add_if_lit(samples, element.radiosity, element.area);
    }
  }
  return samples;
}

std::vector<Sample> triangle_samples(const BakedMesh& mesh) {
  std::vector<Sample> samples;
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 normal =
        glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    add_if_lit(samples, (mesh.radiosity[a] + mesh.radiosity[b] + mesh.radiosity[c]) / 3.0,
               0.5 * glm::length(normal));
  }
  return samples;
}

std::vector<Sample> lit_samples(const BakedMesh& mesh) {
  std::vector<Sample> samples = element_samples(mesh, false);
  if (samples.empty()) {
    samples = element_samples(mesh, true);
  }
  return samples.empty() ? triangle_samples(mesh) : samples;
}

/// The area-weighted mean of log luminance between the two shares, as a luminance. A sample that lies across
/// a border counts with the part of its area inside, so that the result moves smoothly with the scene.
double middle_luminance(std::vector<Sample> samples) {
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.luminance < b.luminance; });
  double total = 0.0;
  for (const Sample& sample : samples) {
    total += sample.area;
  }
  const double low = kDarkShare * total;
  const double high = (1.0 - kBrightShare) * total;
  double before = 0.0;
  double weighted_log = 0.0;
  double weight = 0.0;
  for (const Sample& sample : samples) {
    const double after = before + sample.area;
    const double inside = std::max(0.0, std::min(after, high) - std::max(before, low));
    weighted_log += inside * std::log(sample.luminance);
    weight += inside;
    before = after;
  }
  return std::exp(weighted_log / weight);
}

}  // namespace

double luminance(const glm::dvec3& linear) {
  return glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double exposure_scale(const BakedMesh& mesh, const Display& display) {
  std::vector<Sample> samples = lit_samples(mesh);
  const double automatic = samples.empty() ? 1.0 : kMiddleLuminance / middle_luminance(std::move(samples));
  return automatic * std::exp2(display.exposure_ev);
}

double tone_curve(double exposed) {
  if (exposed <= kShoulderStart) {
    return exposed;
  }
  if (exposed >= kWhitePoint) {
    return 1.0;
  }
  const double room = 1.0 - kShoulderStart;
  const double u = (exposed - kShoulderStart) / room;
  const double white = (kWhitePoint - kShoulderStart) / room;
  return kShoulderStart + room * u * (1.0 + u / (white * white)) / (1.0 + u);
}

glm::dvec3 tone(const glm::dvec3& exposed) {
  const double peak = std::max({exposed.x, exposed.y, exposed.z});
  if (!(peak > 0.0)) {
    return glm::dvec3(0.0);
  }
  const double value = tone_curve(peak);
  const double on_shoulder = std::max(0.0, (value - kShoulderStart) / (1.0 - kShoulderStart));
  const double fade = std::pow(on_shoulder, kFadeExponent);
  const glm::dvec3 ratio = exposed / peak;
  return value * (ratio + fade * (glm::dvec3(1.0) - ratio));
}

double srgb_from_linear(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

Srgb8 srgb8(const glm::dvec3& linear) {
  Srgb8 result{};
  for (int k = 0; k < 3; ++k) {
    result[static_cast<std::size_t>(k)] =
        static_cast<std::uint8_t>(std::lround(255.0 * srgb_from_linear(linear[k])));
  }
  return result;
}

Srgb8 display_colour(const glm::dvec3& radiosity, double scale) {
  return srgb8(tone(radiosity * scale));
}

}  // namespace fixrad::host
