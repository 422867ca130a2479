// SPDX-License-Identifier: MIT
#include "tests/stability/hard_scenes.h"

namespace fixrad::host {

Model room_with_inset_lamp(double lamp, double reflectance) {
  const Model closed = cube(reflectance, {});
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(reflectance));
  const std::uint32_t glowing = builder.material(glm::dvec3(reflectance), glm::dvec3(1.0));
  std::array<glm::dvec3, 4> outer{}, inner{};
  for (std::size_t f = 0; f < 6; ++f) {
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t v : closed.faces[f].corners) {
      corners.push_back(closed.positions[v]);
    }
    if (f != 3) {
      builder.polygon(corners, wall);
      continue;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      outer[k] = corners[k];
      inner[k] = glm::dvec3(0.5, 1.0, 0.5) + lamp * (corners[k] - glm::dvec3(0.5, 1.0, 0.5));
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    builder.polygon({outer[k], outer[(k + 1) % 4], inner[(k + 1) % 4], inner[k]}, wall);
  }
  builder.polygon({inner[0], inner[1], inner[2], inner[3]}, glowing);
  return builder.model();
}

void square(ModelBuilder& builder, glm::dvec3 middle, double side, bool faces_up, std::uint32_t material) {
  const double h = side / 2;
  const glm::dvec3 a = middle + glm::dvec3(-h, 0, -h), b = middle + glm::dvec3(-h, 0, h),
                   c = middle + glm::dvec3(h, 0, h), d = middle + glm::dvec3(h, 0, -h);
  builder.polygon(faces_up ? std::vector{a, b, c, d} : std::vector{a, d, c, b}, material);
}

void lit_grid_room(ModelBuilder& builder, double reflectance) {
  const std::uint32_t wall = builder.material(glm::dvec3(reflectance));
  const std::uint32_t glowing = builder.material(glm::dvec3(reflectance), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), {kGridRoom, 16000, 16000}, {glowing, glowing, wall, wall, wall, wall});
}

}  // namespace fixrad::host
