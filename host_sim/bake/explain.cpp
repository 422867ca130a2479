// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "host_sim/bake/bake.h"

namespace fixrad::host {
namespace {

constexpr double kBlack = 0.02;     // of the emitted flux absorbed: nothing to see
constexpr double kMuchBack = 0.15;  // of the emitted flux on back faces
constexpr double kMuchEscaped = 0.02;

struct Shares {
  double absorbed = 0, escaped = 0, back = 0;
};

Shares shares(const BakeResult& result) {
  Shares s;
  double emitted = 0;
  for (const Ledger& l : result.ledger) {
    emitted += static_cast<double>(l.emitted);
    s.absorbed += static_cast<double>(l.absorbed);
    s.escaped += static_cast<double>(l.escaped);
    s.back += static_cast<double>(l.back);
  }
  return {s.absorbed / emitted, s.escaped / emitted, s.back / emitted};
}

std::string percent(double a) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * a);
  return text;
}

// Edges that belong to one face only, and how many edges there are in all.
std::pair<std::size_t, std::size_t> open_edges(const PreparedScene& scene, std::uint32_t& example_face) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, std::uint32_t>> balance;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const std::vector<std::uint32_t>& c = scene.faces[f].corners;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const std::uint32_t a = c[i], b = c[(i + 1) % c.size()];
      auto& entry = balance[{std::min(a, b), std::max(a, b)}];
      entry.first += a < b ? 1 : -1;
      entry.second = f;
    }
  }
  std::size_t open = 0;
  for (const auto& [edge, entry] : balance) {
    if (entry.first != 0 && open++ == 0) {
      example_face = entry.second;
    }
  }
  return {open, balance.size()};
}

int line_of(const PreparedScene& scene, std::uint32_t convex_face) {
  return scene.model->faces[scene.faces[convex_face].parts.front().input_face].line;
}

struct LampArea {
  double buried = 0, all = 0;
  int line = 0;
};

// Looks out of every lamp element: a lamp material most of whose area sees backs is inside a body or behind a
// wall.
std::vector<std::string> buried_lamps(const PreparedScene& scene, const BakeResult& result) {
  SimulatedDevice probe(result.plan.sizes);
  const Scene view = result.device.view();
  std::vector<std::string> lines;
  if (probe.load(view, Settings{}) != Status::ok) {
    return lines;
  }
  std::map<std::uint16_t, LampArea> lamps;  // by material
  for (std::uint16_t e = 0; e < view.element_count; ++e) {
    const Element& element = result.device.elements[e];
    const MeshElement& mesh = result.device.mesh.elements[e];
    if (mesh.emission == glm::dvec3(0.0)) {
      continue;
    }
    std::uint32_t share = 0;
    const Status status = hidden_share(view, kDelta8, {vec(element.eye), element.face, 0}, result.is_closed,
                                       probe.state().work, share);
    LampArea& lamp = lamps[element.material];
    if (status == Status::ok && share > kRowOne / 2) {
      lamp.buried += mesh.area;
      lamp.line = lamp.line == 0 ? line_of(scene, element.face) : lamp.line;
    }
    lamp.all += mesh.area;
  }
  for (const auto& [material, lamp] : lamps) {
    if (2 * lamp.buried > lamp.all) {
      lines.push_back(scene.model->path + ":" + std::to_string(lamp.line) +
                      ": warning: the light of material '" + scene.model->materials[material].name +
                      "' cannot get out, this face of it looks into a body or the back of a wall; move it "
                      "out or turn its "
                      "normal");
    }
  }
  return lines;
}

}  // namespace

std::vector<std::string> explain(const PreparedScene& scene, const BakeResult& result) {
  std::vector<std::string> lines = buried_lamps(scene, result);
  const Shares s = shares(result);
  const std::string start = scene.model->path + ": warning: ";
  std::uint32_t example = 0;
  const auto [open, edges] = open_edges(scene, example);
  if (s.absorbed < kBlack) {
    lines.push_back(start + "almost everything is black: " + percent(s.escaped) +
                    " of the light escapes and " + percent(s.back) +
                    " meets back faces; normals probably point outward, try --flip or --two-sided");
  } else if (s.back > kMuchBack) {
    lines.push_back(
        start + percent(s.back) +
        " of the light meets back faces, which are black; turn those faces round, or try --two-sided");
  }
  if (s.absorbed >= kBlack && s.escaped > kMuchEscaped && open > 0 && open * 10 < edges) {
    lines.push_back(scene.model->path + ":" + std::to_string(line_of(scene, example)) + ": warning: " +
                    percent(s.escaped) + " of the light escapes through holes; " + std::to_string(open) +
                    " edges belong to one face only, one of this face among them; close them if the room "
                    "should be closed");
  }
  return lines;
}

}  // namespace fixrad::host
