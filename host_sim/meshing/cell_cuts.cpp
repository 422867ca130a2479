// SPDX-License-Identifier: MIT
#include "host_sim/meshing/cell_cuts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "lib/scene/scene.h"

namespace fixrad::host {
namespace {

constexpr int kMostSlope = 1 << kCutBits;
constexpr int kMostOffset = 4 * kMostSlope - 1;

// The corner of an element's cell, where its own coordinates are 0: grid coordinates.
glm::dvec2 cell_corner(const FaceElements& face, const CellElement& element) {
  int v = element.v;
  while (v > 0 && face.row_first[static_cast<std::size_t>(v - 1)] ==
                      face.row_first[static_cast<std::size_t>(element.v)]) {
    --v;
  }
  return {element.u, v};
}

struct CellFrame {
  glm::dvec2 cells, corner;

  glm::dvec2 to_cell(glm::dvec2 st) const { return st * cells - corner; }
};

CellFrame cell_frame(const FaceElements& face, const CellElement& element) {
  return {{face.cells_u, face.cells_v}, cell_corner(face, element)};
}

double value(const CellCut& cut, glm::dvec2 p) {
  return cut.a * p.x + cut.b * p.y + cut.c;
}

// Where the line enters and leaves the outline.
std::pair<glm::dvec2, glm::dvec2> chord(const Polygon2d& outline, const Line2d& line) {
  const glm::dvec2 along(line.normal.y, -line.normal.x);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double da = glm::dot(line.normal, a) - line.offset, db = glm::dot(line.normal, b) - line.offset;
    if ((da <= 0) != (db <= 0)) {
      const double t = glm::dot(along, a + (b - a) * (da / (da - db)));
      low = std::min(low, t);
      high = std::max(high, t);
    }
  }
  const glm::dvec2 on_line = line.normal * (line.offset / glm::dot(line.normal, line.normal));
  const double unit = glm::dot(along, along);
  return {on_line + along * (low / unit), on_line + along * (high / unit)};
}

// The integers that come nearest to the line at its ends in the element, of all scales with |a|, |b| <= 2^9.
// Larger scales come first, so that of equals the finest wins.
CellCut round_cut(const Line2d& line, const CellFrame& cell, const std::pair<glm::dvec2, glm::dvec2>& ends) {
  const glm::dvec2 normal = line.normal / cell.cells;
  const double offset = glm::dot(normal, cell.corner) - line.offset;
  const double largest = std::max(std::abs(normal.x), std::abs(normal.y));
  CellCut best = {};
  double least = std::numeric_limits<double>::infinity();
  for (int scale = kMostSlope; scale > kMostSlope / 2; --scale) {
    const double s = scale / largest;
    const CellCut cut = {static_cast<int>(std::lround(normal.x * s)),
                         static_cast<int>(std::lround(normal.y * s)),
                         static_cast<int>(std::lround(offset * s)), 0, 0};
    const double error = std::max(std::abs(value(cut, cell.to_cell(ends.first))),
                                  std::abs(value(cut, cell.to_cell(ends.second)))) /
                         scale;
    if (error < least) {
      least = error;
      best = cut;
    }
  }
  return best;
}

// The cut as a line of the frame, as the core has it.
Line2d line_of(const CellCut& cut, const CellFrame& cell) {
  const glm::dvec2 normal = glm::dvec2(cut.a, cut.b) * cell.cells;
  return {normal, cut.a * cell.corner.x + cut.b * cell.corner.y - cut.c};
}

bool is_large(const FaceFrame& frame, const FaceElements& face, const Polygon2d& part,
              const LeastPart& least) {
  const double a = area(part) * frame.unit_area();
  double outline = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    outline += glm::distance(frame.to_grid(part[i]), frame.to_grid(part[(i + 1) % part.size()]));
  }
  return part.size() >= 3 && a >= least.area * frame.unit_area() / (face.cells_u * face.cells_v) &&
         4 * a >= least.width * outline;
}

bool is_near_cell(const CellFrame& cell, const Polygon2d& outline) {
  return std::all_of(outline.begin(), outline.end(), [&](glm::dvec2 p) {
    const glm::dvec2 q = cell.to_cell(p);
    return std::abs(q.x) <= 2 && std::abs(q.y) <= 2;
  });
}

// What leads to an element: its cell's root or a side of a cut.
int& link_to(FaceElements& face, int element) {
  const auto root = std::find(face.roots.begin(), face.roots.end(), element);
  if (root != face.roots.end()) {
    return *root;
  }
  const auto cut = std::find_if(face.cuts.begin(), face.cuts.end(), [element](const CellCut& c) {
    return c.left == element || c.right == element;
  });
  return cut->left == element ? cut->left : cut->right;
}

void number_roots(FaceElements& face) {
  for (std::size_t cell = face.roots.size(); cell < face.elements.size() && face.cuts.empty(); ++cell) {
    face.roots.push_back(static_cast<int>(cell));
  }
}

}  // namespace

Line2d line_through(glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 normal(a.y - b.y, b.x - a.x);
  return {normal, glm::dot(normal, a)};
}

SegmentPart part_within(const Polygon2d& polygon, glm::dvec2 a, glm::dvec2 b) {
  SegmentPart part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Line2d side = line_through(polygon[i], polygon[(i + 1) % polygon.size()]);
    part.keep_where(glm::dot(side.normal, a) - side.offset, glm::dot(side.normal, b) - side.offset);
  }
  return part;
}

bool cut_element(const FaceFrame& frame, FaceElements& face, std::size_t index, const Line2d& line,
                 const LeastPart& least) {
  const CellElement whole = face.elements[index];
  const CellFrame cell = cell_frame(face, whole);
  if (whole.depth >= kMostCuts || !is_near_cell(cell, whole.outline) ||
      glm::dot(line.normal, line.normal) <= 0) {
    return false;
  }
  const auto ends = chord(whole.outline, line);
  if (!(glm::distance(ends.first, ends.second) > 0) || !std::isfinite(ends.first.x + ends.second.x)) {
    return false;
  }
  CellCut cut = round_cut(line, cell, ends);
  const Line2d rounded = line_of(cut, cell);
  const Polygon2d left = clip(whole.outline, -rounded.normal, -rounded.offset);
  const Polygon2d right = clip(whole.outline, rounded.normal, rounded.offset);
  if (std::abs(cut.c) > kMostOffset || !is_large(frame, face, left, least) ||
      !is_large(frame, face, right, least)) {
    return false;
  }
  number_roots(face);
  cut.left = static_cast<int>(index);
  cut.right = static_cast<int>(face.elements.size());
  link_to(face, cut.left) = -1 - static_cast<int>(face.cuts.size());
  face.cuts.push_back(cut);
  face.elements[index] = {whole.u, whole.v, left, whole.depth + 1};
  face.elements.push_back({whole.u, whole.v, right, whole.depth + 1});
  return true;
}

int cut_along(const FaceFrame& frame, FaceElements& face, glm::dvec2 a, glm::dvec2 b, double reach,
              const LeastPart& least) {
  const double length = glm::distance(frame.to_grid(a), frame.to_grid(b));
  const Line2d line = line_through(a, b);
  int cuts = 0;
  for (std::size_t e = 0, count = face.elements.size(); e < count; ++e) {
    const SegmentPart part = part_within(face.elements[e].outline, a, b);
    cuts += part.length() * length > reach && cut_element(frame, face, e, line, least) ? 1 : 0;
  }
  return cuts;
}

}  // namespace fixrad::host
