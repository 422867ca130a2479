// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fixrad::host {
namespace {

// Engines by pairs need no hemisphere in double but that of the lunes.
TwinEngine engine_of(Engine engine) {
  if (engine == hemicube_rows) {
    return TwinEngine::rows;
  }
  if (engine == hemicube_pixels) {
    return TwinEngine::pixels;
  }
  if (engine == lune_rows || engine == contour_row || engine == ray_row) {
    return TwinEngine::lunes;
  }
  throw std::invalid_argument("the twin in double knows the core's own engines only");
}

}  // namespace

Twin::Twin(const Scene& scene, const Settings& settings)
    : scene_(make_twin_scene(scene)),
      engine_(settings.engine),
      hemisphere_(scene_, engine_of(settings.engine)),
      pairs_(scene, scene_),
      received_(scene_.element_count() * scene_.channels, 0.0),
      sent_(received_.size(), 0.0),
      has_emitted_(scene_.element_count(), false) {
  if (settings.near_field != nullptr) {
    throw std::invalid_argument("the twin in double cannot replay --near-field; leave it out");
  }
  row_.share.resize(scene_.element_count());
}

void Twin::replay(const Recorder& recorder) {
  for (const RecordedShot& shot : recorder.shots()) {
    shoot(shot, recorder.eyes().data() + shot.first_eye);
  }
}

void Twin::shoot(const RecordedShot& shot, const RecordedEye* eyes) {
  std::fill(row_.share.begin(), row_.share.end(), 0.0);
  row_.escaped = row_.back = 0;
  for (std::size_t i = 0; i < shot.eye_count; ++i) {
    add_eye(eyes[i]);
  }
  if (shot.eye_count == 0) {  // buried: its light stays on it, as in the core
    row_.share[shot.elements.front()] = 1.0;
  }
  const std::size_t channels = scene_.channels;
  double amount[kMaxChannels] = {};
  for (std::size_t c = 0; c < channels; ++c) {
    amount[c] = send(shot, c);
    escaped_[c] += amount[c] * row_.escaped;
    back_[c] += amount[c] * row_.back;
  }
  for (std::size_t e = 0; e < scene_.element_count(); ++e) {
    for (std::size_t c = 0; c < channels; ++c) {
      received_[e * channels + c] += amount[c] * row_.share[e];
    }
  }
  if (shot.is_emission) {
    has_emitted_[shot.elements.front()] = true;
  }
}

void Twin::add_eye(const RecordedEye& eye) {
  if (engine_ == contour_row) {
    pairs_.add_contours(eye, row_);
  } else if (engine_ == ray_row) {
    pairs_.add_rays(eye, row_);
  } else {
    hemisphere_.add(eye, row_);
  }
}

// Which elements of a group a loan belongs to does not matter: from then on they shoot together.
double Twin::send(const RecordedShot& shot, std::size_t c) {
  double amount = 0;
  for (const std::uint16_t e : shot.elements) {
    const std::size_t i = e * scene_.channels + c;
    if (shot.is_emission) {
      amount += scene_.emitted[i];
      continue;
    }
    const double own = scene_.reflectance[i] * received_[i] - sent_[i];
    const double part = own + shot.more[c] / static_cast<double>(shot.elements.size());
    sent_[i] += part;
    amount += part;
  }
  return amount;
}

double Twin::unshot(std::size_t element, std::size_t c) const {
  const std::size_t i = element * scene_.channels + c;
  return (has_emitted_[element] ? 0.0 : scene_.emitted[i]) + scene_.reflectance[i] * received_[i] - sent_[i];
}

double Twin::exitent_flux(std::size_t element, std::size_t c) const {
  const std::size_t i = element * scene_.channels + c;
  return std::max(0.0, scene_.emitted[i] + scene_.reflectance[i] * received_[i]);
}

double Twin::emitted(std::size_t c) const {
  double sum = 0;
  for (std::size_t e = 0; e < scene_.element_count(); ++e) {
    sum += scene_.emitted[e * scene_.channels + c];
  }
  return sum;
}

double Twin::absorbed(std::size_t c) const {
  double sum = 0;
  for (std::size_t e = 0; e < scene_.element_count(); ++e) {
    const std::size_t i = e * scene_.channels + c;
    sum += (1 - scene_.reflectance[i]) * received_[i];
  }
  return sum;
}

std::vector<glm::dvec3> Twin::element_radiosity(double unit_watts, double area_unit) const {
  std::vector<glm::dvec3> radiosity(scene_.element_count());
  for (std::size_t e = 0; e < scene_.element_count(); ++e) {
    const double factor = unit_watts / (scene_.element_area[e] * area_unit);
    for (glm::length_t c = 0; c < 3; ++c) {
      const auto channel = std::min<std::size_t>(static_cast<std::size_t>(c), scene_.channels - 1);
      radiosity[e][c] = exitent_flux(e, channel) * factor;
    }
  }
  return radiosity;
}

ArithmeticError compare_arithmetic(const std::vector<glm::dvec3>& fixed, const std::vector<glm::dvec3>& twin,
                                   const std::vector<double>& areas) {
  if (fixed.size() != twin.size() || fixed.size() != areas.size()) {
    throw std::invalid_argument("radiosities and areas must be of the same elements");
  }
  ArithmeticError error;
  for (glm::length_t c = 0; c < 3; ++c) {
    double area = 0, light = 0, sum = 0, highest = 0;
    std::size_t at = 0;
    for (std::size_t e = 0; e < areas.size(); ++e) {
      const double difference = std::fabs(fixed[e][c] - twin[e][c]);
      area += areas[e];
      light += areas[e] * twin[e][c];
      sum += areas[e] * difference;
      if (difference > highest) {
        highest = difference;
        at = e;
      }
    }
    if (light > 0) {
      error.mean = std::max(error.mean, sum / light);
      if (highest * area / light > error.max) {
        error.max = highest * area / light;
        error.worst_element = at;
      }
    }
  }
  return error;
}

}  // namespace fixrad::host
