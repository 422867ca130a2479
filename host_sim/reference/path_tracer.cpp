// SPDX-License-Identifier: MIT
#include "host_sim/reference/path_tracer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "host_sim/reference/counter_random.h"
#include "host_sim/reference/polygon_sampling.h"
#include "host_sim/reference/visibility.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.141592653589793;
/// Roulette begins when the path's weight has sunk to this: the first bounces are worth their rays.
constexpr double kRouletteBelow = 0.5;
/// With more of the area emitting than this, a path meets lamps by itself and looking for them only adds
/// noise.
constexpr double kMostlyLamps = 0.5;

/// The random numbers of one surface point: where a path goes on, and which point of which lamp it asks.
struct BounceSample {
  double direction_u, direction_v, lamp, lamp_u, lamp_v;
};

/// Two numbers more for the first point of a path: where on the element it lies.
constexpr std::size_t kFirstDimensions = 7;

double largest(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

/// A cosine-distributed direction about a unit normal.
glm::dvec3 cosine_direction(const glm::dvec3& normal, double u, double v) {
  const glm::dvec3 helper = std::abs(normal.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
  const glm::dvec3 tangent = glm::normalize(glm::cross(normal, helper));
  const glm::dvec3 bitangent = glm::cross(normal, tangent);
  const double radius = std::sqrt(u);
  const double angle = 2.0 * kPi * v;
  return radius * (std::cos(angle) * tangent + std::sin(angle) * bitangent) + std::sqrt(1.0 - u) * normal;
}

/// cos cos / (pi r^2): the density per lamp area with which a cosine-distributed ray arrives. 0 if facing
/// away.
double point_kernel(const glm::dvec3& p, const glm::dvec3& p_normal, const glm::dvec3& q,
                    const glm::dvec3& q_normal) {
  const glm::dvec3 sight = q - p;
  const double square = glm::dot(sight, sight);
  const double cosines = std::max(0.0, glm::dot(sight, p_normal)) * std::max(0.0, -glm::dot(sight, q_normal));
  return square > 0.0 ? cosines / (kPi * square * square) : 0.0;
}

RayScene ray_scene_of(const std::vector<MeshElement>& elements,
                      std::vector<std::uint32_t>& element_of_triangle) {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    const auto corners = static_cast<std::uint32_t>(elements[i].polygon.size());
    positions.insert(positions.end(), elements[i].polygon.begin(), elements[i].polygon.end());
    for (std::uint32_t k = 1; k + 1 < corners; ++k) {
      triangles.insert(triangles.end(), {first, first + k, first + k + 1});
      element_of_triangle.push_back(i);
    }
  }
  return {positions, triangles};
}

class PathTracer {
 public:
  explicit PathTracer(const std::vector<MeshElement>& elements)
      : elements_(elements), scene_(ray_scene_of(elements, element_of_triangle_)) {
    double total_area = 0.0;
    double lamp_area = 0.0;
    double power = 0.0;
    lamp_density_.assign(elements.size(), 0.0);
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      total_area += elements[i].area;
      const double radiosity = elements[i].emission.x + elements[i].emission.y + elements[i].emission.z;
      if (radiosity > 0.0) {
        lamp_area += elements[i].area;
        power += elements[i].area * radiosity;
        lamps_.push_back(i);
        lamp_cumulative_.push_back(power);
        lamp_density_[i] = radiosity;
      }
    }
    asks_lamps_ = !lamps_.empty() && lamp_area < kMostlyLamps * total_area;
    for (double& density : lamp_density_) {
      density = asks_lamps_ ? density / power : 0.0;
    }
  }

  /// One estimate of the irradiance at a point of an element, W/m^2.
  glm::dvec3 irradiance(std::uint32_t element, glm::dvec3 point, BounceSample sample,
                        CounterRandom& random) const {
    glm::dvec3 sum{0.0};
    glm::dvec3 weight{1.0};
    while (true) {
      const glm::dvec3& normal = elements_[element].normal;
      if (asks_lamps_) {
        sum += weight * from_lamp(point, normal, sample);
      }
      const glm::dvec3 direction = cosine_direction(normal, sample.direction_u, sample.direction_v);
      const auto hit = scene_.nearest(point, normal, direction);
      if (!hit || !hit->front) {
        return sum;
      }
      element = element_of_triangle_[hit->triangle];
      const MeshElement& met = elements_[element];
      const glm::dvec3 start = point;
      point += hit->distance * direction;
      point -= glm::dot(point - met.centroid, met.normal) * met.normal;  // back into its plane, in double
      sum += weight * met.emission * share_of_path(start, normal, point, element);
      weight *= met.reflectance;
      if (!survives(weight, random)) {
        return sum;
      }
      sample = {random.next(), random.next(), random.next(), random.next(), random.next()};
    }
  }

 private:
  /// Light from one point of one lamp, over the sum of the densities with which both ways would have chosen
  /// it.
  glm::dvec3 from_lamp(const glm::dvec3& point, const glm::dvec3& normal, const BounceSample& sample) const {
    const auto found = std::upper_bound(lamp_cumulative_.begin(), lamp_cumulative_.end() - 1,
                                        sample.lamp * lamp_cumulative_.back());
    const std::uint32_t lamp = lamps_[static_cast<std::size_t>(found - lamp_cumulative_.begin())];
    const MeshElement& emitter = elements_[lamp];
    const glm::dvec3 target = sample_polygon(emitter.polygon, sample.lamp_u, sample.lamp_v);
    const double kernel = point_kernel(point, normal, target, emitter.normal);
    if (kernel == 0.0 || !scene_.visible(point, normal, target, emitter.normal)) {
      return glm::dvec3{0.0};
    }
    return emitter.emission * (kernel / (kernel + lamp_density_[lamp]));
  }

  /// The balance heuristic's part for a lamp that the path itself has met.
  double share_of_path(const glm::dvec3& start, const glm::dvec3& normal, const glm::dvec3& point,
                       std::uint32_t element) const {
    if (lamp_density_[element] == 0.0) {
      return 1.0;
    }
    const double kernel = point_kernel(start, normal, point, elements_[element].normal);
    return kernel / (kernel + lamp_density_[element]);
  }

  static bool survives(glm::dvec3& weight, CounterRandom& random) {
    const double chance = largest(weight) / kRouletteBelow;
    if (chance >= 1.0) {
      return true;
    }
    if (random.next() >= chance) {
      return false;
    }
    weight /= chance;
    return true;
  }

  const std::vector<MeshElement>& elements_;
  std::vector<std::uint32_t> element_of_triangle_;
  RayScene scene_;
  std::vector<std::uint32_t> lamps_;     // elements that emit
  std::vector<double> lamp_cumulative_;  // running sum of their power
  std::vector<double> lamp_density_;     // an element: density per area with which a lamp point is chosen
  bool asks_lamps_ = false;
};

/// Steps of the Kronecker sequence of the generalised golden ratio, the root of x^(d+1) = x + 1: evenly
/// spread in d dimensions (M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018).
std::array<double, kFirstDimensions> kronecker_steps() {
  double root = 1.0;
  for (int k = 0; k < 64; ++k) {
    root = std::pow(1.0 + root, 1.0 / (kFirstDimensions + 1.0));
  }
  std::array<double, kFirstDimensions> steps{};
  double step = 1.0;
  for (double& value : steps) {
    step /= root;
    value = step;
  }
  return steps;
}

/// Mean irradiance over an element from one randomly shifted stretch of the sequence.
glm::dvec3 batch_mean(const PathTracer& tracer, const MeshElement& element, std::uint32_t index,
                      std::uint32_t paths, CounterRandom& random) {
  static const std::array<double, kFirstDimensions> steps = kronecker_steps();
  std::array<double, kFirstDimensions> x{};
  for (double& value : x) {
    value = random.next();
  }
  glm::dvec3 sum{0.0};
  for (std::uint32_t path = 0; path < paths; ++path) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      x[k] += steps[k];
      x[k] -= x[k] >= 1.0 ? 1.0 : 0.0;
    }
    const glm::dvec3 point = sample_polygon(element.polygon, x[2], x[3]);
    sum += tracer.irradiance(index, point, {x[0], x[1], x[6], x[4], x[5]}, random);
  }
  return sum / static_cast<double>(paths);
}

}  // namespace

PathTracedRadiosity path_traced_radiosity(const ElementMesh& mesh, const PathTracingOptions& options) {
  if (options.paths_per_element == 0 || options.batches < 2) {
    throw std::invalid_argument("path tracing needs at least one path an element and two batches");
  }
  const PathTracer tracer(mesh.elements);
  const double batches = options.batches;
  const std::uint32_t paths = (options.paths_per_element - 1) / options.batches + 1;
  PathTracedRadiosity result;
  result.mean.resize(mesh.elements.size());
  result.standard_error.resize(mesh.elements.size());
  tbb::parallel_for(std::size_t{0}, mesh.elements.size(), [&](std::size_t i) {
    const MeshElement& element = mesh.elements[i];
    std::vector<glm::dvec3> means;
    glm::dvec3 mean{0.0};
    for (std::uint32_t batch = 0; batch < options.batches; ++batch) {
      CounterRandom random(options.seed, i, batch);
      means.push_back(batch_mean(tracer, element, static_cast<std::uint32_t>(i), paths, random));
      mean += means.back() / batches;
    }
    glm::dvec3 squares{0.0};
    for (const glm::dvec3& value : means) {
      squares += (value - mean) * (value - mean);
    }
    result.mean[i] = element.emission + element.reflectance * mean;
    result.standard_error[i] = element.reflectance * glm::sqrt(squares / (batches * (batches - 1.0)));
  });
  return result;
}

}  // namespace fixrad::host
