// SPDX-License-Identifier: MIT
#include "host_sim/reference/contact_cuts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/meshing/segment_part.h"

namespace fixrad::host {
namespace {

/// An edge this near to a plane, in grid units, touches it: corners are rounded to the grid.
constexpr double kTouching = 2.0;
/// Cosine from which the edge's own face lies in the element's plane: a neighbour, no contact.
constexpr double kSamePlane = 0.999;
/// A piece smaller than this part of its element is not worth a cut.
constexpr double kSliver = 1e-4;

using Corners = std::vector<glm::dvec3>;

struct Edge {
  glm::dvec3 a, b, face_normal;
};

std::vector<Edge> edges_of(const PreparedScene& scene) {
  const auto at = [&](std::uint32_t v) {
    return scene.vertices.grid.to_scene(glm::dvec3(scene.vertices.positions[v]));
  };
  std::vector<Edge> edges;
  for (const ConvexFace& face : scene.faces) {
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      edges.push_back({at(face.corners[k]), at(face.corners[(k + 1) % face.corners.size()]), face.normal});
    }
  }
  return edges;
}

bool touches(const Edge& edge, const MeshElement& element, double reach) {
  return std::abs(glm::dot(edge.face_normal, element.normal)) < kSamePlane &&
         std::abs(glm::dot(edge.a - element.centroid, element.normal)) <= reach &&
         std::abs(glm::dot(edge.b - element.centroid, element.normal)) <= reach;
}

/// The part of a convex polygon on the side of a line that `across` (in its plane) points to.
Corners clip(const Corners& polygon, const glm::dvec3& on_line, const glm::dvec3& across) {
  Corners kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3& p = polygon[k];
    const glm::dvec3& q = polygon[(k + 1) % polygon.size()];
    const double at_p = glm::dot(p - on_line, across);
    const double at_q = glm::dot(q - on_line, across);
    if (at_p >= 0.0) {
      kept.push_back(p);
    }
    if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0)) {
      kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  return kept;
}

/// Length of a segment's part within a convex polygon.
double length_within(const Edge& edge, const MeshElement& element) {
  SegmentPart part;
  for (std::size_t k = 0; k < element.polygon.size(); ++k) {
    const glm::dvec3& p = element.polygon[k];
    const glm::dvec3& q = element.polygon[(k + 1) % element.polygon.size()];
    const glm::dvec3 inward = glm::cross(element.normal, q - p);
    part.keep_where(glm::dot(edge.a - p, inward), glm::dot(edge.b - p, inward));
  }
  return part.length() * glm::length(edge.b - edge.a);
}

/// An element with another outline in its plane.
MeshElement with_outline(const MeshElement& element, const Corners& corners) {
  MeshElement piece = element;
  piece.polygon = corners;
  piece.area = 0.0;
  piece.centroid = glm::dvec3{0.0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const double area =
        0.5 * glm::dot(glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]), element.normal);
    piece.area += area;
    piece.centroid += area * (corners[0] + corners[k] + corners[k + 1]) / 3.0;
  }
  piece.centroid /= piece.area > 0.0 ? piece.area : 1.0;
  return piece;
}

/// All pieces of an element.
std::vector<MeshElement> cut(const MeshElement& element, const std::vector<Edge>& edges, double reach) {
  std::vector<MeshElement> pieces{element};
  for (const Edge& edge : edges) {
    if (!touches(edge, element, reach)) {
      continue;
    }
    const glm::dvec3 across = glm::cross(element.normal, edge.b - edge.a);
    std::vector<MeshElement> finer;
    for (const MeshElement& piece : pieces) {
      const MeshElement left = with_outline(piece, clip(piece.polygon, edge.a, across));
      const MeshElement right = with_outline(piece, clip(piece.polygon, edge.a, -across));
      if (std::min(left.area, right.area) < kSliver * element.area || length_within(edge, piece) <= reach) {
        finer.push_back(piece);
      } else {
        finer.insert(finer.end(), {left, right});
      }
    }
    pieces.swap(finer);
  }
  return pieces;
}

}  // namespace

OverlappedMesh cut_at_contacts(const PreparedScene& scene, const DeviceScene& device) {
  const std::vector<Edge> edges = edges_of(scene);
  const double reach = kTouching / scene.vertices.grid.scale;
  OverlappedMesh result;
  result.mesh.blocker_positions = device.mesh.blocker_positions;
  result.mesh.blocker_triangles = device.mesh.blocker_triangles;
  auto overlap = device.overlaps.begin();
  for (std::uint32_t e = 0; e < device.mesh.elements.size(); ++e) {
    const MeshElement& element = device.mesh.elements[e];
    const auto first = static_cast<std::uint32_t>(result.mesh.elements.size());
    const std::vector<MeshElement> pieces = cut(element, edges, reach);
    result.mesh.elements.insert(result.mesh.elements.end(), pieces.begin(), pieces.end());
    const auto own = overlap;
    while (overlap != device.overlaps.end() && overlap->element == e) {
      ++overlap;
    }
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
      const double part = pieces[piece].area / element.area;
      std::for_each(own, overlap, [&](const Overlap& o) {
        result.overlaps.push_back({first + piece, o.input_face, part * o.area});
      });
    }
  }
  return result;
}

}  // namespace fixrad::host
