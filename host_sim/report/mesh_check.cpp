// SPDX-License-Identifier: MIT
#include "host_sim/report/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace fixrad::host {
namespace {

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Well inside what the glTF validator still accepts as a unit vector (0.00674).
constexpr double kUnitTolerance = 1e-3;

bool unit_length(const glm::dvec3& v) {
  return std::abs(glm::length(v) - 1.0) <= kUnitTolerance;
}

bool valid_radiosity(const glm::dvec3& v) {
  return finite(v) && v.x >= 0.0 && v.y >= 0.0 && v.z >= 0.0;
}

void require(bool holds, const char* message) {
  if (!holds) {
    throw std::invalid_argument(message);
  }
}

}  // namespace

void check_mesh(const BakedMesh& mesh) {
  const std::size_t count = mesh.positions.size();
  require(!mesh.triangles.empty(), "baked mesh: no triangle");
  require(mesh.normals.size() == count, "baked mesh: not one normal a vertex");
  require(mesh.radiosity.size() == count, "baked mesh: not one radiosity a vertex");
  require(std::all_of(mesh.positions.begin(), mesh.positions.end(), finite),
          "baked mesh: a position is not finite");
  require(std::all_of(mesh.normals.begin(), mesh.normals.end(), unit_length),
          "baked mesh: a normal is not of unit length");
  require(std::all_of(mesh.radiosity.begin(), mesh.radiosity.end(), valid_radiosity),
          "baked mesh: a radiosity is negative or not finite");
  for (const auto& [a, b, c] : mesh.triangles) {
    require(a < count && b < count && c < count, "baked mesh: a triangle names a vertex that does not exist");
  }
}

}  // namespace fixrad::host
