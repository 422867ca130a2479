// SPDX-License-Identifier: MIT
#include "host_sim/meshing/critical_wedge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/meshing/segment_part.h"

namespace fixrad::host {
namespace {

constexpr double kShortestTurn = 1e-7;  // of t; what is narrower is rounding
constexpr double kSameNearness = 1e-7;  // relative; faces that lie on each other
constexpr double kLargestMargin = 0.25;

double height_over(const FaceFrame& frame, const glm::dvec3& point) {
  return glm::dot(frame.normal, point - frame.height);
}

}  // namespace

bool WedgePlane::enter(const Wedge& wedge) {
  const auto at = [&](std::uint32_t v) { return glm::dvec3(scene_.vertices.positions[v]); };
  wedge_ = wedge;
  apex_ = at(wedge.apex);
  to_p_ = at(wedge.edge->p) - apex_;
  to_q_ = at(wedge.edge->q) - apex_;
  const glm::dvec3 normal = glm::cross(to_p_, to_q_);
  const double length = glm::length(normal);
  const double reach = std::max(glm::length(to_p_), glm::length(to_q_));
  const double height = length / std::max(1.0, glm::length(to_q_ - to_p_));
  if (length <= kTouchingPlane * reach || height <= 2 * kTouchingPlane) {
    return false;
  }
  margin_ = std::min(kLargestMargin, kTouchingPlane / height);
  pp_ = glm::dot(to_p_, to_p_);
  pq_ = glm::dot(to_p_, to_q_);
  qq_ = glm::dot(to_q_, to_q_);
  normal_ = normal / length;
  return true;
}

double WedgePlane::distance(std::uint32_t vertex) const {
  const double d = glm::dot(normal_, glm::dvec3(scene_.vertices.positions[vertex]) - apex_);
  return std::abs(d) <= kOnPlane ? 0.0 : d;
}

int WedgePlane::side_of(std::uint32_t face) const {
  bool is_above = false, is_below = false;
  for (const std::uint32_t v : scene_.faces[face].corners) {
    const double d = distance(v);
    is_above = is_above || d > 0;
    is_below = is_below || d < 0;
  }
  if (is_above && is_below) {
    return 2;
  }
  return (is_above ? 1 : 0) - (is_below ? 1 : 0);
}

// Faces at the edge end there, and whether they let light pass is a question of silhouettes; a plane through
// the apex is met in the apex only.
bool WedgePlane::is_passed_by(std::uint32_t face) const {
  const std::vector<std::uint32_t>& own = wedge_.edge->faces;
  return std::find(own.begin(), own.end(), face) != own.end() ||
         borders_on(edges_.sectors[wedge_.apex], face) ||
         (wedge_.is_beyond_edge && std::abs(height_over(scene_.frames[face], apex_)) <= kTouchingPlane);
}

WedgePlane::PlanePoint WedgePlane::plane_point(const glm::dvec3& point) const {
  const double dp = glm::dot(point - apex_, to_p_), dq = glm::dot(point - apex_, to_q_);
  const double determinant = pp_ * qq_ - pq_ * pq_;
  const double a = (dp * qq_ - dq * pq_) / determinant;
  const double b = (dq * pp_ - dp * pq_) / determinant;
  return {a + b, b};
}

glm::dvec3 WedgePlane::space_point(double t, double nearness) const {
  const double depth = (wedge_.is_beyond_edge ? 1.0 : -1.0) / nearness;
  return apex_ + depth * ((1 - t) * to_p_ + t * to_q_);
}

bool WedgePlane::cut_face(std::uint32_t face, PlanePoint& a, PlanePoint& b) const {
  const std::vector<std::uint32_t>& corners = scene_.faces[face].corners;
  PlanePoint points[2 * kMaxCorners];
  std::size_t count = 0;
  for (std::size_t k = 0; k < corners.size() && count + 2 <= std::size(points); ++k) {
    const std::uint32_t v = corners[k], next = corners[(k + 1) % corners.size()];
    const glm::dvec3 p(scene_.vertices.positions[v]), q(scene_.vertices.positions[next]);
    const double at_p = distance(v), at_q = distance(next);
    if (at_p == 0) {
      points[count++] = plane_point(p);
    } else if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      points[count++] = plane_point(p + (q - p) * (at_p / (at_p - at_q)));
    }
  }
  double farthest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double d = std::hypot(points[i].depth - points[j].depth, points[i].y - points[j].y);
      if (d > farthest) {
        farthest = d;
        a = points[i];
        b = points[j];
      }
    }
  }
  return farthest > 0;
}

void WedgePlane::add_cut(std::vector<Cut>& cuts, std::uint32_t face, PlanePoint a, PlanePoint b, double least,
                         double most) const {
  SegmentPart part;
  part.keep_where(a.depth - least, b.depth - least);
  part.keep_where(most - a.depth, most - b.depth);
  part.keep_where(a.y - wedge_.begin * a.depth, b.y - wedge_.begin * b.depth);
  part.keep_where(wedge_.end * a.depth - a.y, wedge_.end * b.depth - b.y);
  if (part.length() <= 0) {
    return;
  }
  const auto end_of = [&](double s) {
    return PlanePoint{a.depth + s * (b.depth - a.depth), a.y + s * (b.y - a.y)};
  };
  PlanePoint first = end_of(part.begin), last = end_of(part.end);
  if (first.y * last.depth > last.y * first.depth) {
    std::swap(first, last);
  }
  const double begin = first.y / first.depth, end = last.y / last.depth;
  if (end - begin > kShortestTurn) {
    cuts.push_back({face, begin, end, 1 / first.depth, 1 / last.depth});
  }
}

void WedgePlane::collect_cuts() {
  blockers_.clear();
  receivers_.clear();
  constexpr double kFar = std::numeric_limits<double>::max();
  for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
    PlanePoint a = {}, b = {};
    if (side_of(f) != 2 || is_passed_by(f) || !cut_face(f, a, b)) {
      continue;
    }
    add_cut(blockers_, f, a, b, margin_, 1 - margin_);
    if (wedge_.is_beyond_edge) {
      add_cut(receivers_, f, a, b, 1 - margin_, kFar);
    } else {
      add_cut(receivers_, f, {-a.depth, -a.y}, {-b.depth, -b.y}, margin_, kFar);
    }
  }
}

// Between neighbouring borders the nearest face is the same for all t.
void WedgePlane::collect_borders() {
  borders_ = {wedge_.begin, wedge_.end};
  for (const std::vector<Cut>* cuts : {&blockers_, &receivers_}) {
    for (const Cut& cut : *cuts) {
      borders_.push_back(cut.begin);
      borders_.push_back(cut.end);
    }
  }
  for (std::size_t i = 0; i < receivers_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Cut &a = receivers_[i], &b = receivers_[j];
      const double begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
      const double first = a.nearness(begin) - b.nearness(begin), last = a.nearness(end) - b.nearness(end);
      if (begin < end && first * last < 0) {
        borders_.push_back(begin + (end - begin) * (first / (first - last)));
      }
    }
  }
  std::sort(borders_.begin(), borders_.end());
}

bool WedgePlane::turns_front(std::uint32_t face, double t) const {
  const glm::dvec3 from = wedge_.is_beyond_edge ? apex_ : apex_ + (1 - t) * to_p_ + t * to_q_;
  return height_over(scene_.frames[face], from) > kTouchingPlane;
}

const WedgePlane::Cut* WedgePlane::nearest(double t) const {
  const auto covers = [&](const Cut& cut) { return cut.begin <= t && t <= cut.end; };
  if (std::any_of(blockers_.begin(), blockers_.end(), covers)) {
    return nullptr;
  }
  const Cut* best = nullptr;
  for (const Cut& cut : receivers_) {
    if (!covers(cut)) {
      continue;
    }
    const double ahead = best == nullptr ? 1.0 : cut.nearness(t) / best->nearness(t) - 1;
    if (ahead > kSameNearness || (ahead > -kSameNearness && turns_front(cut.face, t))) {
      best = &cut;
    }
  }
  return best != nullptr && turns_front(best->face, t) ? best : nullptr;
}

void WedgePlane::trace(std::vector<WedgeTrace>& traces) {
  collect_cuts();
  collect_borders();
  const Cut* open = nullptr;
  for (std::size_t i = 0; i + 1 < borders_.size(); ++i) {
    const double begin = borders_[i], end = borders_[i + 1];
    if (end - begin <= kShortestTurn) {
      continue;
    }
    const Cut* cut = nearest((begin + end) / 2);
    if (cut != nullptr && cut == open) {
      traces.back().b = space_point(end, cut->nearness(end));
      traces.back().nearness_b = cut->nearness(end);
    } else if (cut != nullptr) {
      const double first = cut->nearness(begin), last = cut->nearness(end);
      traces.push_back({cut->face, space_point(begin, first), space_point(end, last), first, last});
    }
    open = cut;
  }
}

}  // namespace fixrad::host
