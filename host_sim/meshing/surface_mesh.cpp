// SPDX-License-Identifier: MIT
#include "host_sim/meshing/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace fixrad::host {
namespace {

constexpr double kCoplanar = 0.9998;  // cosine of about one degree
constexpr double kSmooth = 0.5;
constexpr double kTouch = 0.75;  // grid units: corners of neighbouring grids are rounded apart by less
constexpr double kFull = 2 * 3.14159265358979323846 - 0.3;  // curved surfaces miss a little of a full turn

// Points within kTouch of each other, found through a hash of 2-unit cells.
class PointIndex {
 public:
  std::uint32_t insert(std::uint32_t surface, glm::dvec3 p, bool& is_new) {
    const glm::ivec3 cell(glm::floor(p / 2.0));
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto it = cells_.find({surface, cell.x + dx, cell.y + dy, cell.z + dz});
          if (it == cells_.end()) {
            continue;
          }
          for (const std::uint32_t i : it->second) {
            if (glm::distance(points_[i], p) < kTouch) {
              is_new = false;
              return i;
            }
          }
        }
      }
    }
    is_new = true;
    points_.push_back(p);
    cells_[{surface, cell.x, cell.y, cell.z}].push_back(static_cast<std::uint32_t>(points_.size() - 1));
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

 private:
  std::map<std::tuple<std::uint32_t, int, int, int>, std::vector<std::uint32_t>> cells_;
  std::vector<glm::dvec3> points_;
};

struct Corner {
  std::uint32_t vertex;
  double angle;  // inside the element
};

struct ElementOutline {
  std::vector<std::uint32_t> corners;  // mesh vertices in order, those on its sides included
};

bool is_between(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double& t) {
  const glm::dvec3 ab = b - a;
  t = glm::dot(p - a, ab) / glm::dot(ab, ab);
  return t > 0 && t < 1 && glm::distance(p, a + t * ab) < kTouch && glm::distance(p, a) >= kTouch &&
         glm::distance(p, b) >= kTouch;
}

class SurfaceBuilder {
 public:
  SurfaceBuilder(const PreparedScene& scene, const DeviceScene& device)
      : device_(device), surface_of_(smooth_surfaces(scene)) {}

  SurfaceMesh build() {
    add_corners();
    insert_side_points();
    meet_elements();
    triangulate_elements();
    return std::move(mesh_);
  }

 private:
  glm::dvec3 to_grid(glm::dvec3 p) const { return (p - device_.grid.origin) * device_.grid.scale; }

  void add_corners() {
    PointIndex index;
    outlines_.resize(device_.mesh.elements.size());
    for (std::size_t e = 0; e < device_.mesh.elements.size(); ++e) {
      const std::uint32_t surface = surface_of_[device_.elements[e].face];
      for (const glm::dvec3 p : device_.mesh.elements[e].polygon) {
        bool is_new = false;
        const std::uint32_t v = index.insert(surface, to_grid(p), is_new);
        if (is_new) {
          mesh_.positions.push_back(p);
          grid_positions_.push_back(to_grid(p));
          of_surface_[surface].push_back(v);
        }
        std::vector<std::uint32_t>& corners = outlines_[e].corners;
        if (corners.empty() || (corners.back() != v && corners.front() != v)) {
          corners.push_back(v);
        }
      }
    }
  }

  // A vertex of the same surface on an element's side becomes one of its corners, or shading would crack
  // there.
  void insert_side_points() {
    std::map<std::tuple<std::uint32_t, int, int, int>, std::vector<std::uint32_t>> cells;
    double size = 4;
    for (const MeshElement& e : device_.mesh.elements) {
      size = std::max(size, std::sqrt(e.area) * device_.grid.scale);
    }
    const auto cell_of = [&](glm::dvec3 p) { return glm::ivec3(glm::floor(p / size)); };
    for (const auto& [surface, list] : of_surface_) {
      for (const std::uint32_t v : list) {
        const glm::ivec3 c = cell_of(grid_positions_[v]);
        cells[{surface, c.x, c.y, c.z}].push_back(v);
      }
    }
    for (std::size_t e = 0; e < outlines_.size(); ++e) {
      const std::uint32_t surface = surface_of_[device_.elements[e].face];
      glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
      for (const std::uint32_t v : outlines_[e].corners) {
        low = glm::min(low, grid_positions_[v]);
        high = glm::max(high, grid_positions_[v]);
      }
      const glm::ivec3 from = cell_of(low - 1.0), to = cell_of(high + 1.0);
      std::vector<std::uint32_t> near;
      for (int x = from.x; x <= to.x; ++x) {
        for (int y = from.y; y <= to.y; ++y) {
          for (int z = from.z; z <= to.z; ++z) {
            const auto it = cells.find({surface, x, y, z});
            if (it != cells.end()) {
              near.insert(near.end(), it->second.begin(), it->second.end());
            }
          }
        }
      }
      outlines_[e].corners = with_side_points(outlines_[e].corners, near);
    }
  }

  std::vector<std::uint32_t> with_side_points(const std::vector<std::uint32_t>& corners,
                                              const std::vector<std::uint32_t>& near) const {
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
      result.push_back(a);
      std::vector<std::pair<double, std::uint32_t>> between;
      for (const std::uint32_t v : near) {
        double t = 0;
        if (v != a && v != b && is_between(grid_positions_[v], grid_positions_[a], grid_positions_[b], t)) {
          between.push_back({t, v});
        }
      }
      std::sort(between.begin(), between.end());
      for (const auto& [t, v] : between) {
        result.push_back(v);
      }
    }
    return result;
  }

  double angle_at(const std::vector<std::uint32_t>& corners, std::size_t i) const {
    const std::size_t n = corners.size();
    const glm::dvec3 p = grid_positions_[corners[i]];
    const glm::dvec3 a = glm::normalize(grid_positions_[corners[(i + 1) % n]] - p);
    const glm::dvec3 b = glm::normalize(grid_positions_[corners[(i + n - 1) % n]] - p);
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
  }

  void meet_elements() {
    const std::size_t n = mesh_.positions.size();
    std::vector<std::vector<std::uint16_t>> met(n);
    std::vector<double> angle(n, 0.0);
    mesh_.normals.assign(n, glm::dvec3(0.0));
    for (std::size_t e = 0; e < outlines_.size(); ++e) {
      for (std::size_t i = 0; i < outlines_[e].corners.size(); ++i) {
        const std::uint32_t v = outlines_[e].corners[i];
        angle[v] += angle_at(outlines_[e].corners, i);
        mesh_.normals[v] += device_.mesh.elements[e].normal;
        if (met[v].size() < 255) {
          met[v].push_back(static_cast<std::uint16_t>(e));
        }
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      mesh_.normals[v] = glm::normalize(mesh_.normals[v]);
      const auto first = static_cast<std::uint32_t>(mesh_.elements.size());
      mesh_.elements.insert(mesh_.elements.end(), met[v].begin(), met[v].end());
      const std::uint32_t inner = angle[v] < kFull ? opposite_interior(v, met[v], angle) : kNoVertex;
      mesh_.vertices.push_back({first, inner, static_cast<std::uint8_t>(met[v].size())});
    }
  }

  // The interior vertex nearest to the mirror image of v in the middle of its elements.
  std::uint32_t opposite_interior(std::size_t v, const std::vector<std::uint16_t>& met,
                                  const std::vector<double>& angle) const {
    glm::dvec3 middle(0.0);
    for (const std::uint16_t e : met) {
      middle += to_grid(device_.mesh.elements[e].centroid) / static_cast<double>(met.size());
    }
    const glm::dvec3 wanted = 2.0 * middle - grid_positions_[v];
    std::uint32_t best = kNoVertex;
    double nearest = glm::distance(middle, grid_positions_[v]);
    for (const std::uint16_t e : met) {
      for (const std::uint32_t w : outlines_[e].corners) {
        const double d = glm::distance(grid_positions_[w], wanted);
        if (angle[w] >= kFull && d < nearest) {
          nearest = d;
          best = w;
        }
      }
    }
    return best;
  }

  // Fans each element from the corner whose triangles have the largest smallest area.
  void triangulate_elements() {
    for (std::size_t e = 0; e < outlines_.size(); ++e) {
      const std::vector<std::uint32_t>& c = outlines_[e].corners;
      std::vector<std::array<std::uint32_t, 3>> best;
      double best_area = -1;
      for (std::size_t s = 0; s < c.size() && c.size() >= 3; ++s) {
        std::vector<std::array<std::uint32_t, 3>> fan;
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i + 1 < c.size(); ++i) {
          const std::array<std::uint32_t, 3> t = {c[s], c[(s + i) % c.size()], c[(s + i + 1) % c.size()]};
          const glm::dvec3 x = glm::cross(grid_positions_[t[1]] - grid_positions_[t[0]],
                                          grid_positions_[t[2]] - grid_positions_[t[0]]);
          const double signed_area = glm::dot(x, device_.mesh.elements[e].normal);
          smallest = std::min(smallest, signed_area);
          if (signed_area > 0.5) {
            fan.push_back(t);
          }
        }
        if (smallest > best_area) {
          best_area = smallest;
          best = std::move(fan);
        }
      }
      mesh_.triangles.insert(mesh_.triangles.end(), best.begin(), best.end());
      mesh_.triangle_elements.insert(mesh_.triangle_elements.end(), best.size(),
                                     static_cast<std::uint16_t>(e));
    }
  }

  const DeviceScene& device_;
  std::vector<std::uint32_t> surface_of_;
  SurfaceMesh mesh_;
  std::vector<glm::dvec3> grid_positions_;
  std::vector<ElementOutline> outlines_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> of_surface_;
};

}  // namespace

std::vector<std::uint32_t> smooth_surfaces(const PreparedScene& scene) {
  std::vector<std::uint32_t> parent(scene.faces.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t f) {
    while (parent[f] != f) {
      f = parent[f] = parent[parent[f]];
    }
    return f;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owner;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const std::vector<std::uint32_t>& c = scene.faces[f].corners;
    for (std::size_t i = 0; i < c.size(); ++i) {
      owner[{c[i], c[(i + 1) % c.size()]}] = f;
    }
  }
  for (const auto& [edge, f] : owner) {
    const auto it = owner.find({edge.second, edge.first});
    if (it == owner.end()) {
      continue;
    }
    const ConvexFace& a = scene.faces[f];
    const ConvexFace& b = scene.faces[it->second];
    const double cosine = glm::dot(a.normal, b.normal);
    const bool grouped = a.smoothing_group != 0 && a.smoothing_group == b.smoothing_group && cosine > kSmooth;
    if (a.material == b.material && (cosine > kCoplanar || grouped)) {
      parent[root(f)] = root(it->second);
    }
  }
  for (std::uint32_t f = 0; f < parent.size(); ++f) {
    parent[f] = root(f);
  }
  return parent;
}

SurfaceMesh make_surface_mesh(const PreparedScene& scene, const DeviceScene& device) {
  return SurfaceBuilder(scene, device).build();
}

}  // namespace fixrad::host
