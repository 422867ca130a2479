// SPDX-License-Identifier: MIT
#include "host_sim/cli/compare_points.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host_sim/bake/clock.h"
#include "host_sim/bake/point_gatherer.h"
#include "host_sim/meshing/gather_points.h"
#include "host_sim/reference/input_polygons.h"
#include "host_sim/reference/path_tracer.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

nlohmann::json as_json(glm::dvec3 a) {
  return {a.x, a.y, a.z};
}

glm::dvec3 as_vector(const nlohmann::json& a) {
  return {a.at(0).get<double>(), a.at(1).get<double>(), a.at(2).get<double>()};
}

void write_truth(const std::string& file, const std::vector<SamplePoint>& points, const Traced& truth) {
  nlohmann::json json = nlohmann::json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    json.push_back({{"position", as_json(points[i].surface.position)},
                    {"irradiance", as_json(truth.mean[i])},
                    {"standard_error", as_json(truth.standard_error[i])}});
  }
  write_text(file, json.dump() + "\n");
}

// Throws InputError unless the file holds these very points.
Traced read_truth(const std::string& file, const std::vector<SamplePoint>& points) {
  Traced truth;
  try {
    const nlohmann::json json = nlohmann::json::parse(std::ifstream(file));
    bool is_ours = json.size() == points.size();
    for (std::size_t i = 0; is_ours && i < points.size(); ++i) {
      is_ours = as_vector(json.at(i).at("position")) == points[i].surface.position;
      truth.mean.push_back(as_vector(json.at(i).at("irradiance")));
      truth.standard_error.push_back(as_vector(json.at(i).at("standard_error")));
    }
    if (!is_ours) {
      throw InputError(file + ": error: the points are of another scene or number; delete the file");
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": error: this is no truth at points: " + error.what() + "; delete the file");
  }
  return truth;
}

Traced trace(const LoadedScene& scene, const std::vector<MeshElement>& polygons,
             const std::vector<SamplePoint>& points, const CommonOptions& options) {
  const std::string& file = options.points_truth;
  if (!file.empty() && std::filesystem::exists(file)) {
    return read_truth(file, points);
  }
  if (points.empty()) {
    throw InputError(scene.model.path + ": error: no surface that reflects can be seen; leave out --points");
  }
  std::vector<SurfacePoint> places;
  places.reserve(points.size());
  for (const SamplePoint& point : points) {
    places.push_back(point.surface);
  }
  Traced truth = path_traced_irradiance(polygons, places, {options.points_paths});
  if (!file.empty()) {
    write_truth(file, points, truth);
  }
  return truth;
}

using Values = std::vector<glm::dvec3>;

Values to_irradiance(const std::vector<SamplePoint>& points, Values radiosity) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    radiosity[i] = irradiance_of(points[i], radiosity[i]);
  }
  return radiosity;
}

Values vertex_colours(const std::vector<SamplePoint>& points, const BakeResult& result) {
  return to_irradiance(points, interpolate(result.surface.positions, result.surface.triangles,
                                           result.vertex_radiosity, points));
}

Values flat_elements(const std::vector<SamplePoint>& points, const std::vector<std::uint32_t>& elements,
                     const BakeResult& result) {
  Values radiosity;
  for (const std::uint32_t e : elements) {
    radiosity.push_back(result.element_radiosity[e]);
  }
  return to_irradiance(points, radiosity);
}

Values gathered(const std::vector<SamplePoint>& points, const std::vector<std::uint32_t>& elements,
                const BakeResult& result) {
  const PointGatherer gatherer(result);
  Values irradiance;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const VertexGather here =
        vertex_gather(result.device, points[i].surface.position, {static_cast<std::uint16_t>(elements[i])});
    irradiance.push_back(gatherer.physical(gatherer.gather(here).irradiance));
  }
  return irradiance;
}

}  // namespace

PointBudget measure_points(const LoadedScene& scene, const CommonOptions& options, const BakeResult& result) {
  const std::vector<MeshElement> polygons = input_polygons(scene.prepared);
  const std::vector<SamplePoint> points = surface_points(polygons, options.points);
  PointBudget budget;
  const Clock tracing;
  const Traced truth = trace(scene, polygons, points, options);
  budget.points = points.size();
  budget.truth_standard_error = truth_error(points, truth);
  budget.truth_seconds = tracing.seconds();
  const std::vector<std::uint32_t> elements = elements_at(result.device.mesh.elements, points);
  const auto add = [&](const char* name, const char* what, const Values& irradiance, double seconds) {
    budget.lines.push_back({name, what, compare_points(points, irradiance, truth), seconds});
  };
  add("flat", "each element in one colour", flat_elements(points, elements, result), 0);
  add("mean", "vertex colours: the mean round each vertex", vertex_colours(points, result), 0);
  const auto add_display = [&](const char* name, const char* what, const DisplayOptions& mesh) {
    BakeResult displayed = result;
    gather_display(displayed, mesh);
    add(name, what, vertex_colours(points, displayed), displayed.display_seconds);
    return displayed.surface.positions.size();
  };
  add_display("corners", "vertex colours: a gather at each corner of an element", {kCornersOnly});
  budget.vertices = add_display("gather", "vertex colours: a gather at each vertex", options.display_mesh);
  const Clock gathering;
  const Values at_points = gathered(points, elements, result);
  add("at the point", "a gather at each of the points themselves", at_points, gathering.seconds());
  return budget;
}

void print(const PointBudget& budget) {
  std::printf("irradiance at %zu points of surfaces that can be seen, %zu vertices gathered\n", budget.points,
              budget.vertices);
  std::printf("  %-13s %-56s %8s %8s %9s %9s\n", "display", "irradiance from", "mean %", "median %",
              "95th pc %", "seconds");
  for (const PointLine& line : budget.lines) {
    std::printf("  %-13s %-56s %8.3f %8.2f %9.2f %9.3f\n", line.name, line.what, 100 * line.error.mean,
                100 * line.error.median, 100 * line.error.percentile95, line.seconds);
  }
  std::printf(
      "  Mean: sum of |difference| over sum of irradiance. Median, 95th percentile: of single points with at "
      "least a\n  tenth of the mean. Truth: path traced in %.3f s, standard error %.3f %%. Seconds: the "
      "display "
      "step.\n",
      budget.truth_seconds, 100 * budget.truth_standard_error);
}

nlohmann::ordered_json to_json(const PointBudget& budget) {
  nlohmann::ordered_json json = {{"count", budget.points},
                                 {"vertices", budget.vertices},
                                 {"truth_standard_error", budget.truth_standard_error},
                                 {"truth_seconds", budget.truth_seconds}};
  for (const PointLine& line : budget.lines) {
    json["errors"].push_back({{"name", line.name},
                              {"what", line.what},
                              {"mean", line.error.mean},
                              {"median", line.error.median},
                              {"percentile95", line.error.percentile95},
                              {"seconds", line.seconds}});
  }
  return json;
}

}  // namespace fixrad::host
