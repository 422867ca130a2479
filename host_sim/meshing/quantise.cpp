// SPDX-License-Identifier: MIT
#include "host_sim/meshing/quantise.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <tuple>

#include "lib/scene/scene.h"

namespace fixrad::host {
namespace {

constexpr int kMargin =
    8;  // grid units; eyes are lifted by half a unit, or a few where a face is not quite planar

constexpr std::size_t kMostVertices = 65535;  // the core numbers them in 16 bits
constexpr double kLeastExtent = 1e-30;        // keeps the square of the scale finite

}  // namespace

QuantisedVertices quantise(const Model& model) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-std::numeric_limits<double>::infinity());
  for (const Face& face : model.faces) {
    for (const std::uint32_t v : face.corners) {
      low = glm::min(low, model.positions[v]);
      high = glm::max(high, model.positions[v]);
    }
  }
  const glm::dvec3 size = high - low;
  const double extent = std::max({size.x, size.y, size.z});
  if (model.faces.empty() || !(extent >= kLeastExtent) || !std::isfinite(extent)) {
    throw InputError(model.path +
                     ": error: the scene has no extent that can be represented; check its coordinates");
  }
  QuantisedVertices result;
  result.grid.scale = (kGridMax - 2 * kMargin) / extent;
  result.grid.origin = low - glm::dvec3(kMargin / result.grid.scale);
  result.index_of.assign(model.positions.size(), 0);
  std::map<std::tuple<int, int, int>, std::uint32_t> known;
  std::vector<bool> seen(model.positions.size(), false);
  for (const Face& face : model.faces) {
    for (const std::uint32_t v : face.corners) {
      if (seen[v]) {
        continue;
      }
      seen[v] = true;
      const glm::dvec3 exact = (model.positions[v] - low) * result.grid.scale + glm::dvec3(kMargin);
      const glm::ivec3 p(glm::round(exact));
      const auto [it, is_new] =
          known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(result.positions.size()));
      if (is_new) {
        result.positions.push_back(p);
      }
      if (result.positions.size() > kMostVertices) {
        throw InputError(model.path + ":" + std::to_string(face.line) +
                         ": error: this face brings the vertices to more than 65535; simplify the scene");
      }
      result.index_of[v] = it->second;
      result.largest_error =
          std::max(result.largest_error, glm::distance(exact, glm::dvec3(p)) / result.grid.scale);
    }
  }
  return result;
}

}  // namespace fixrad::host
