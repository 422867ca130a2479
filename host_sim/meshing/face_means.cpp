// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

std::vector<glm::dvec3> face_means(const Model& model, const std::vector<Overlap>& overlaps,
                                   const std::vector<glm::dvec3>& element_radiosity) {
  std::vector<glm::dvec3> sum(model.faces.size(), glm::dvec3(0.0));
  std::vector<double> weight(model.faces.size(), 0.0);
  for (const Overlap& o : overlaps) {
    sum[o.input_face] += o.area * element_radiosity[o.element];
    weight[o.input_face] += o.area;
  }
  for (std::size_t f = 0; f < sum.size(); ++f) {
    sum[f] = weight[f] > 0 ? sum[f] / weight[f] : model.materials[model.faces[f].material].emission;
  }
  return sum;
}

std::vector<double> face_areas(const Model& model) {
  std::vector<double> areas;
  for (const Face& face : model.faces) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
      const glm::dvec3 base = model.positions[face.corners[0]];
      sum += glm::cross(model.positions[face.corners[i]] - base, model.positions[face.corners[i + 1]] - base);
    }
    areas.push_back(glm::length(sum) / 2);
  }
  return areas;
}

}  // namespace fixrad::host
