// SPDX-License-Identifier: MIT
#include "host_sim/meshing/element_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "lib/scene/scene.h"

namespace fixrad::host {
namespace {

constexpr double kSliver = 0.2;    // of a whole cell's area
constexpr double kParallel = 1.5;  // grid units that a parallelogram's fourth corner may be off
constexpr int kMostCells = 100;    // within the core's 127
constexpr double kLeastAxis = 2;   // grid units: rounding each by sqrt(3)/2 leaves an area, 1.13^2 > 0.87^2
constexpr double kOutside = 1e3;   // stands for infinity in (s, t)

glm::dvec3 position(const QuantisedVertices& vertices, std::uint32_t v) {
  return glm::dvec3(vertices.positions[v]);
}

bool edge_axes(const QuantisedVertices& vertices, const ConvexFace& face, FaceFrame& frame) {
  const std::size_t n = face.corners.size();
  std::vector<glm::ivec3> p;
  for (const std::uint32_t v : face.corners) {
    p.push_back(vertices.positions[v]);
  }
  if (n == 4 && glm::length(glm::dvec3(p[0] + p[2] - p[1] - p[3])) <= kParallel) {
    frame.origin = p[0];
    frame.axis_u = p[1] - p[0];
    frame.axis_v = p[3] - p[0];
    return true;
  }
  if (n != 3) {
    return false;
  }
  // A triangle's corner nearest to a right angle.
  std::size_t best = 0;
  double best_cosine = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 a = glm::normalize(glm::dvec3(p[(i + 1) % 3] - p[i]));
    const glm::dvec3 b = glm::normalize(glm::dvec3(p[(i + 2) % 3] - p[i]));
    if (std::abs(glm::dot(a, b)) < best_cosine) {
      best_cosine = std::abs(glm::dot(a, b));
      best = i;
    }
  }
  frame.origin = p[best];
  frame.axis_u = p[(best + 1) % 3] - p[best];
  frame.axis_v = p[(best + 2) % 3] - p[best];
  return true;
}

void box_axes(const QuantisedVertices& vertices, const ConvexFace& face, FaceFrame& frame) {
  glm::dvec3 u(0.0);
  double longest = 0;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const glm::dvec3 edge =
        position(vertices, face.corners[(i + 1) % face.corners.size()]) - position(vertices, face.corners[i]);
    if (glm::length(edge) > longest) {
      longest = glm::length(edge);
      u = edge / longest;
    }
  }
  const glm::dvec3 v = glm::cross(face.normal, u);
  const glm::dvec3 base = position(vertices, face.corners[0]);
  glm::dvec2 low(0.0), high(0.0);
  for (const std::uint32_t c : face.corners) {
    const glm::dvec3 d = position(vertices, c) - base;
    low = glm::min(low, glm::dvec2(glm::dot(d, u), glm::dot(d, v)));
    high = glm::max(high, glm::dvec2(glm::dot(d, u), glm::dot(d, v)));
  }
  frame.origin = glm::ivec3(glm::round(base + low.x * u + low.y * v));
  frame.axis_u = glm::ivec3(glm::round(std::max(kLeastAxis, high.x - low.x) * u));
  frame.axis_v = glm::ivec3(glm::round(std::max(kLeastAxis, high.y - low.y) * v));
}

// Whether the core sees the frame from its face's lit side; edges of a sliver may turn the other way.
bool spans(const FaceFrame& frame) {
  const glm::dvec3 seen = glm::round(frame.normal * static_cast<double>(kUnit));
  return glm::dot(glm::cross(glm::dvec3(frame.axis_u), glm::dvec3(frame.axis_v)), seen) > 0;
}

Polygon2d strip(const Polygon2d& outline, double u0, double u1, double v0, double v1) {
  Polygon2d p = clip(outline, {-1.0, 0.0}, -u0);
  p = clip(p, {1.0, 0.0}, u1);
  p = clip(p, {0.0, -1.0}, -v0);
  return clip(p, {0.0, 1.0}, v1);
}

// Outline between the lines first/n and (last + 1)/n; the outermost lines are open, so that slivers beyond
// belong here.
std::pair<double, double> range(int i, int first, int last, int n) {
  return {i == first ? -kOutside : static_cast<double>(i) / n, i == last ? kOutside : (i + 1.0) / n};
}

// The run of cells whose share of the outline is no sliver; the fullest one if all are.
template <class ShareOf>
std::pair<int, int> full_run(int n, double whole, const ShareOf& share_of) {
  int first = n, last = -1, fullest = 0;
  double most = -1;
  for (int i = 0; i < n; ++i) {
    const double share = share_of(i);
    if (share > most) {
      most = share;
      fullest = i;
    }
    if (share >= kSliver * whole) {
      first = std::min(first, i);
      last = std::max(last, i);
    }
  }
  return last < 0 ? std::pair{fullest, fullest} : std::pair{first, last};
}

}  // namespace

glm::dvec3 FaceFrame::to_grid(glm::dvec2 st) const {
  const glm::dvec3 p = glm::dvec3(origin) + st.x * glm::dvec3(axis_u) + st.y * glm::dvec3(axis_v);
  return p - normal * glm::dot(normal, p - height);
}

glm::dvec2 FaceFrame::to_frame(glm::dvec3 grid_point) const {
  const glm::dvec3 u(axis_u), v(axis_v), d = grid_point - glm::dvec3(origin);
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
  const double du = glm::dot(d, u), dv = glm::dot(d, v), det = uu * vv - uv * uv;
  return {(du * vv - dv * uv) / det, (dv * uu - du * uv) / det};
}

double FaceFrame::unit_area() const {
  return glm::length(glm::cross(glm::dvec3(axis_u), glm::dvec3(axis_v)));
}

FaceFrame make_frame(const QuantisedVertices& vertices, const ConvexFace& face) {
  FaceFrame frame;
  frame.normal = face.normal;
  for (const std::uint32_t v : face.corners) {
    frame.height += position(vertices, v) / static_cast<double>(face.corners.size());
  }
  if (!edge_axes(vertices, face, frame) || !spans(frame)) {
    box_axes(vertices, face, frame);
  }
  for (const std::uint32_t v : face.corners) {
    frame.outline.push_back(frame.to_frame(position(vertices, v)));
  }
  return frame;
}

FaceElements cut_face(const FaceFrame& frame, int cells_u, int cells_v) {
  FaceElements result;
  result.cells_u = cells_u;
  result.cells_v = cells_v;
  const double cell = 1.0 / (cells_u * cells_v);
  const auto row_area = [&](int v) {
    return area(
        strip(frame.outline, -kOutside, kOutside, static_cast<double>(v) / cells_v, (v + 1.0) / cells_v));
  };
  const auto [v0, v1] = full_run(cells_v, cell, row_area);
  result.rows.resize(static_cast<std::size_t>(cells_v));
  result.row_first.resize(static_cast<std::size_t>(cells_v));
  for (int v = v0; v <= v1; ++v) {
    const auto [low, high] = range(v, v0, v1, cells_v);
    const Polygon2d row = strip(frame.outline, -kOutside, kOutside, low, high);
    const auto [u0, u1] = full_run(cells_u, cell, [&](int u) {
      return area(strip(row, static_cast<double>(u) / cells_u, (u + 1.0) / cells_u, -kOutside, kOutside));
    });
    result.rows[static_cast<std::size_t>(v)] = {u0, u1};
    result.row_first[static_cast<std::size_t>(v)] = static_cast<int>(result.elements.size());
    for (int u = u0; u <= u1; ++u) {
      const auto [left, right] = range(u, u0, u1, cells_u);
      result.elements.push_back({u, v, strip(row, left, right, -kOutside, kOutside)});
    }
  }
  for (int v = 0; v < cells_v; ++v) {
    const auto source = static_cast<std::size_t>(std::clamp(v, v0, v1));
    result.rows[static_cast<std::size_t>(v)] = result.rows[source];
    result.row_first[static_cast<std::size_t>(v)] = result.row_first[source];
  }
  return result;
}

std::pair<int, int> cells_for_size(const FaceFrame& frame, double h, int least) {
  const auto cells = [&](double length) {
    return static_cast<int>(
        std::clamp(std::round(length / h), static_cast<double>(least), static_cast<double>(kMostCells)));
  };
  return {cells(glm::length(glm::dvec3(frame.axis_u))), cells(glm::length(glm::dvec3(frame.axis_v)))};
}

}  // namespace fixrad::host
