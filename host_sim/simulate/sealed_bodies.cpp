// SPDX-License-Identifier: MIT
#include "host_sim/simulate/sealed_bodies.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "host_sim/meshing/segment_part.h"
#include "host_sim/simulate/simulated_device.h"
#include "lib/form_factor/row_sampling.h"

namespace fixrad::host {
namespace {

// Grid units: corners are off their plane by kPlaneTolerance, those of two faces by twice as much.
constexpr double kContact = 2 * kPlaneTolerance;

// Rounding lets a back show where a body's outline is seen; what is wider is real.
constexpr std::int32_t kSliver = kRowEnd / 256;

using Edge = std::pair<std::uint16_t, std::uint16_t>;

glm::dvec3 position(const DeviceScene& device, std::uint16_t vertex) {
  const Vertex v = device.vertices[vertex];
  return {v.x, v.y, v.z};
}

std::uint16_t corner(const DeviceScene& device, const fixrad::Face& face, std::size_t k) {
  return device.corners[face.first_corner + k % face.corner_count];
}

// Bodies as sets of faces: the root of each face.
class Bodies {
 public:
  explicit Bodies(const DeviceScene& device) : root_(device.faces.size()) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
    for (std::size_t f = 0; f < device.faces.size(); ++f) {
      for (std::size_t k = 0; k < device.faces[f].corner_count; ++k) {
        owner_.emplace(Edge{corner(device, device.faces[f], k), corner(device, device.faces[f], k + 1)}, f);
      }
    }
    for (const auto& [edge, face] : owner_) {
      const auto partner = owner_.find({edge.second, edge.first});
      if (partner != owner_.end()) {
        const std::size_t root = of(partner->second);
        root_[of(face)] = root;
        root_[face] = root_[partner->second] = root;  // so that long chains stay short ways
      }
    }
  }

  std::size_t of(std::size_t face) const {
    while (root_[face] != face) {
      face = root_[face];
    }
    return face;
  }

  /// Edges of one face only, with that face.
  std::vector<std::pair<Edge, std::size_t>> open_edges() const {
    std::vector<std::pair<Edge, std::size_t>> open;
    for (const auto& [edge, face] : owner_) {
      if (owner_.count({edge.second, edge.first}) == 0) {
        open.push_back({edge, face});
      }
    }
    return open;
  }

 private:
  std::vector<std::size_t> root_;
  std::map<Edge, std::size_t> owner_;
};

// The part of a segment that lies on a face, with kContact to spare.
SegmentPart part_on(const DeviceScene& device, const fixrad::Face& face, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(face.normal[0], face.normal[1], face.normal[2]));
  SegmentPart part;
  const glm::dvec3 origin = position(device, corner(device, face, 0));
  const double height_a = glm::dot(a - origin, normal), height_b = glm::dot(b - origin, normal);
  part.keep_where(kContact - height_a, kContact - height_b);
  part.keep_where(kContact + height_a, kContact + height_b);
  for (std::size_t k = 0; k < face.corner_count; ++k) {
    const glm::dvec3 p = position(device, corner(device, face, k));
    const glm::dvec3 along = glm::normalize(position(device, corner(device, face, k + 1)) - p);
    const glm::dvec3 inwards = glm::cross(normal, along);
    part.keep_where(glm::dot(a - p, inwards) + kContact, glm::dot(b - p, inwards) + kContact);
  }
  return part;
}

bool is_covered(const DeviceScene& device, const Bodies& bodies, const Edge& edge, std::size_t own) {
  const glm::dvec3 a = position(device, edge.first), b = position(device, edge.second);
  std::vector<SegmentPart> parts;
  for (std::size_t f = 0; f < device.faces.size(); ++f) {
    if (bodies.of(f) != own) {
      parts.push_back(part_on(device, device.faces[f], a, b));
    }
  }
  std::sort(parts.begin(), parts.end(),
            [](const SegmentPart& p, const SegmentPart& q) { return p.begin < q.begin; });
  const double slack = kContact / std::max(kContact, glm::length(b - a));
  double covered = 0;
  for (const SegmentPart& part : parts) {
    covered = part.begin <= covered + slack ? std::max(covered, part.end) : covered;
  }
  return covered >= 1 - slack;
}

// Calls `report` with every face whose back is the nearest on some row of lunes seen from an element's eye.
template <class Report>
void for_backs_in_view(State& state, std::uint16_t e, Report report) {
  const Element element = state.scene.elements[e];
  const DeltaTable& table = kLunes[2];
  Workspace& work = state.work;
  const EyePoint eye = {vec(element.eye), element.face, 0};
  make_view(state.scene, eye, Backs::all, work);
  enter_band(state.scene, table, 0, kBandRows, work);
  VisibleSpans visible(state.scene, eye, work);
  for (int r = 0; r < kBandRows; ++r) {
    const BandRow row = band_row(table, 0, r);
    if (!find_visible(state.scene, row, work, visible)) {
      return;  // the solver will say why
    }
    for (std::uint16_t i = 0; i < visible.count(); ++i) {
      const bool is_wide = visible.part(i).end - visible.part(i).begin > kSliver;
      if (is_wide && visible.view(i) != kNothing && work.views[visible.view(i)].is_back) {
        report(work.views[visible.view(i)].face);
      }
    }
  }
}

}  // namespace

void seal_bodies(DeviceScene& device, const Sizes& sizes) {
  SimulatedDevice probe(sizes);
  if (device.sights.empty() || probe.load(device.view(), Settings{}) != Status::ok) {
    return;
  }
  const Bodies bodies(device);
  std::vector<bool> is_open(device.faces.size(), false);
  for (const auto& [edge, face] : bodies.open_edges()) {
    const std::size_t body = bodies.of(face);
    is_open[body] = is_open[body] || !is_covered(device, bodies, edge, body);
  }
  for (std::size_t i = 0; i < device.elements.size(); ++i) {
    const auto e = static_cast<std::uint16_t>(i);
    if (device.sights[e] == Sight::centroid_clear || device.sights[e] == Sight::all_clear) {
      for_backs_in_view(probe.state(), e, [&](std::uint16_t f) { is_open[bodies.of(f)] = true; });
    }
  }
  for (std::size_t f = 0; f < device.faces.size(); ++f) {
    device.faces[f].is_sealed = is_open[bodies.of(f)] ? 0 : 1;
  }
}

}  // namespace fixrad::host
