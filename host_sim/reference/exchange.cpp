// SPDX-License-Identifier: MIT
#include "host_sim/reference/exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host_sim/reference/contour.h"
#include "host_sim/reference/counter_random.h"
#include "host_sim/reference/polygon_sampling.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr std::uint64_t kJitterSeed = 0x666f726d66616374U;
/// An element this many of its radii away from the other needs no graded quadrature: four points are within
/// 0.1 %.
constexpr double kFarInRadii = 4.0;
/// Two elements this many of their radii apart need no closed form: 4 points on either are within 0.1 %.
constexpr double kFarApart = 3.0;
/// Sample points, at least, where the other element is half hidden.
constexpr std::size_t kPartialPoints = 16;

using Points = std::vector<QuadraturePoint>;  // weight: area times form factor to the other element

double radius(const MeshElement& element) {
  double reach = 0.0;
  for (const glm::dvec3& corner : element.polygon) {
    reach = std::max(reach, glm::length(corner - element.centroid));
  }
  return reach;
}

bool emits(const MeshElement& element) {
  return element.emission != glm::dvec3{0.0};
}

/// Whether some corner of b lies in front of a's plane.
bool looks_at(const MeshElement& a, const MeshElement& b) {
  return std::any_of(b.polygon.begin(), b.polygon.end(),
                     [&](const glm::dvec3& corner) { return glm::dot(a.normal, corner - a.centroid) > 0.0; });
}

/// Van der Corput's sequence: the binary digits of an index, mirrored at the point. In [0, 1).
double radical_inverse(std::uint32_t index) {
  double value = 0.0;
  for (double digit = 0.5; index != 0; index >>= 1U, digit *= 0.5) {
    value += (index & 1U) != 0 ? digit : 0.0;
  }
  return value;
}

/// cos cos / r^2 between two surface points, 0 where one faces away.
double kernel(const glm::dvec3& p, const glm::dvec3& p_normal, const glm::dvec3& q,
              const glm::dvec3& q_normal) {
  const glm::dvec3 sight = q - p;
  const double square = glm::dot(sight, sight);
  const double cosines = std::max(0.0, glm::dot(sight, p_normal)) * std::max(0.0, -glm::dot(sight, q_normal));
  return square > 0.0 ? cosines / (square * square) : 0.0;
}

double sum_of_weights(const Points& points) {
  double sum = 0.0;
  for (const QuadraturePoint& point : points) {
    sum += point.weight;
  }
  return sum;
}

/// Unblocked exchange from `from` to `to`: quadrature on the one, closed form over the other.
class ExchangeQuadrature {
 public:
  ExchangeQuadrature(const MeshElement& from, const MeshElement& to, const FormFactorOptions& options)
      : from_(from), to_(to), options_(options), cells_(quadrature_cells(from.polygon)) {}

  /// Every cell split `splits` times.
  Points uniform(int splits) const {
    std::vector<QuadratureCell> cells = cells_;
    for (int k = 0; k < splits; ++k) {
      std::vector<QuadratureCell> finer;
      for (const QuadratureCell& cell : cells) {
        const auto children = cell.split();
        finer.insert(finer.end(), children.begin(), children.end());
      }
      cells.swap(finer);
    }
    Points points;
    for (const QuadratureCell& cell : cells) {
      append(points, evaluate(cell));
    }
    return points;
  }

  /// Cells split where that still changes the result.
  Points graded() {
    estimate_ = sum_of_weights(uniform(0));
    Points points;
    for (const QuadratureCell& cell : cells_) {
      refine(cell, evaluate(cell), options_.quadrature_depth, points);
    }
    return points;
  }

 private:
  static void append(Points& points, const Points& more) {
    points.insert(points.end(), more.begin(), more.end());
  }

  Points evaluate(const QuadratureCell& cell) const {
    const auto rule = cell.points();
    Points points(rule.begin(), rule.end());
    for (QuadraturePoint& point : points) {
      point.weight *= point_to_polygon(point.position, from_.normal, to_.polygon);
    }
    return points;
  }

  void refine(const QuadratureCell& cell, const Points& coarse, int depth, Points& result) {
    std::array<Points, 4> fine;
    const auto children = cell.split();
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      fine[k] = evaluate(children[k]);
      sum += sum_of_weights(fine[k]);
    }
    estimate_ = std::max(estimate_, sum);
    const double change = std::abs(sum - sum_of_weights(coarse));
    const bool settled = depth <= 1 || change <= options_.quadrature_tolerance * estimate_;
    for (std::size_t k = 0; k < 4; ++k) {
      if (settled) {
        append(result, fine[k]);
      } else {
        refine(children[k], fine[k], depth - 1, result);
      }
    }
  }

  const MeshElement& from_;
  const MeshElement& to_;
  const FormFactorOptions& options_;
  std::vector<QuadratureCell> cells_;
  double estimate_ = 0.0;
};

/// Exchange of two elements that are small beside their distance: Gauss-Legendre points on both, times the
/// part of a few stratified rays that gets through.
class FarExchange {
 public:
  FarExchange(const MeshElement& i, const MeshElement& j, const RayScene& scene, std::uint64_t stream)
      : i_(i), j_(j), scene_(scene), random_(kJitterSeed, stream, 1) {}

  double value(std::uint32_t rays) {
    const double open = unblocked();
    return open > 0.0 ? open * visible_part(std::min<std::uint32_t>(rays, RayScene::kPacket)) : 0.0;
  }

 private:
  double unblocked() const {
    double sum = 0.0;
    for (const QuadratureCell& from : quadrature_cells(i_.polygon)) {
      const auto p = from.points();
      for (const QuadratureCell& to : quadrature_cells(j_.polygon)) {
        const auto q = to.points();
        for (const QuadraturePoint& a : p) {
          for (const QuadraturePoint& b : q) {
            sum += a.weight * b.weight * kernel(a.position, i_.normal, b.position, j_.normal);
          }
        }
      }
    }
    return sum / kPi;
  }

  double visible_part(std::uint32_t rays) {
    std::array<glm::dvec3, RayScene::kPacket> p;
    std::array<glm::dvec3, RayScene::kPacket> q;
    const double shift = random_.next();
    for (std::uint32_t ray = 0; ray < rays; ++ray) {
      const double stratum = (ray + random_.next()) / rays;
      const double v = radical_inverse(ray) + shift;
      p[ray] = sample_polygon(i_.polygon, stratum, v - std::floor(v));
      const double w = radical_inverse(ray) + random_.next();
      q[ray] = sample_polygon(j_.polygon, random_.next(), w - std::floor(w));
    }
    const std::uint32_t seen = scene_.visible_packet(p.data(), i_.normal, q.data(), j_.normal, rays);
    double open = 0.0;
    double total = 0.0;
    for (std::uint32_t ray = 0; ray < rays; ++ray) {
      const double weight = kernel(p[ray], i_.normal, q[ray], j_.normal);
      total += weight;
      open += ((seen >> ray) & 1U) != 0 ? weight : 0.0;
    }
    return total > 0.0 ? open / total : 0.0;
  }

  const MeshElement& i_;
  const MeshElement& j_;
  const RayScene& scene_;
  CounterRandom random_;
};

/// Rays from sample points of `from` to `to`.
class VisibleFraction {
 public:
  VisibleFraction(const MeshElement& from, const MeshElement& to, const RayScene& scene, std::uint64_t stream)
      : from_(from), to_(to), scene_(scene), random_(kJitterSeed, stream, 0) {}

  /// The part of `to` that a point sees, each ray weighted by the form factor of the bit that it stands for.
  /// A randomly shifted Hammersley set: even in each direction by itself too, where edges of blockers mostly
  /// run.
  double at(const glm::dvec3& point, std::uint32_t rays) {
    const double shift_u = random_.next();
    const double shift_v = random_.next();
    double open = 0.0;
    double total = 0.0;
    for (std::uint32_t ray = 0; ray < rays; ++ray) {
      const double v = radical_inverse(ray) + shift_v;
      const glm::dvec3 target = sample_polygon(to_.polygon, (ray + shift_u) / rays, v - std::floor(v));
      const double weight = kernel(point, from_.normal, target, to_.normal);
      total += weight;
      open += weight > 0.0 && scene_.visible(point, from_.normal, target, to_.normal) ? weight : 0.0;
    }
    return total > 0.0 ? open / total : at_highest_corner(point);
  }

 private:
  /// Where only a corner of `to` rises above the horizon, no ray may find it.
  double at_highest_corner(const glm::dvec3& point) const {
    const auto height = [&](const glm::dvec3& corner) { return glm::dot(from_.normal, corner - point); };
    const auto corner =
        std::max_element(to_.polygon.begin(), to_.polygon.end(),
                         [&](const glm::dvec3& a, const glm::dvec3& b) { return height(a) < height(b); });
    const glm::dvec3 target = glm::mix(*corner, to_.centroid, 1e-3);
    return scene_.visible(point, from_.normal, target, to_.normal) ? 1.0 : 0.0;
  }

  const MeshElement& from_;
  const MeshElement& to_;
  const RayScene& scene_;
  CounterRandom random_;
};

double visible_exchange(const Points& points, VisibleFraction& visible, std::uint32_t rays) {
  double sum = 0.0;
  for (const QuadraturePoint& point : points) {
    if (point.weight > 0.0) {
      sum += point.weight * visible.at(point.position, rays);
    }
  }
  return sum;
}

}  // namespace

double exchange(const MeshElement& i, const MeshElement& j, const RayScene& scene,
                const FormFactorOptions& options, std::uint64_t stream) {
  if (i.plane == j.plane || !looks_at(i, j) || !looks_at(j, i)) {
    return 0.0;
  }
  const double distance = glm::length(i.centroid - j.centroid);
  if (options.far_rays > 0 && !emits(i) && !emits(j) && distance > kFarApart * (radius(i) + radius(j))) {
    return FarExchange(i, j, scene, stream).value(options.far_rays);
  }
  // The closed form takes the larger element; the integrand varies least over the smaller one.
  const bool i_is_smaller = i.area <= j.area;
  const MeshElement& from = i_is_smaller ? i : j;
  const MeshElement& to = i_is_smaller ? j : i;
  const double gap = distance - radius(to);
  ExchangeQuadrature quadrature(from, to, options);
  Points points = gap > kFarInRadii * radius(from) ? quadrature.uniform(0) : quadrature.graded();
  const double unblocked = sum_of_weights(points);
  if (unblocked == 0.0) {
    return 0.0;
  }
  VisibleFraction visible(from, to, scene, stream);
  const double probed =
      visible_exchange(points, visible, points.size() > kPartialPoints ? 1 : options.probe_rays);
  const double rounding = 1e-12 * unblocked;
  if (probed <= rounding || probed >= unblocked - rounding) {
    return std::min(probed, unblocked);
  }
  if (points.size() < kPartialPoints) {
    points = quadrature.uniform(1);
  }
  return visible_exchange(points, visible, options.partial_rays);
}

}  // namespace fixrad::host
