// SPDX-License-Identifier: MIT
#include "host_sim/reference/path_tracer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "host_sim/io/model.h"
#include "host_sim/reference/sobol.h"

namespace fixrad::host {
namespace {

/// Paths of the first round, a face and batch.
constexpr std::uint32_t kPilotPaths = 128;
/// Weight of relative errors of single faces beside the mean error of all.
constexpr double kDarkFaces = 0.1;
/// Faces darker than this part of the mean count as if they were as bright.
constexpr double kDarkest = 0.1;
/// Cosine between normals from which two polygons at one place lie in one plane.
constexpr double kSamePlane = 0.99;

/// Something to be measured: points of polygons, sampled evenly by area, or a single point.
class Target {
 public:
  explicit Target(const SurfacePoint& point) : point_(point) {}
  Target() = default;

  void add(const MeshElement& polygon) {
    area_ += polygon.area;
    parts_.push_back({area_, polygon.normal, PolygonSampler(polygon.polygon)});
  }

  double area() const { return area_; }

  SurfacePoint sample(double u, double v) const {
    if (parts_.empty()) {
      return point_;
    }
    const double at = u * area_;
    const auto part = std::upper_bound(parts_.begin(), parts_.end() - 1, at,
                                       [](double area, const Part& next) { return area < next.area; });
    const double before = part == parts_.begin() ? 0.0 : (part - 1)->area;
    const double within = std::clamp((at - before) / (part->area - before), 0.0, 1.0);
    return {part->sampler.sample(within, v), part->normal};
  }

 private:
  struct Part {
    double area;  ///< running sum
    glm::dvec3 normal;
    PolygonSampler sampler;
  };

  double area_ = 0.0;
  SurfacePoint point_;
  std::vector<Part> parts_;
};

/// Mean irradiance over a target from one scrambled copy of the set.
glm::dvec3 batch_mean(const PathEstimator& estimator, const Target& target, std::uint32_t paths,
                      CounterRandom& random) {
  ScrambledSobol set(random.next_bits());
  glm::dvec3 sum{0.0};
  for (std::uint32_t path = 0; path < paths; ++path) {
    const auto x = set.next();
    sum += estimator.irradiance(target.sample(x[0], x[1]), {{x[2], x[3], x[4], x[5], x[6]}, x[7], x[8], x[9]},
                                random);
  }
  return sum / static_cast<double>(paths);
}

std::uint32_t power_of_two(double at_least) {
  std::uint32_t power = 1;
  while (power < at_least && power < 1U << 31U) {
    power *= 2;
  }
  return power;
}

/// Mean irradiance over each target and its standard error, from `paths` [targets] a batch, 0 for none.
Traced trace(const PathEstimator& estimator, const std::vector<Target>& targets,
             const std::vector<std::uint32_t>& paths, std::uint32_t batches, std::uint64_t seed) {
  if (batches < 2) {
    throw std::invalid_argument("path tracing needs at least two batches: their scatter is the error");
  }
  std::vector<glm::dvec3> means(targets.size() * batches, glm::dvec3{0.0});
  tbb::parallel_for(std::size_t{0}, means.size(), [&](std::size_t task) {
    const std::size_t target = task / batches;
    if (paths[target] > 0) {
      CounterRandom random(seed, target, task % batches);
      means[task] = batch_mean(estimator, targets[target], paths[target], random);
    }
  });
  Traced result;
  for (std::size_t target = 0; target < targets.size(); ++target) {
    const glm::dvec3* of_target = means.data() + target * batches;
    glm::dvec3 mean{0.0};
    glm::dvec3 squares{0.0};
    for (std::uint32_t batch = 0; batch < batches; ++batch) {
      mean += of_target[batch] / static_cast<double>(batches);
    }
    for (std::uint32_t batch = 0; batch < batches; ++batch) {
      squares += (of_target[batch] - mean) * (of_target[batch] - mean);
    }
    result.mean.push_back(mean);
    result.standard_error.push_back(glm::sqrt(squares / (batches * (batches - 1.0))));
  }
  return result;
}

/// Input faces as targets.
struct Faces {
  std::vector<Target> targets;
  std::vector<glm::dvec3> reflectance, emission;

  explicit Faces(const std::vector<MeshElement>& polygons) {
    for (const MeshElement& polygon : polygons) {
      const std::size_t face = polygon.input_face;
      if (face >= targets.size()) {
        targets.resize(face + 1);
        reflectance.resize(face + 1, glm::dvec3{0.0});
        emission.resize(face + 1, glm::dvec3{0.0});
      }
      targets[face].add(polygon);
      reflectance[face] = polygon.reflectance;
      emission[face] = polygon.emission;
    }
  }

  Traced radiosity(Traced irradiance) const {
    for (std::size_t f = 0; f < targets.size(); ++f) {
      irradiance.mean[f] = emission[f] + reflectance[f] * irradiance.mean[f];
      irradiance.standard_error[f] *= reflectance[f];
    }
    return irradiance;
  }
};

/// Where several faces meet, a point lies in the planes of its neighbours, and it is a matter of rounding
/// from which side rays leave. Moves it off them, to their lit sides, by as much as rays are lifted off
/// surfaces.
class EdgeClearance {
 public:
  explicit EdgeClearance(const std::vector<MeshElement>& polygons) : polygons_(polygons) {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
    for (const MeshElement& polygon : polygons) {
      double radius = 0.0;
      for (const glm::dvec3& corner : polygon.polygon) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
        radius = std::max(radius, glm::length(corner - polygon.centroid));
      }
      radii_.push_back(radius);
    }
    const glm::dvec3 size = high - low;
    lift_ = 0.5 * RayScene::kLift * std::max({size.x, size.y, size.z});
  }

  SurfacePoint clear(const SurfacePoint& point) const {
    SurfacePoint cleared = point;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const MeshElement& polygon = polygons_[i];
      const glm::dvec3 offset = point.position - polygon.centroid;
      const bool is_near =
          std::abs(glm::dot(offset, polygon.normal)) < lift_ && glm::length(offset) < radii_[i] + lift_;
      if (is_near && std::abs(glm::dot(point.normal, polygon.normal)) < kSamePlane) {
        cleared.position += lift_ * polygon.normal;
      }
    }
    return cleared;
  }

 private:
  const std::vector<MeshElement>& polygons_;
  std::vector<double> radii_;
  double lift_ = 0.0;
};

/// What a unit of each face's standard error (radiosity, channels summed) costs the result.
std::vector<double> importance(const Faces& faces, const Traced& pilot) {
  double light = 0.0;
  double area = 0.0;
  for (std::size_t f = 0; f < faces.targets.size(); ++f) {
    light += faces.targets[f].area() * channel_sum(pilot.mean[f]);
    area += faces.targets[f].area();
  }
  std::vector<double> weights;
  for (std::size_t f = 0; f < faces.targets.size(); ++f) {
    const double in_mean = faces.targets[f].area() / std::max(light, 1e-300);
    const double brightness = std::max({channel_sum(pilot.mean[f]), kDarkest * light / area, 1e-300});
    weights.push_back(in_mean + kDarkFaces / (brightness * static_cast<double>(faces.targets.size())));
  }
  return weights;
}

/// Paths a batch for each face. Minimising sum w_f s_f / sqrt(n_f) for a given sum n_f makes n_f grow as
/// (w_f s_f)^(2/3).
std::vector<std::uint32_t> share_paths(const Faces& faces, const Traced& pilot,
                                       const FaceTracingOptions& options) {
  const std::vector<double> weights = importance(faces, pilot);
  std::vector<double> wanted;
  double total = 0.0;
  for (std::size_t f = 0; f < weights.size(); ++f) {
    wanted.push_back(std::pow(weights[f] * channel_sum(pilot.standard_error[f]), 2.0 / 3.0));
    total += wanted.back();
  }
  const double a_batch = static_cast<double>(options.paths) / options.batches;
  std::vector<std::uint32_t> paths;
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    const double share = total > 0.0 ? a_batch * wanted[f] / total : 0.0;
    // Rounded to the nearest power, so that the sum stays about what was asked for.
    paths.push_back(faces.targets[f].area() > 0.0 ? std::max(kPilotPaths, power_of_two(share / 1.42)) : 0);
  }
  return paths;
}

}  // namespace

Traced path_traced_faces(const std::vector<MeshElement>& polygons, const FaceTracingOptions& options) {
  const PathEstimator estimator(polygons);
  const Faces faces(polygons);
  std::vector<std::uint32_t> paths;
  for (const Target& target : faces.targets) {
    paths.push_back(target.area() > 0.0 ? kPilotPaths : 0);
  }
  const Traced pilot = faces.radiosity(trace(estimator, faces.targets, paths, options.batches, options.seed));
  // Another seed: shares that follow the noise of the very samples that are kept would bias the result.
  return faces.radiosity(
      trace(estimator, faces.targets, share_paths(faces, pilot, options), options.batches, ~options.seed));
}

Traced path_traced_irradiance(const std::vector<MeshElement>& polygons,
                              const std::vector<SurfacePoint>& points, const PointTracingOptions& options) {
  const PathEstimator estimator(polygons);
  const EdgeClearance clearance(polygons);
  std::vector<Target> targets;
  targets.reserve(points.size());
  for (const SurfacePoint& point : points) {
    targets.emplace_back(clearance.clear(point));
  }
  const std::vector<std::uint32_t> paths(
      points.size(), power_of_two(static_cast<double>(options.paths_per_point) / options.batches));
  return trace(estimator, targets, paths, options.batches, options.seed);
}

PathTracedRadiosity path_traced_radiosity(const ElementMesh& mesh, const PathTracingOptions& options) {
  if (options.paths_per_element == 0) {
    throw std::invalid_argument("path tracing needs at least one path an element");
  }
  const PathEstimator estimator(mesh.elements);
  std::vector<Target> targets(mesh.elements.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i].add(mesh.elements[i]);
  }
  const std::vector<std::uint32_t> paths(
      targets.size(), power_of_two(static_cast<double>(options.paths_per_element) / options.batches));
  Traced traced = trace(estimator, targets, paths, options.batches, options.seed);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const MeshElement& element = mesh.elements[i];
    traced.mean[i] = element.emission + element.reflectance * traced.mean[i];
    traced.standard_error[i] *= element.reflectance;
  }
  return traced;
}

}  // namespace fixrad::host
