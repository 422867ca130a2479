// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host_sim/meshing/critical_edges.h"
#include "host_sim/meshing/device_scene.h"

namespace fixrad::host {

/// The plane through a vertex (the apex) and an edge. Of a point of the plane, apex + depth ((1 - t) (p -
/// apex) + t (q - apex)): t in [0, 1] is the ray through the edge's point p + t (q - p), and depth is 0 at
/// the apex and 1 on the edge. 1/depth is linear in t along every straight line.
struct Wedge {
  std::uint32_t apex;
  const SceneEdge* edge;
  /// Where the light ends: beyond the edge (the apex is a lamp's vertex), or beyond the apex (the edge is a
  /// lamp's).
  bool is_beyond_edge;
  double begin = 0, end = 1;  ///< the part of the edge that counts
};

/// What a wedge's light falls on: a straight line on one face.
struct WedgeTrace {
  std::uint32_t face;
  glm::dvec3 a, b;                ///< its ends, grid units
  double nearness_a, nearness_b;  ///< 1/depth of the ends, > 0
};

/// Cuts the faces of a scene with the planes of wedges. The scene must outlive it; all answers are about the
/// last wedge that enter() was called for.
class WedgePlane {
 public:
  WedgePlane(const PreparedScene& scene, const SceneEdges& edges) : scene_(scene), edges_(edges) {}

  /// False for a wedge that is no wider than rounding.
  bool enter(const Wedge& wedge);

  /// Distance of a vertex from the plane, grid units, positive on one side; |d| <= kOnPlane counts as 0.
  double distance(std::uint32_t vertex) const;
  const glm::dvec3& normal() const { return normal_; }  ///< unit
  /// -1 or 1 where all of a face's corners lie on that side or in the plane, 2 where the plane cuts it, 0
  /// where it lies in the plane.
  int side_of(std::uint32_t face) const;

  /// What the light falls on that passes the apex and the edge: the nearest faces beyond, of those directions
  /// in which nothing stands between the apex and the edge, as far as they turn their front. Ordered by t.
  /// Faces that touch the plane without being cut by it stop nothing. Cost: the faces, and the square of
  /// those that are cut.
  void trace(std::vector<WedgeTrace>& traces);

 private:
  // A face's cut with the wedge, between two values of t.
  struct Cut {
    std::uint32_t face;
    double begin, end;            // of t
    double near_begin, near_end;  // 1/depth
    double nearness(double t) const {
      return near_begin + (near_end - near_begin) * ((t - begin) / (end - begin));
    }
  };
  // A cut's end in the wedge's homogeneous coordinates: y = t * depth.
  struct PlanePoint {
    double depth, y;
  };

  bool is_passed_by(std::uint32_t face) const;
  PlanePoint plane_point(const glm::dvec3& point) const;
  glm::dvec3 space_point(double t, double nearness) const;
  bool cut_face(std::uint32_t face, PlanePoint& a, PlanePoint& b) const;
  void add_cut(std::vector<Cut>& cuts, std::uint32_t face, PlanePoint a, PlanePoint b, double least,
               double most) const;
  void collect_cuts();
  void collect_borders();
  const Cut* nearest(double t) const;
  bool turns_front(std::uint32_t face, double t) const;

  const PreparedScene& scene_;
  const SceneEdges& edges_;
  Wedge wedge_ = {};
  glm::dvec3 apex_{0.0}, to_p_{0.0}, to_q_{0.0}, normal_{0.0};
  double margin_ = 0;  // depth within which a cut counts as touching the apex or the edge
  double pp_ = 0, pq_ = 0, qq_ = 0;
  std::vector<Cut> blockers_, receivers_;
  std::vector<double> borders_;
};

}  // namespace fixrad::host
