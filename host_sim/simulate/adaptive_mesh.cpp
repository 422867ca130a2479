// SPDX-License-Identifier: MIT
#include "host_sim/simulate/adaptive_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <tuple>

#include "host_sim/meshing/cell_cuts.h"
#include "host_sim/meshing/contact_lines.h"
#include "host_sim/simulate/eye_sights.h"
#include "host_sim/simulate/simulated_device.h"

namespace fixrad::host {
namespace {

// Of all elements, those that the first mesh and the mesh of the second solution have. With fewer of the
// first, points are told no better, and large elements, which send all their light from a few points, spoil
// the means of faces.
constexpr double kFirst = 0.6, kSecond = 0.8;

// Samples of irradiance lie so far from the centroid on the way to a corner.
constexpr double kTowardsCorner = 0.6;

// From this ratio of its sides on an element is cut across the longer one, whatever the light does.
constexpr double kTooLong = 3.0;

// Of the smallest part that is cut off, in cells of the first mesh.
constexpr LeastPart kLeast = {1.0 / 80, 6.0};

// The foot of an object may be small in its cell.
constexpr LeastPart kFoot = {0.002, 4.0};

// Grid units: contacts shorter than this are none; irradiance is sampled so far from one.
constexpr double kReach = 4.0, kBeside = 6.0;

Sizes sizes_of(const DeviceScene& device) {
  const auto faces = static_cast<std::uint32_t>(device.faces.size());
  return {static_cast<std::uint32_t>(device.vertices.size()), faces,
          static_cast<std::uint32_t>(device.elements.size()), std::min(65535u, 8 * faces + 16),
          static_cast<std::uint32_t>(device.channels),        0};
}

// A rough solution of a mesh, to be asked for irradiance.
class RoughSolution {
 public:
  RoughSolution(const PreparedScene& scene, const Meshing& meshing)
      : scene_(scene), device_(make_device_scene(scene, meshing)), solver_(sizes_of(device_)) {
    find_sights(device_, sizes_of(device_));
    Settings settings;
    settings.stop = fraction(1, 50);
    settings.flux_per_row = Fraction::from_raw(
        static_cast<std::uint32_t>(std::ldexp(0.06 / static_cast<double>(device_.elements.size()), 32)));
    settings.flux_per_eye = fraction(1, 20);
    settings.overshoot = true;
    Status status = solver_.load(device_.view(), settings);
    while (status == Status::ok) {
      status = shoot(solver_.state());
    }
    is_usable_ = status == Status::converged;
    for (int c = 0; is_usable_ && c < device_.channels; ++c) {
      ambient_[static_cast<std::size_t>(c)] = ambient_radiosity(solver_.state(), c);
    }
  }

  bool is_usable() const { return is_usable_; }

  /// At a point of a face's frame, one a channel; the core's radiosity unit.
  glm::dvec3 irradiance(std::size_t face, glm::dvec2 st) {
    const EyePoint eye = {lifted_eye(scene_, face, scene_.frames[face].to_grid(st)),
                          static_cast<std::uint16_t>(face), 0};
    Irradiance found = {};
    if (gather_irradiance(solver_.state(), kLunes[3], correct_direct_light, eye, false, ambient_.data(),
                          found) != Status::ok) {
      return glm::dvec3(0.0);
    }
    return {found.of[0].raw, found.of[1].raw, found.of[2].raw};
  }

 private:
  const PreparedScene& scene_;
  DeviceScene device_;
  SimulatedDevice solver_;
  std::array<Radiosity, kMaxChannels> ambient_ = {};
  bool is_usable_ = false;
};

struct Candidate {
  double error;
  std::size_t face, element;
  Line2d cut;
  bool is_contact;  // `cut` is a contact line

  bool operator<(const Candidate& other) const {
    return std::tie(error, other.face, other.element) < std::tie(other.error, face, element);
  }
};

// Extents of an outline along the frame's axes, grid units.
glm::dvec2 extents(const FaceFrame& frame, const Polygon2d& outline) {
  glm::dvec2 low = outline[0], high = low;
  for (const glm::dvec2 p : outline) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return (high - low) *
         glm::dvec2(glm::length(glm::dvec3(frame.axis_u)), glm::length(glm::dvec3(frame.axis_v)));
}

class Refiner {
 public:
  Refiner(const PreparedScene& scene, Meshing& meshing)
      : scene_(scene), meshing_(meshing), light_(scene, meshing), contacts_(scene.faces.size()) {
    for (const ContactLine& line : contact_lines(scene)) {
      contacts_[line.face].push_back(line);
    }
  }

  void refine(std::uint32_t wanted) {
    if (!light_.is_usable()) {
      return;
    }
    for (std::size_t f = 0; f < meshing_.faces.size(); ++f) {
      for (std::size_t e = 0; e < meshing_.faces[f].elements.size(); ++e) {
        consider(f, e, true);
      }
    }
    while (meshing_.element_count < wanted && !queue_.empty()) {
      const Candidate worst = queue_.top();
      queue_.pop();
      if (cut(worst)) {
        ++meshing_.element_count;
        consider(worst.face, worst.element, true);
        consider(worst.face, meshing_.faces[worst.face].elements.size() - 1, true);
      } else if (worst.is_contact) {
        consider(worst.face, worst.element, false);
      }
    }
  }

 private:
  void consider(std::size_t f, std::size_t e, bool with_contacts) {
    const FaceFrame& frame = scene_.frames[f];
    const Polygon2d& outline = meshing_.faces[f].elements[e].outline;
    const glm::dvec2 middle = centroid(outline);
    Range range(scene_, light_, f, outline);
    const double at_middle = range.sample(middle);
    glm::dvec2 change(0.0);
    for (const glm::dvec2 corner : outline) {
      const double light = range.sample(glm::mix(middle, corner, kTowardsCorner));
      change += glm::sign(corner - middle) * (light - at_middle);
    }
    Candidate candidate = {0, f, e, axis_cut(frame, outline, glm::abs(change)), false};
    for (const ContactLine& line : contacts_[f]) {
      const SegmentPart part = part_within(outline, line.a, line.b);
      if (with_contacts &&
          part.length() * glm::distance(frame.to_grid(line.a), frame.to_grid(line.b)) > kReach) {
        const glm::dvec2 on_line = glm::mix(line.a, line.b, (part.begin + part.end) / 2);
        const glm::dvec2 across = line_through(line.a, line.b).normal;
        const double step = kBeside / glm::length(frame.to_grid(on_line + across) - frame.to_grid(on_line));
        range.sample(on_line + step * across);
        range.sample(on_line - step * across);
        candidate.cut = line_through(line.a, line.b);
        candidate.is_contact = true;
      }
    }
    candidate.error = range.width();
    queue_.push(candidate);
  }

  // Irradiance within an element, times reflectance and area, summed over the channels.
  class Range {
   public:
    Range(const PreparedScene& scene, RoughSolution& light, std::size_t face, const Polygon2d& outline)
        : light_(light),
          face_(face),
          material_(scene.model->materials[scene.faces[face].material]),
          area_(area(outline) * scene.frames[face].unit_area()) {}

    double sample(glm::dvec2 p) {
      const double reflected = area_ * glm::dot(material_.reflectance, light_.irradiance(face_, p));
      low_ = std::min(low_, reflected);
      high_ = std::max(high_, reflected);
      return reflected;
    }
    double width() const { return high_ - low_; }

   private:
    RoughSolution& light_;
    std::size_t face_;
    const Material& material_;
    double area_;
    double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  };

  static Line2d axis_cut(const FaceFrame& frame, const Polygon2d& outline, glm::dvec2 change) {
    const glm::dvec2 size = extents(frame, outline);
    const bool is_long = size.x > kTooLong * size.y || size.y > kTooLong * size.x;
    const bool across_u = is_long ? size.x > size.y : change.x * size.x >= change.y * size.y;
    const glm::dvec2 normal = across_u ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
    return {normal, glm::dot(normal, centroid(outline))};
  }

  bool cut(const Candidate& candidate) {
    FaceElements& face = meshing_.faces[candidate.face];
    const FaceFrame& frame = scene_.frames[candidate.face];
    if (cut_element(frame, face, candidate.element, candidate.cut, candidate.is_contact ? kFoot : kLeast)) {
      return true;
    }
    const glm::dvec2 other(candidate.cut.normal.y, candidate.cut.normal.x);
    const glm::dvec2 middle = centroid(face.elements[candidate.element].outline);
    return !candidate.is_contact &&
           cut_element(frame, face, candidate.element, {other, glm::dot(other, middle)}, kLeast);
  }

  const PreparedScene& scene_;
  Meshing& meshing_;
  RoughSolution light_;
  std::vector<std::vector<ContactLine>> contacts_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

Meshing make_contact_mesh(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches) {
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  for (std::uint32_t grid = elements;;) {
    Meshing meshing = make_uniform(scene, grid, patches);
    cut_at_contacts(scene, meshing);
    if (meshing.element_count <= std::max(elements, faces)) {
      return meshing;
    }
    if (grid <= faces) {
      return make_uniform(scene, elements, patches);
    }
    grid = std::max(faces, grid - std::min(grid, meshing.element_count - elements));
  }
}

Meshing make_adaptive(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches) {
  const auto part = [elements](double p) { return static_cast<std::uint32_t>(p * elements); };
  Meshing meshing = make_uniform(scene, part(kFirst), patches);
  for (const double p : {kSecond, 1.0}) {
    if (meshing.element_count < part(p)) {
      Refiner(scene, meshing).refine(part(p));
    }
  }
  return meshing;
}

}  // namespace fixrad::host
