// SPDX-License-Identifier: MIT
#include "host_sim/meshing/critical_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host_sim/meshing/contact_lines.h"
#include "host_sim/meshing/critical_edges.h"
#include "host_sim/meshing/critical_merge.h"
#include "host_sim/meshing/critical_wedge.h"
#include "host_sim/meshing/segment_part.h"

namespace fixrad::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSamePlane = 0.999;  // cosine

struct Lamp {
  std::uint32_t face;
  double exitance;  // W/m^2, mean of the channels
  double area;      // square grid units
};

/// What is said of all lines of one wedge.
struct Event {
  const Lamp* lamp;
  CriticalKind kind;
  int order;
  bool is_beyond_edge;
  glm::dvec3 normal;  // of the wedge
  double extent;      // of the lamp, across the wedge's plane, grid units
};

std::vector<Lamp> brightest_lamps(const PreparedScene& scene, std::size_t most) {
  std::vector<Lamp> lamps;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    const glm::dvec3 emission = scene.model->materials[scene.faces[f].material].emission;
    const double exitance = channel_sum(emission) / 3;
    if (exitance > 0) {
      lamps.push_back({f, exitance, area(scene.frames[f].outline) * scene.frames[f].unit_area()});
    }
  }
  std::stable_sort(lamps.begin(), lamps.end(),
                   [](const Lamp& a, const Lamp& b) { return a.exitance * a.area > b.exitance * b.area; });
  lamps.resize(std::min(lamps.size(), most));
  return lamps;
}

class LineFinder {
 public:
  explicit LineFinder(const PreparedScene& scene)
      : scene_(scene), edges_(find_edges(scene)), plane_(scene, edges_) {}

  void find_lines_of(const Lamp& lamp) {
    for (const SceneEdge& edge : edges_.edges) {
      if (!belongs_to(edge, lamp.face)) {
        for (const std::uint32_t v : scene_.faces[lamp.face].corners) {
          pass_edge(lamp, v, edge);
        }
      } else if (!is_joint(edge, lamp.face)) {
        for (std::uint32_t v = 0; v < edges_.sectors.size(); ++v) {
          pass_vertex(lamp, v, edge);
        }
      }
    }
  }

  void add_contacts(const std::vector<Lamp>& lamps) {
    for (const ContactLine& contact : contact_lines(scene_)) {
      CriticalLine line;
      line.face = static_cast<std::uint32_t>(contact.face);
      line.a = contact.a;
      line.b = contact.b;
      line.kind = CriticalKind::contact;
      line.order = 0;
      const glm::dvec3 middle = scene_.frames[contact.face].to_grid((line.a + line.b) / 2.0);
      for (const Lamp& lamp : lamps) {
        line.irradiance += irradiance(lamp, line.face, middle);
      }
      lines_.push_back(line);
    }
  }

  std::vector<CriticalLine> take() { return std::move(lines_); }

 private:
  glm::dvec3 at(std::uint32_t v) const { return glm::dvec3(scene_.vertices.positions[v]); }
  double height(std::uint32_t face, const glm::dvec3& point) const {
    return glm::dot(scene_.frames[face].normal, point - scene_.frames[face].height);
  }
  static bool belongs_to(const SceneEdge& edge, std::uint32_t face) {
    return std::find(edge.faces.begin(), edge.faces.end(), face) != edge.faces.end();
  }
  /// Whether the lamp goes on beyond its edge.
  bool is_joint(const SceneEdge& edge, std::uint32_t lamp) const {
    return std::any_of(edge.faces.begin(), edge.faces.end(), [&](std::uint32_t f) {
      return f != lamp && scene_.faces[f].material == scene_.faces[lamp].material &&
             glm::dot(scene_.frames[f].normal, scene_.frames[lamp].normal) >= kSamePlane;
    });
  }

  double irradiance(const Lamp& lamp, std::uint32_t face, const glm::dvec3& point) const;
  void set_lamp_side(const Lamp& lamp, int side, Event& event) const;
  void pass_edge(const Lamp& lamp, std::uint32_t vertex, const SceneEdge& edge);
  void pass_vertex(const Lamp& lamp, std::uint32_t vertex, const SceneEdge& edge);
  void pass_part(const Lamp& lamp, const Wedge& wedge);
  void add_lines(const Event& event);

  const PreparedScene& scene_;
  SceneEdges edges_;
  WedgePlane plane_;
  std::vector<CriticalLine> lines_;
};

/// As of a point at the lamp's middle.
double LineFinder::irradiance(const Lamp& lamp, std::uint32_t face, const glm::dvec3& point) const {
  const FaceFrame& frame = scene_.frames[lamp.face];
  const glm::dvec3 way = point - frame.height;
  const double squared = std::max(1.0, glm::dot(way, way));
  const double cosines = std::max(0.0, glm::dot(way, frame.normal)) *
                         std::max(0.0, -glm::dot(way, scene_.frames[face].normal)) / squared;
  return lamp.exitance * std::min(1.0, lamp.area * cosines / (kPi * squared));
}

/// The wedge parts full light from full shadow where the lamp lies on one side of its plane: the umbra's
/// border if what casts the shadow lies on the same side (`side`, 0: on both), the penumbra's if on the
/// other.
void LineFinder::set_lamp_side(const Lamp& lamp, int side, Event& event) const {
  for (const std::uint32_t v : scene_.faces[lamp.face].corners) {
    event.extent = std::max(event.extent, std::abs(plane_.distance(v)));
  }
  const int lamp_side = plane_.side_of(lamp.face);
  if (side != 0 && std::abs(lamp_side) == 1) {
    event.kind = side == lamp_side ? CriticalKind::umbra : CriticalKind::penumbra;
  }
}

void LineFinder::pass_edge(const Lamp& lamp, std::uint32_t vertex, const SceneEdge& edge) {
  SegmentPart before_lamp;
  before_lamp.keep_where(height(lamp.face, at(edge.p)) - kTouchingPlane,
                         height(lamp.face, at(edge.q)) - kTouchingPlane);
  const Wedge wedge = {vertex, &edge, true, before_lamp.begin, before_lamp.end};
  if (before_lamp.length() <= 0 || vertex == edge.p || vertex == edge.q || !plane_.enter(wedge)) {
    return;
  }
  int side = 0;
  for (const std::uint32_t f : edge.faces) {
    const int face_side = plane_.side_of(f);
    if (face_side == 2 || face_side * side < 0) {
      return;  // the surface goes on across the plane: no silhouette
    }
    side = face_side != 0 ? face_side : side;
  }
  if (side == 0) {
    return;
  }
  Event event = {&lamp, CriticalKind::inner, 2, true, plane_.normal(), 0.0};
  set_lamp_side(lamp, side, event);
  for (const CornerSector& sector : edges_.sectors[vertex]) {
    if (sector.face == lamp.face &&
        (plane_.distance(sector.before) == 0 || plane_.distance(sector.after) == 0)) {
      event.order = 1;
    }
  }
  add_lines(event);
}

void LineFinder::pass_vertex(const Lamp& lamp, std::uint32_t vertex, const SceneEdge& edge) {
  const std::vector<CornerSector>& sectors = edges_.sectors[vertex];
  if (sectors.empty() || edges_.is_on_a_face[vertex] || height(lamp.face, at(vertex)) <= kTouchingPlane) {
    return;
  }
  // Whether the vertex is on the silhouette changes only where the lamp's edge crosses the plane of one of
  // its faces.
  std::vector<double> borders{0.0, 1.0};
  for (const CornerSector& sector : sectors) {
    const double at_p = height(sector.face, at(edge.p)), at_q = height(sector.face, at(edge.q));
    if (at_p * at_q < 0) {
      borders.push_back(at_p / (at_p - at_q));
    }
  }
  std::sort(borders.begin(), borders.end());
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double middle = (borders[i] + borders[i + 1]) / 2;
    if (borders[i] < borders[i + 1] &&
        is_on_silhouette(scene_, edges_, vertex, at(edge.p) + middle * (at(edge.q) - at(edge.p)))) {
      pass_part(lamp, {vertex, &edge, false, borders[i], borders[i + 1]});
    }
  }
}

void LineFinder::pass_part(const Lamp& lamp, const Wedge& wedge) {
  if (!plane_.enter(wedge)) {
    return;
  }
  bool is_above = false, is_below = false, has_edge_in_plane = false;
  for (const CornerSector& sector : edges_.sectors[wedge.apex]) {
    for (const std::uint32_t v : {sector.before, sector.after}) {
      const double d = plane_.distance(v);
      is_above = is_above || d > 0;
      is_below = is_below || d < 0;
      has_edge_in_plane = has_edge_in_plane || d == 0;
    }
  }
  const int side = is_above == is_below ? 0 : is_above ? 1 : -1;
  Event event = {&lamp, CriticalKind::inner, side != 0 && has_edge_in_plane ? 1 : 2,
                 false, plane_.normal(),     0.0};
  set_lamp_side(lamp, side, event);
  add_lines(event);
}

void LineFinder::add_lines(const Event& event) {
  std::vector<WedgeTrace> traces;
  plane_.trace(traces);
  for (const WedgeTrace& trace : traces) {
    const FaceFrame& frame = scene_.frames[trace.face];
    CriticalLine line;
    line.face = trace.face;
    line.a = frame.to_frame(trace.a);
    line.b = frame.to_frame(trace.b);
    line.kind = event.kind;
    line.order = event.order;
    line.irradiance = irradiance(*event.lamp, trace.face, (trace.a + trace.b) / 2.0);
    // From the apex, the shadow's blur grows with the distance behind what casts it.
    const double depth = 2 / (trace.nearness_a + trace.nearness_b) - (event.is_beyond_edge ? 1.0 : 0.0);
    const double slant = glm::length(glm::cross(event.normal, frame.normal));
    line.width = std::max(1.0, event.extent * depth / std::max(slant, 1e-3));
    lines_.push_back(line);
  }
}

}  // namespace

double misplaced_light(const CriticalLine& line, double h) {
  const double blur = std::min(1.0, h / line.width);
  const double share = line.order == 0 ? 1.0 : line.order == 1 ? blur : blur * blur;
  return line.irradiance * share * h * line.length;
}

std::vector<CriticalLine> find_critical_lines(const PreparedScene& scene,
                                              const CriticalLineOptions& options) {
  LineFinder finder(scene);
  const std::vector<Lamp> lamps = brightest_lamps(scene, options.most_lamps);
  for (const Lamp& lamp : lamps) {
    finder.find_lines_of(lamp);
  }
  finder.add_contacts(lamps);
  return merge_lines(scene, finder.take(), options.separation);
}

}  // namespace fixrad::host
