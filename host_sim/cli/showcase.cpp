// SPDX-License-Identifier: MIT
#include "host_sim/cli/showcase.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "host_sim/cli/error_view.h"
#include "host_sim/report/automatic_camera.h"
#include "host_sim/report/data_page.h"
#include "host_sim/report/error_map.h"
#include "host_sim/report/tone.h"

namespace fixrad::host {
namespace {

constexpr int kWidth = 560, kHeight = 420;
constexpr std::size_t kFrontierPoints = 5;
constexpr double kScalePart = 0.85;  // of the samples lie within the scale of a map
constexpr std::uint32_t kReferenceElements = 4000;
constexpr int kReferenceResolution = 128;

std::vector<std::size_t> choose(const std::vector<SweepPoint>& points) {
  std::vector<double> seconds, errors;
  for (const SweepPoint& point : points) {
    seconds.push_back(point.host_seconds);
    errors.push_back(point.mean_error);
  }
  const std::vector<std::size_t> frontier = pareto_frontier(seconds, errors);
  std::set<std::size_t> chosen;
  const std::size_t count = std::min(kFrontierPoints, frontier.size());
  for (std::size_t k = 0; k < count; ++k) {
    chosen.insert(frontier[count == 1 ? 0 : k * (frontier.size() - 1) / (count - 1)]);
  }
  const auto add_missing = [&](std::string BakeOptions::*name) {
    std::set<std::string> seen;
    for (const std::size_t i : chosen) {
      seen.insert(points[i].options.*name);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (seen.insert(points[i].options.*name).second) {
        chosen.insert(i);
      }
    }
  };
  add_missing(&BakeOptions::profile);
  add_missing(&BakeOptions::engine);
  std::vector<std::size_t> order(chosen.begin(), chosen.end());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return errors[a] > errors[b]; });
  return order;
}

struct Maps {
  ErrorMap points, faces;
};

// Solves and draws solutions, all with the camera and the exposure of the first, which is the reference.
class Painter {
 public:
  Painter(const CommonOptions& options, const LoadedScene& scene, const Truth& truth)
      : options_(options), scene_(scene), truth_(truth) {}

  bool solve(const BakeOptions& bake_options, Views& views) {
    result_ =
        bake(scene_.prepared, bake_options, [](std::uint32_t, double, double) { return !is_interrupted(); });
    if (result_.interrupted) {
      return false;
    }
    const BakedMesh mesh = make_baked_mesh(scene_, result_);
    const bool z_up = options_.display.z_up;
    if (maps_.empty()) {
      reference_ = mesh;
      floor_ = dark_floor(mesh);
      exposure_ = exposure_scale(mesh, options_.display);
      picture_ = {kWidth, kHeight, automatic_camera(mesh, z_up, static_cast<double>(kWidth) / kHeight)};
    }
    Display display = options_.display;
    display.exposure_ev += std::log2(exposure_ / exposure_scale(mesh, display));
    views.picture = png_data_url(render_picture(mesh, display, picture_));
    views.model = glb_base64(mesh, display);
    maps_.push_back({point_errors(mesh, reference_, floor_, z_up, picture_),
                     polygon_errors(face_error_polygons(scene_, truth_, result_, floor_), z_up, picture_)});
    return true;
  }

  const BakeResult& result() const { return result_; }  // of the last solution
  const Camera& camera() const { return *picture_.camera; }

  // A round number that most of the samples do not exceed, in the median of all solutions but the reference.
  double limit(ErrorMap Maps::*kind) const {
    std::vector<double> magnitudes;
    for (std::size_t i = 1; i < maps_.size(); ++i) {
      magnitudes.push_back(error_quantile(maps_[i].*kind, kScalePart));
    }
    std::sort(magnitudes.begin(), magnitudes.end());
    return nice_limit(magnitudes[magnitudes.size() / 2]);
  }

  std::string map(std::size_t solution, ErrorMap Maps::*kind, double limit) const {
    return png_data_url(false_colours(maps_[solution].*kind, limit));
  }

 private:
  const CommonOptions& options_;
  const LoadedScene& scene_;
  const Truth& truth_;
  BakeResult result_;
  BakedMesh reference_;
  double floor_ = 1, exposure_ = 1;
  PictureOptions picture_;
  std::vector<Maps> maps_;
};

BakeOptions reference_options(const BakeOptions& base, const PreparedScene& scene) {
  BakeOptions options = base;
  options.profile = "host";
  options.engine = swept_engines().front();
  options.resolution = kReferenceResolution;
  options.elements = std::max(kReferenceElements, static_cast<std::uint32_t>(scene.faces.size()));
  return options;
}

}  // namespace

bool make_showcase(const CommonOptions& options, const LoadedScene& scene, const Truth& truth,
                   const std::vector<SweepPoint>& points, Showcase& showcase) {
  Painter painter(options, scene, truth);
  showcase.points = choose(points);
  showcase.width = kWidth;
  showcase.height = kHeight;
  const BakeOptions reference = reference_options(options.bake, scene.prepared);
  if (!painter.solve(reference, showcase.reference)) {
    return false;
  }
  const BakeResult& result = painter.result();
  showcase.camera = painter.camera();
  showcase.reference_elements = result.plan.sizes.elements;
  showcase.reference_error =
      error_against(truth, scene.prepared, result.device, result.element_radiosity).mean;
  for (const std::size_t i : showcase.points) {
    if (!painter.solve(points[i].options, showcase.views.emplace_back())) {
      return false;
    }
  }
  showcase.point_limit = painter.limit(&Maps::points);
  showcase.face_limit = painter.limit(&Maps::faces);
  showcase.reference.face_errors = painter.map(0, &Maps::faces, showcase.face_limit);
  for (std::size_t i = 0; i < showcase.views.size(); ++i) {
    showcase.views[i].point_errors = painter.map(i + 1, &Maps::points, showcase.point_limit);
    showcase.views[i].face_errors = painter.map(i + 1, &Maps::faces, showcase.face_limit);
  }
  return true;
}

}  // namespace fixrad::host
