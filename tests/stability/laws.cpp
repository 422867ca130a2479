// SPDX-License-Identifier: MIT
#include "tests/stability/laws.h"

#include <algorithm>
#include <cmath>

namespace fixrad::host {
namespace {

std::size_t at(const Light& light, std::size_t element, int channel) {
  return element * static_cast<std::size_t>(light.device->channels) + static_cast<std::size_t>(channel);
}

}  // namespace

double face_radiosity(const Light& light, std::uint32_t face, int channel) {
  double flux = 0, area = 0;
  for (const Overlap& part : light.device->overlaps) {
    if (part.input_face == face) {
      flux += light.radiosity[at(light, part.element, channel)] * part.area;
      area += part.area;
    }
  }
  return flux / area;
}

double face_received(const Light& light, std::uint32_t face, int channel) {
  double sum = 0;
  for (const Overlap& part : light.device->overlaps) {
    if (part.input_face == face) {
      sum += light.received[at(light, part.element, channel)] * part.area /
             light.device->mesh.elements[part.element].area;
    }
  }
  return sum;
}

double exitance_gain(const Light& light, int channel) {
  double gain = 1;
  const std::vector<MeshElement>& elements = light.device->mesh.elements;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    gain += light.received[at(light, e, channel)] * elements[e].reflectance[channel];
  }
  return gain;
}

double radiosity_gain(const Light& light, int channel) {
  double exitance = 0, emission = 0;
  const std::vector<MeshElement>& elements = light.device->mesh.elements;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    exitance += light.radiosity[at(light, e, channel)] * elements[e].area;
    emission += elements[e].emission[channel] * elements[e].area;
  }
  return exitance / emission;
}

void expect_radiosity(const Light& light, std::uint32_t first, std::uint32_t last, double expected,
                      double bound, std::vector<Finding>& findings, int channel) {
  Finding worst = {"", expected, expected, bound * expected};
  for (std::uint32_t face = first; face <= last; ++face) {
    const Finding found = {"radiosity of face " + std::to_string(face), face_radiosity(light, face, channel),
                           expected, bound * expected};
    if (worst.what.empty() || found.error() > worst.error()) {
      worst = found;
    }
  }
  findings.push_back(worst);
}

void expect_conserved(const Light& light, double reflectance, double bound, std::vector<Finding>& findings,
                      int channel) {
  const double gain = 1 / (1 - reflectance);
  double area = 0, emission = 0;
  for (const MeshElement& element : light.device->mesh.elements) {
    area += element.area;
    emission += element.emission[channel] * element.area;
  }
  const double rounding = light.device->unit_radiosity * area / emission;
  findings.push_back({"all flux that leaves surfaces over what they emit", exitance_gain(light, channel),
                      gain, bound * gain});
  findings.push_back(
      {"the same by radiosity", radiosity_gain(light, channel), gain, bound * gain + rounding});
}

void expect_no_leak(const Light& light, std::vector<Finding>& findings) {
  double escaped = 0, back = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    escaped = std::max(escaped, light.escaped[c]);
    back = std::max(back, light.back[c]);
  }
  findings.push_back({"escaped", escaped, 0, 0});
  findings.push_back({"lost to back faces", back, 0, 0});
}

void expect_received(const Light& light, std::uint32_t face, const char* what, double expected, double bound,
                     std::vector<Finding>& findings, int channel) {
  findings.push_back({what, face_received(light, face, channel), expected, bound});
}

}  // namespace fixrad::host
