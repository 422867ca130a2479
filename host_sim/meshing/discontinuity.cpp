// SPDX-License-Identifier: MIT
#include "host_sim/meshing/discontinuity.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "host_sim/meshing/cell_cuts.h"
#include "host_sim/meshing/critical_lines.h"
#include "host_sim/meshing/element_light.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kSamples = 32;       // of an element, at least
constexpr std::size_t kSamplesOfCut = 64;  // of one that critical lines cross
constexpr double kLeastCrossing = 8.0;     // grid units of a line in an element
constexpr std::size_t kMostLines = 12;     // of an element that are tried
constexpr std::size_t kMostOfPairs = 6;    // of these, in pairs
constexpr double kSlanted = 0.5;           // sine of the angle from which two lines are no strip
constexpr double kPatience = 0.1;  // part of an element's error that counts although no cut lessens it

/// One line or two to cut an element by, and how much light they put right, a new element.
struct Proposal {
  std::vector<Line2d> lines;
  double gain = 0;
};

/// What is known of an element.
struct Lit {
  Polygon2d border;  ///< its outline and the corners of neighbours on it
  std::vector<LightSample> samples;
  std::vector<std::uint32_t> lines;  ///< those that cross it
  std::vector<Proposal> proposals;   ///< best first
  std::uint32_t drawn = 0;           ///< points of the sequence that were used up
  std::uint32_t entries = 0;         ///< how often it has been put into the queue; the last one counts
};

/// An element in the order of its turn.
struct Waiting {
  double light;
  std::uint32_t face, element, entry;

  bool operator<(const Waiting& other) const {
    return std::make_tuple(light, other.face, other.element) < std::make_tuple(other.light, face, element);
  }
};

class Cutter {
 public:
  Cutter(const PreparedScene& scene, Meshing& meshing, const DiscontinuityOptions& options);

  void cut_until(std::uint32_t elements) {
    while (meshing_.element_count < elements && !queue_.empty() && queue_.top().light > 0) {
      const Waiting worst = queue_.top();
      queue_.pop();
      if (worst.entry == lit_[worst.face][worst.element].entries) {
        cut(worst.face, worst.element, elements - meshing_.element_count);
      }
    }
  }

 private:
  const Polygon2d& outline(std::uint32_t f, std::uint32_t e) const {
    return meshing_.faces[f].elements[e].outline;
  }
  double distance(std::uint32_t f, glm::dvec2 p, glm::dvec2 q) const {
    return glm::distance(scene_.frames[f].to_grid(p), scene_.frames[f].to_grid(q));
  }
  bool crosses(const CriticalLine& line, const Polygon2d& outline) const;
  double error_after(std::uint32_t f, const Polygon2d& border, const std::vector<LightSample>& samples,
                     const std::vector<Line2d>& lines, std::size_t first);
  std::vector<std::vector<Line2d>> halvings(std::uint32_t f, std::uint32_t e) const;
  std::vector<std::vector<Line2d>> possible_cuts(std::uint32_t f, std::uint32_t e) const;
  void enter(std::uint32_t f, std::uint32_t e);
  void cut(std::uint32_t f, std::uint32_t e, std::uint32_t most);
  bool cut_by(std::uint32_t f, std::uint32_t e, const std::vector<Line2d>& lines);
  void replace(std::uint32_t f, const std::vector<std::uint32_t>& parts);

  const PreparedScene& scene_;
  Meshing& meshing_;
  ElementLight light_;
  std::vector<CriticalLine> lines_;
  std::vector<std::vector<Lit>> lit_;  // [faces][elements]
  std::priority_queue<Waiting> queue_;
};

Cutter::Cutter(const PreparedScene& scene, Meshing& meshing, const DiscontinuityOptions& options)
    : scene_(scene), meshing_(meshing), light_(scene, options.weights), lit_(scene.faces.size()) {
  if (options.use_lines) {
    lines_ = find_critical_lines(scene);
  }
  for (std::uint32_t f = 0; f < lit_.size(); ++f) {
    Lit whole;
    Polygon2d corners;
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].face == f) {
        whole.lines.push_back(i);
      }
    }
    for (const CellElement& e : meshing.faces[f].elements) {
      corners.insert(corners.end(), e.outline.begin(), e.outline.end());
    }
    lit_[f].resize(meshing.faces[f].elements.size(), whole);
    for (std::uint32_t e = 0; e < lit_[f].size(); ++e) {
      lit_[f][e].border = outline(f, e);
      insert_on_sides(scene_.frames[f], lit_[f][e].border, corners);
      enter(f, e);
    }
  }
}

bool Cutter::crosses(const CriticalLine& line, const Polygon2d& polygon) const {
  return part_within(polygon, line.a, line.b).length() * line.length > kLeastCrossing;
}

double Cutter::error_after(std::uint32_t f, const Polygon2d& border, const std::vector<LightSample>& samples,
                           const std::vector<Line2d>& lines, std::size_t first) {
  if (first == lines.size() || samples.empty()) {
    return light_.error_of(f, border, samples);
  }
  const Line2d& line = lines[first];
  std::vector<LightSample> left, right;
  for (const LightSample& s : samples) {
    (glm::dot(line.normal, s.at) > line.offset ? left : right).push_back(s);
  }
  return error_after(f, clip(border, -line.normal, -line.offset), left, lines, first + 1) +
         error_after(f, clip(border, line.normal, line.offset), right, lines, first + 1);
}

/// Along the axes of the face, along the longest side and across it.
std::vector<std::vector<Line2d>> Cutter::halvings(std::uint32_t f, std::uint32_t e) const {
  const Polygon2d& polygon = outline(f, e);
  const glm::dvec2 middle = centroid(polygon);
  double longest = 0;
  glm::dvec2 a(0.0), b(0.0);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    if (distance(f, p, q) > longest) {
      longest = distance(f, p, q);
      a = p;
      b = q;
    }
  }
  return {{line_through(middle, middle + glm::dvec2(1.0, 0.0))},
          {line_through(middle, middle + glm::dvec2(0.0, 1.0))},
          {line_through(middle, middle + b - a)},
          {line_through((a + b) / 2.0, middle)}};
}

/// A single critical line, or two that part a strip of half-shadow from what is lit and what is not.
std::vector<std::vector<Line2d>> Cutter::possible_cuts(std::uint32_t f, std::uint32_t e) const {
  std::vector<std::vector<Line2d>> cuts = halvings(f, e);
  const std::vector<std::uint32_t>& lines = lit_[f][e].lines;
  const auto line = [&](std::size_t i) { return line_through(lines_[lines[i]].a, lines_[lines[i]].b); };
  const auto direction = [&](std::size_t i) {
    const FaceFrame& frame = scene_.frames[f];
    return glm::normalize(frame.to_grid(lines_[lines[i]].b) - frame.to_grid(lines_[lines[i]].a));
  };
  for (std::size_t i = 0; i < std::min(lines.size(), kMostLines); ++i) {
    cuts.push_back({line(i)});
    for (std::size_t j = 0; j < i && i < kMostOfPairs; ++j) {
      if (glm::length(glm::cross(direction(i), direction(j))) < kSlanted) {
        cuts.push_back({line(i), line(j)});
      }
    }
  }
  return cuts;
}

/// Completes what is known of an element and lets it wait for its turn.
void Cutter::enter(std::uint32_t f, std::uint32_t e) {
  Lit& lit = lit_[f][e];
  lit.lines.erase(std::remove_if(lit.lines.begin(), lit.lines.end(),
                                 [&](std::uint32_t i) { return !crosses(lines_[i], outline(f, e)); }),
                  lit.lines.end());
  const std::size_t wanted = lit.lines.empty() ? kSamples : kSamplesOfCut;
  while (lit.samples.size() < wanted) {
    lit.samples.push_back(light_.sample(f, spread_point(outline(f, e), lit.drawn++)));
  }
  const glm::dvec3 reflectance = scene_.model->materials[scene_.faces[f].material].reflectance;
  const double weight = channel_sum(reflectance) / 3 * area(outline(f, e)) * scene_.frames[f].unit_area() /
                        static_cast<double>(lit.samples.size());
  const double error = weight * light_.error_of(f, lit.border, lit.samples);
  lit.proposals.clear();
  for (std::vector<Line2d>& lines : possible_cuts(f, e)) {
    const double gain = error - weight * error_after(f, lit.border, lit.samples, lines, 0);
    lit.proposals.push_back({lines, gain / static_cast<double>(lines.size())});
  }
  std::stable_sort(lit.proposals.begin(), lit.proposals.end(),
                   [](const Proposal& x, const Proposal& y) { return x.gain > y.gain; });
  queue_.push({std::max(0.0, lit.proposals[0].gain) + kPatience * error, f, e, ++lit.entries});
}

/// Gives the parts of an element what was known of the whole, which stands at parts[0], and tells their
/// neighbours.
void Cutter::replace(std::uint32_t f, const std::vector<std::uint32_t>& parts) {
  const Lit whole = lit_[f][parts[0]];
  Polygon2d corners = whole.border;
  for (const std::uint32_t part : parts) {
    corners.insert(corners.end(), outline(f, part).begin(), outline(f, part).end());
  }
  const std::size_t before = lit_[f].size();
  lit_[f].resize(meshing_.faces[f].elements.size(), whole);
  for (const std::uint32_t part : parts) {
    Lit& lit = lit_[f][part];
    lit.border = outline(f, part);
    insert_on_sides(scene_.frames[f], lit.border, corners);
    const auto is_elsewhere = [&](const LightSample& s) { return !contains(outline(f, part), s.at); };
    lit.samples.erase(std::remove_if(lit.samples.begin(), lit.samples.end(), is_elsewhere),
                      lit.samples.end());
    enter(f, part);
  }
  for (std::uint32_t e = 0; e < before; ++e) {
    if (e != parts[0] && insert_on_sides(scene_.frames[f], lit_[f][e].border, corners)) {
      enter(f, e);
    }
  }
}

bool Cutter::cut_by(std::uint32_t f, std::uint32_t e, const std::vector<Line2d>& lines) {
  FaceElements& face = meshing_.faces[f];
  std::vector<std::uint32_t> parts{e};
  for (const Line2d& line : lines) {
    for (std::size_t i = 0, count = parts.size(); i < count; ++i) {
      if (cut_element(scene_.frames[f], face, parts[i], line)) {
        parts.push_back(static_cast<std::uint32_t>(face.elements.size() - 1));
      }
    }
  }
  if (parts.size() == 1) {
    return false;
  }
  meshing_.element_count += static_cast<std::uint32_t>(parts.size() - 1);
  replace(f, parts);
  return true;
}

void Cutter::cut(std::uint32_t f, std::uint32_t e, std::uint32_t most) {
  const std::vector<Proposal> proposals = lit_[f][e].proposals;
  for (const Proposal& proposal : proposals) {
    // Two lines that cross make three more elements.
    if ((proposal.lines.size() == 1 || most >= 3) && cut_by(f, e, proposal.lines)) {
      return;
    }
  }
}

std::uint32_t count_patches(const Meshing& meshing) {
  std::uint32_t count = 0;
  for (const FaceElements& face : meshing.faces) {
    std::map<std::pair<int, int>, std::uint32_t> members;
    for (const CellElement& e : face.elements) {
      const std::uint32_t earlier = members[{e.v / meshing.block_v, e.u / meshing.block_u}]++;
      count += earlier % kMaxPatchElements == 0 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

Meshing make_discontinuity(const PreparedScene& scene, std::uint32_t elements, std::uint32_t patches,
                           const DiscontinuityOptions& options) {
  const auto coarse = static_cast<std::uint32_t>(options.coarse * elements);
  Meshing meshing = make_uniform(scene, std::max(coarse, 1u), patches);
  Cutter(scene, meshing, options).cut_until(elements);
  meshing.patch_count = count_patches(meshing);
  return meshing;
}

}  // namespace fixrad::host
