// SPDX-License-Identifier: MIT
#include "host_sim/meshing/contact_lines.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host_sim/meshing/cell_cuts.h"

namespace fixrad::host {
namespace {

// Grid units. An edge this near to a plane touches it: corners are rounded to the grid.
constexpr double kTouching = 2.0;

// Grid units. Shorter lines, and lines this near to the border of the face, cut nothing off.
constexpr double kShortest = 4.0;

// A foot is cut out of a cell five hundred times as large.
constexpr LeastPart kLeast = {0.002, kShortest};

// Cosine from which the edge's own face lies in the same plane: a neighbour, no contact.
constexpr double kSamePlane = 0.999;

struct Edge {
  glm::dvec3 a, b, face_normal;
};

std::vector<Edge> edges_of(const PreparedScene& scene) {
  std::vector<Edge> edges;
  for (const ConvexFace& face : scene.faces) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      edges.push_back({glm::dvec3(scene.vertices.positions[face.corners[k]]),
                       glm::dvec3(scene.vertices.positions[face.corners[(k + 1) % face.corners.size()]]),
                       face.normal});
    }
  }
  return edges;
}

bool touches(const Edge& edge, const FaceFrame& frame) {
  return std::abs(glm::dot(edge.face_normal, frame.normal)) < kSamePlane &&
         std::abs(glm::dot(edge.a - frame.height, frame.normal)) <= kTouching &&
         std::abs(glm::dot(edge.b - frame.height, frame.normal)) <= kTouching;
}

// Grid units that a point lies within the outline; below 0 outside.
double depth_in(const FaceFrame& frame, glm::dvec3 p) {
  double depth = 1e9;
  for (std::size_t i = 0; i < frame.outline.size(); ++i) {
    const glm::dvec3 a = frame.to_grid(frame.outline[i]);
    const glm::dvec3 along = frame.to_grid(frame.outline[(i + 1) % frame.outline.size()]) - a;
    depth = std::min(depth, glm::dot(glm::cross(frame.normal, glm::normalize(along)), p - a));
  }
  return depth;
}

}  // namespace

std::vector<ContactLine> contact_lines(const PreparedScene& scene) {
  const std::vector<Edge> edges = edges_of(scene);
  std::vector<ContactLine> lines;
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const FaceFrame& frame = scene.frames[f];
    for (const Edge& edge : edges) {
      if (!touches(edge, frame)) {
        continue;
      }
      const glm::dvec2 a = frame.to_frame(edge.a), b = frame.to_frame(edge.b);
      const SegmentPart part = part_within(frame.outline, a, b);
      const glm::dvec2 from = glm::mix(a, b, part.begin), to = glm::mix(a, b, part.end);
      const glm::dvec3 middle = frame.to_grid((from + to) / 2.0);
      if (part.length() * glm::distance(edge.a, edge.b) > kShortest && depth_in(frame, middle) > kShortest) {
        lines.push_back({f, from, to});
      }
    }
  }
  return lines;
}

void cut_at_contacts(const PreparedScene& scene, Meshing& meshing) {
  for (const ContactLine& line : contact_lines(scene)) {
    meshing.element_count += static_cast<std::uint32_t>(
        cut_along(scene.frames[line.face], meshing.faces[line.face], line.a, line.b, kShortest, kLeast));
  }
}

}  // namespace fixrad::host
