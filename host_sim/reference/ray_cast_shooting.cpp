// SPDX-License-Identifier: MIT
#include "host_sim/reference/ray_cast_shooting.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "host_sim/io/model.h"
#include "host_sim/reference/contour.h"
#include "host_sim/reference/counter_random.h"
#include "host_sim/reference/polygon_sampling.h"
#include "host_sim/reference/visibility.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.141592653589793;
constexpr std::uint64_t kPointSeed = 0x72617963617374U;
/// Most rays a pair.
constexpr std::uint32_t kMostRays = 32;
/// Nearer than this many radii of both together, points are joined to areas instead of points.
constexpr double kNear = 1.5;
/// Overshooting ends when this many times the wanted unshot fraction is left.
constexpr double kOvershootUntil = 8.0;
constexpr float kUnknown = -1.0F;

/// Exchange areas A_i F_ij by rays between fixed stratified points of each element.
class RayCaster {
 public:
  RayCaster(const ElementMesh& mesh, std::uint32_t rays)
      : elements_(mesh.elements), rays_(rays), scene_(mesh.blocker_positions, mesh.blocker_triangles) {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const MeshElement& element = elements_[i];
      const PolygonSampler sampler(element.polygon);
      CounterRandom random(kPointSeed, i, rays);
      double reach = 0.0;
      for (const glm::dvec3& corner : element.polygon) {
        reach = std::max(reach, glm::length(corner - element.centroid));
      }
      radii_.push_back(reach);
      const double shift = random.next();
      for (std::uint32_t k = 0; k < rays; ++k) {
        const double v = shift + k * 0.6180339887498949;
        points_.push_back(sampler.sample((k + random.next()) / rays, v - std::floor(v)));
      }
    }
  }

  double exchange(std::size_t i, std::size_t j) const {
    const MeshElement& from = elements_[i];
    const MeshElement& to = elements_[j];
    if (i == j || from.plane == to.plane || !faces(from, to, radii_[j]) || !faces(to, from, radii_[i])) {
      return 0.0;
    }
    const bool is_near = glm::length(from.centroid - to.centroid) < kNear * (radii_[i] + radii_[j]);
    double total = 0.0;
    for (std::uint32_t first = 0; first < rays_; first += RayScene::kPacket) {
      total += packet(i, j, first, is_near);
    }
    return total / rays_;
  }

 private:
  /// Whether `b` reaches above the plane of `a`.
  static bool faces(const MeshElement& a, const MeshElement& b, double radius_of_b) {
    return glm::dot(a.normal, b.centroid - a.centroid) > -radius_of_b;
  }

  double packet(std::size_t i, std::size_t j, std::uint32_t first, bool is_near) const {
    const MeshElement& from = elements_[i];
    const MeshElement& to = elements_[j];
    const std::size_t shift = (i * 7 + j * 13) % rays_;
    std::array<glm::dvec3, RayScene::kPacket> p;
    std::array<glm::dvec3, RayScene::kPacket> q;
    std::array<double, RayScene::kPacket> weight{};
    std::size_t count = 0;
    for (std::uint32_t k = first; k < std::min<std::uint32_t>(rays_, first + RayScene::kPacket); ++k) {
      p[count] = points_[i * rays_ + k];
      q[count] = points_[j * rays_ + (k + shift) % rays_];
      weight[count] =
          is_near ? near_weight(from, to, p[count], q[count]) : far_weight(from, to, p[count], q[count]);
      count += weight[count] > 0.0 ? 1U : 0U;
    }
    if (count == 0) {
      return 0.0;
    }
    const std::uint32_t open = scene_.visible_packet(p.data(), from.normal, q.data(), to.normal, count);
    double total = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      total += ((open >> k) & 1U) != 0 ? weight[k] : 0.0;
    }
    return total;
  }

  static double far_weight(const MeshElement& from, const MeshElement& to, const glm::dvec3& p,
                           const glm::dvec3& q) {
    const glm::dvec3 sight = q - p;
    const double square = glm::dot(sight, sight);
    const double cosines =
        std::max(0.0, glm::dot(sight, from.normal)) * std::max(0.0, -glm::dot(sight, to.normal));
    return cosines > 0.0 ? from.area * to.area * cosines / (kPi * square * square) : 0.0;
  }

  /// Of the two closed forms that of the point on the smaller element: it varies less.
  static double near_weight(const MeshElement& from, const MeshElement& to, const glm::dvec3& p,
                            const glm::dvec3& q) {
    return from.area < to.area ? from.area * point_to_polygon(p, from.normal, to.polygon)
                               : to.area * point_to_polygon(q, to.normal, from.polygon);
  }

  const std::vector<MeshElement>& elements_;
  std::uint32_t rays_;
  RayScene scene_;
  std::vector<double> radii_;
  std::vector<glm::dvec3> points_;  // [elements][rays]
};

class Shooting {
 public:
  Shooting(const ElementMesh& mesh, const RayCastOptions& options)
      : elements_(mesh.elements),
        options_(options),
        caster_(mesh, options.rays),
        row_(mesh.elements.size()),
        received_(mesh.elements.size(), glm::dvec3{0.0}) {
    for (const MeshElement& element : elements_) {
      unshot_.push_back(element.area * element.emission);
      emitted_ += unshot_.back();
      area_ += element.area;
      mean_reflectance_ += element.area * element.reflectance;
    }
    mean_reflectance_ /= area_;
    if (options.keep_pairs) {
      pairs_.assign(elements_.size() * elements_.size(), kUnknown);
    }
  }

  RayCastResult run() {
    const auto start = std::chrono::steady_clock::now();
    RayCastResult result;
    while (left() > options_.unshot) {
      shoot(brightest());
      ++result.shots;
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const MeshElement& element = elements_[i];
      result.radiosity.push_back(element.emission + element.reflectance * received_[i] / element.area);
    }
    result.pairs = cast_;
    return result;
  }

 private:
  /// Unshot part of the emitted flux, of the worst channel.
  double left() const {
    glm::dvec3 magnitude{0.0};
    for (const glm::dvec3& unshot : unshot_) {
      magnitude += glm::abs(unshot);
    }
    double worst = 0.0;
    for (glm::length_t c = 0; c < 3; ++c) {
      worst = std::max(worst, emitted_[c] > 0.0 ? magnitude[c] / emitted_[c] : 0.0);
    }
    return worst;
  }

  std::size_t brightest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < unshot_.size(); ++i) {
      best = channel_sum(glm::abs(unshot_[i])) > channel_sum(glm::abs(unshot_[best])) ? i : best;
    }
    return best;
  }

  /// Exchange areas of element i with all others.
  void find_row(std::size_t i) {
    for (std::size_t j = 0; j < row_.size(); ++j) {
      float* kept = options_.keep_pairs ? &pairs_[i * row_.size() + j] : nullptr;
      if (kept != nullptr && *kept >= 0.0F) {
        row_[j] = *kept;
      } else {
        row_[j] = caster_.exchange(i, j);
        ++cast_;
        if (kept != nullptr) {
          *kept = static_cast<float>(row_[j]);
          pairs_[j * row_.size() + i] = *kept;
        }
      }
    }
  }

  void shoot(std::size_t i) {
    find_row(i);
    const glm::dvec3 amount = unshot_[i] + loan(i);
    const glm::dvec3 radiosity = amount / elements_[i].area;
    unshot_[i] -= amount;
    for (std::size_t j = 0; j < row_.size(); ++j) {
      const glm::dvec3 arrived = row_[j] * radiosity;
      received_[j] += arrived;
      unshot_[j] += elements_[j].reflectance * arrived;
    }
  }

  /// What the ambient estimate promises the element (M. Feda, W. Purgathofer, 1992), within its own unshot
  /// flux.
  glm::dvec3 loan(std::size_t i) const {
    if (!options_.overshoot || left() < kOvershootUntil * options_.unshot) {
      return glm::dvec3{0.0};
    }
    glm::dvec3 all{0.0};
    for (const glm::dvec3& unshot : unshot_) {
      all += unshot;
    }
    const glm::dvec3 ambient = all / area_ / (1.0 - mean_reflectance_);
    const glm::dvec3 promised = elements_[i].reflectance * ambient * elements_[i].area;
    return glm::max(glm::dvec3{0.0}, glm::min(promised, unshot_[i]));
  }

  const std::vector<MeshElement>& elements_;
  RayCastOptions options_;
  RayCaster caster_;
  std::vector<double> row_;
  std::vector<glm::dvec3> received_, unshot_;
  std::vector<float> pairs_;
  glm::dvec3 emitted_{0.0}, mean_reflectance_{0.0};
  double area_ = 0.0;
  std::uint64_t cast_ = 0;
};

}  // namespace

RayCastResult ray_cast_shooting(const ElementMesh& mesh, const RayCastOptions& options) {
  if (options.rays < 1 || options.rays > kMostRays) {
    throw std::invalid_argument("ray casting takes 1 to 32 rays a pair");
  }
  return Shooting(mesh, options).run();
}

}  // namespace fixrad::host
