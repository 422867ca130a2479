// SPDX-License-Identifier: MIT
#include "host_sim/report/conforming_mesh.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "lib/scene/scene.h"

namespace fixrad::host {
namespace {

constexpr double kTouch = 0.75;  // grid units: what belongs together lies closer before it is rounded
constexpr int kCell = 256;       // grid units, of the index of points

using Cell = std::tuple<int, int, int>;

Cell cell_of(glm::ivec3 p) {
  return {p.x / kCell, p.y / kCell, p.z / kCell};
}

// The distinct grid points of a mesh.
class Points {
 public:
  // The point for `p`: one within kTouch that is there already, or p rounded.
  glm::ivec3 weld(glm::dvec3 p) {
    const glm::ivec3 rounded(glm::clamp(glm::round(p), 0.0, static_cast<double>(kGridMax)));
    const glm::ivec3 low = glm::max(rounded - 1, glm::ivec3(0)), high = rounded + 1;
    glm::ivec3 found = rounded;
    for_cells(low, high, [&](const std::pair<glm::ivec3, glm::dvec3>& known) {
      if (glm::distance(known.second, p) < kTouch) {
        found = known.first;
      }
    });
    if (found == rounded && known_.insert({rounded.x, rounded.y, rounded.z}).second) {
      cells_[cell_of(rounded)].push_back({rounded, p});
    }
    return found;
  }

  // Points strictly between two others on their line (as they were before rounding), by their part of the
  // way.
  std::vector<std::pair<double, glm::ivec3>> between(glm::ivec3 a, glm::ivec3 b) const {
    std::vector<std::pair<double, glm::ivec3>> result;
    const glm::dvec3 from = exact(a), way = exact(b) - from;
    for_cells(glm::max(glm::min(a, b) - 1, glm::ivec3(0)), glm::max(a, b) + 1,
              [&](const std::pair<glm::ivec3, glm::dvec3>& known) {
                const glm::dvec3 offset = known.second - from;
                const double part = glm::dot(offset, way) / glm::dot(way, way);
                if (known.first != a && known.first != b && part > 0 && part < 1 &&
                    glm::length(offset - part * way) < kTouch) {
                  result.push_back({part, known.first});
                }
              });
    std::sort(result.begin(), result.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    return result;
  }

 private:
  glm::dvec3 exact(glm::ivec3 point) const {
    const auto& cell = cells_.at(cell_of(point));
    return std::find_if(cell.begin(), cell.end(), [&](const auto& known) { return known.first == point; })
        ->second;
  }

  template <class Visit>
  void for_cells(glm::ivec3 low, glm::ivec3 high, const Visit& visit) const {
    for (int x = low.x / kCell; x <= high.x / kCell; ++x) {
      for (int y = low.y / kCell; y <= high.y / kCell; ++y) {
        for (int z = low.z / kCell; z <= high.z / kCell; ++z) {
          const auto cell = cells_.find({x, y, z});
          if (cell != cells_.end()) {
            std::for_each(cell->second.begin(), cell->second.end(), visit);
          }
        }
      }
    }
  }

  std::map<Cell, std::vector<std::pair<glm::ivec3, glm::dvec3>>> cells_;
  std::set<std::tuple<int, int, int>> known_;
};

using Side = std::pair<std::uint32_t, std::uint32_t>;

// A piece of a triangle and the vertices on its three sides, in order.
struct Piece {
  std::array<std::uint32_t, 3> corner;
  std::array<std::vector<std::uint32_t>, 3> on_side;  // [k]: between corner k and k + 1
};

class Builder {
 public:
  Builder(const BakedMesh& mesh, const Grid& grid) : mesh_(mesh) {
    for (const glm::dvec3& p : mesh.positions) {
      result_.positions.push_back(points_.weld((p - grid.origin) * grid.scale));
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      for (const Side& side : {Side(a, b), Side(b, c), Side(c, a)}) {
        sides_.insert(side);
      }
    }
  }

  ConformingMesh build() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      Piece piece{mesh_.triangles[t], {}};
      for (std::size_t k = 0; k < 3; ++k) {
        piece.on_side[k] = inserted_on({piece.corner[k], piece.corner[(k + 1) % 3]});
      }
      add(piece, static_cast<std::uint32_t>(t));
    }
    return std::move(result_);
  }

 private:
  // A side with a neighbour in its own surface keeps its two ends: nothing is to fit there.
  std::vector<std::uint32_t> inserted_on(const Side& side) {
    std::vector<std::uint32_t> vertices;
    const glm::ivec3 from = result_.positions[side.first], to = result_.positions[side.second];
    if (from == to || sides_.count({side.second, side.first}) != 0) {
      return vertices;
    }
    for (const auto& [part, point] : points_.between(from, to)) {
      vertices.push_back(static_cast<std::uint32_t>(result_.positions.size()));
      result_.positions.push_back(point);
      result_.inserted.push_back({side.first, side.second, part});
    }
    return vertices;
  }

  // Halves the piece at a vertex on a side until there is none.
  void add(const Piece& piece, std::uint32_t source) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<std::uint32_t>& between = piece.on_side[k];
      if (between.empty()) {
        continue;
      }
      const std::size_t middle = between.size() / 2, next = (k + 1) % 3, last = (k + 2) % 3;
      const auto cut = between.begin() + static_cast<std::ptrdiff_t>(middle);
      Piece first{{piece.corner[k], *cut, piece.corner[last]}, {}};
      first.on_side[0].assign(between.begin(), cut);
      first.on_side[2] = piece.on_side[last];
      Piece second{{*cut, piece.corner[next], piece.corner[last]}, {}};
      second.on_side[0].assign(cut + 1, between.end());
      second.on_side[1] = piece.on_side[next];
      add(first, source);
      add(second, source);
      return;
    }
    const glm::ivec3 a = result_.positions[piece.corner[0]], b = result_.positions[piece.corner[1]],
                     c = result_.positions[piece.corner[2]];
    if (glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)) != glm::dvec3(0.0)) {
      result_.triangles.push_back(piece.corner);
      result_.source.push_back(source);
    }
  }

  const BakedMesh& mesh_;
  ConformingMesh result_;
  Points points_;
  std::set<Side> sides_;
};

}  // namespace

ConformingMesh make_conforming(const BakedMesh& mesh, const Grid& grid) {
  return Builder(mesh, grid).build();
}

}  // namespace fixrad::host
