// SPDX-License-Identifier: MIT
#include "host_sim/bake/display.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "host_sim/bake/clock.h"
#include "host_sim/bake/point_gatherer.h"
#include "host_sim/io/model.h"
#include "host_sim/meshing/gather_points.h"
#include "host_sim/meshing/surface_edges.h"

namespace fixrad::host {
namespace {

constexpr double kBend = 1.0 / 60;
constexpr std::size_t kBatch = 256;  // gathers between two questions whether to go on
constexpr int kBuriedCuts = 2;  // cuts of an edge of which both ends are buried: something may lie between

using Ends = std::pair<std::uint32_t, std::uint32_t>;

// Where light is to be gathered.
struct Place {
  glm::dvec3 position;
  std::vector<std::uint16_t> elements;
};

class DisplayBuilder {
 public:
  DisplayBuilder(const BakeResult& result, const DisplayOptions& options, const Progress& progress)
      : result_(result), progress_(progress), gatherer_(result), mesh_(result.surface) {
    const double side = kGridMax / result.device.grid.scale;
    shortest_cut_ = 2 * options.shortest_edge * side;
  }

  bool build() {
    std::vector<Place> corners;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const auto first = mesh_.elements.begin() + mesh_.vertices[v].first;
      corners.push_back({mesh_.positions[v], {first, first + mesh_.vertices[v].count}});
    }
    if (!gather(corners, lights_)) {
      return false;
    }
    mean_ = mean_irradiance();
    for (bool is_cut = true; is_cut;) {
      if (!refine(is_cut)) {
        return false;
      }
    }
    return true;
  }

  void store(BakeResult& result) {
    const std::vector<VertexLight> lights = with_neighbours();
    const int channels = result.device.channels;
    std::vector<Radiosity> displayed;
    result.vertex_radiosity.clear();
    for (const VertexLight& light : lights) {
      displayed.insert(displayed.end(), light.radiosity, light.radiosity + channels);
      result.vertex_radiosity.push_back(gatherer_.physical(light.radiosity));
    }
    result.display_digest = gatherer_.digest_with(displayed);
    result.display = "gather";
    result.surface = std::move(mesh_);
  }

 private:
  bool gather(const std::vector<Place>& places, std::vector<VertexLight>& lights) const {
    lights.resize(places.size());
    for (std::size_t begin = 0; begin < places.size(); begin += kBatch) {
      if (progress_ && !progress_(result_.shots, result_.unshot_fraction, result_.seconds)) {
        return false;
      }
      tbb::parallel_for(begin, std::min(places.size(), begin + kBatch), [&](std::size_t i) {
        lights[i] = gatherer_.gather(vertex_gather(result_.device, places[i].position, places[i].elements));
      });
    }
    return true;
  }

  glm::dvec3 irradiance(const VertexLight& light) const { return gatherer_.physical(light.irradiance); }
  bool is_clear(std::uint32_t v) const { return lights_[v].clear_points > 0; }

  double mean_irradiance() const {
    double light = 0, area = 0;
    for (const std::array<std::uint32_t, 3>& t : mesh_.triangles) {
      const double of_triangle = glm::length(glm::cross(mesh_.positions[t[1]] - mesh_.positions[t[0]],
                                                        mesh_.positions[t[2]] - mesh_.positions[t[0]]));
      for (const std::uint32_t v : t) {
        light += of_triangle * channel_sum(irradiance(lights_[v]));
        area += of_triangle;
      }
    }
    return area > 0 ? light / area : 0;
  }

  // Looks at new edges and cuts the bent ones; false if told to stop.
  bool refine(bool& is_cut) {
    const std::vector<SurfaceEdge> open = open_edges();
    if (!gather_middles(open)) {
      return false;
    }
    std::vector<SurfaceEdge> bent;
    for (const SurfaceEdge& edge : open) {
      if (is_bent(edge, middles_.at({edge.a, edge.b}))) {
        bent.push_back(edge);
      }
    }
    is_cut = !bent.empty();
    bent = with_longest(mesh_, bent);
    if (!gather_middles(bent)) {
      return false;
    }
    for (const SurfaceEdge& edge : bent) {
      lights_.push_back(middles_.at({edge.a, edge.b}));
    }
    cut_edges(mesh_, bent);
    return true;
  }

  // Edges that have not been looked at and are long enough to be cut.
  std::vector<SurfaceEdge> open_edges() const {
    std::vector<SurfaceEdge> open;
    for (SurfaceEdge& edge : surface_edges(mesh_)) {
      const double length = glm::distance(mesh_.positions[edge.a], mesh_.positions[edge.b]);
      const bool may_be_lit = is_clear(edge.a) || is_clear(edge.b) || length >= kBuriedCuts * shortest_cut_;
      if (length >= shortest_cut_ && may_be_lit && middles_.count({edge.a, edge.b}) == 0) {
        open.push_back(std::move(edge));
      }
    }
    return open;
  }

  bool gather_middles(const std::vector<SurfaceEdge>& edges) {
    std::vector<Place> places;
    std::vector<Ends> ends;
    for (const SurfaceEdge& edge : edges) {
      if (middles_.count({edge.a, edge.b}) == 0) {
        places.push_back({middle_of(mesh_, edge), edge.elements});
        ends.push_back({edge.a, edge.b});
      }
    }
    std::vector<VertexLight> found;
    if (!gather(places, found)) {
      return false;
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      middles_[ends[i]] = found[i];
    }
    return true;
  }

  bool is_bent(const SurfaceEdge& edge, const VertexLight& middle) const {
    const int clear =
        (is_clear(edge.a) ? 1 : 0) + (is_clear(edge.b) ? 1 : 0) + (middle.clear_points > 0 ? 1 : 0);
    if (clear < 3) {
      return clear > 0;
    }
    const glm::dvec3 here = irradiance(middle);
    const glm::dvec3 off = here - 0.5 * (irradiance(lights_[edge.a]) + irradiance(lights_[edge.b]));
    return std::abs(off.x) + std::abs(off.y) + std::abs(off.z) > 0.5 * kBend * (channel_sum(here) + mean_);
  }

  std::vector<VertexLight> with_neighbours() const {
    std::vector<VertexLight> lights = lights_;
    std::vector<std::array<std::uint64_t, kMaxChannels>> sums(lights.size());
    std::vector<std::uint32_t> counts(lights.size());
    for (const SurfaceEdge& edge : surface_edges(mesh_)) {
      if (is_clear(edge.a) == is_clear(edge.b)) {
        continue;
      }
      const std::uint32_t from = is_clear(edge.a) ? edge.a : edge.b, to = edge.a + edge.b - from;
      for (std::size_t c = 0; c < kMaxChannels; ++c) {
        sums[to][c] += lights[from].radiosity[c].raw;
      }
      ++counts[to];
    }
    for (std::size_t v = 0; v < lights.size(); ++v) {
      for (std::size_t c = 0; counts[v] > 0 && c < kMaxChannels; ++c) {
        lights[v].radiosity[c] = Radiosity::from_raw(static_cast<std::uint32_t>(sums[v][c] / counts[v]));
      }
    }
    return lights;
  }

  const BakeResult& result_;
  const Progress& progress_;
  PointGatherer gatherer_;
  SurfaceMesh mesh_;
  std::vector<VertexLight> lights_;      // [mesh_.positions]
  std::map<Ends, VertexLight> middles_;  // of the edges that were looked at
  double shortest_cut_ = 0;
  double mean_ = 0;
};

}  // namespace

bool gather_display(BakeResult& result, const DisplayOptions& options, const Progress& progress) {
  const Clock clock;
  DisplayBuilder builder(result, options, progress);
  if (!builder.build()) {
    return false;
  }
  builder.store(result);
  result.display_seconds = clock.seconds();
  return true;
}

}  // namespace fixrad::host
