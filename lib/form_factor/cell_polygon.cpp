// SPDX-License-Identifier: MIT
#include "lib/form_factor/cell_polygon.h"

namespace fixrad {
namespace {

constexpr int kAxisBits = 15;
constexpr int kLineBits = 20;  // of a grid line's normal
constexpr int kSideBits = 30;  // of a corner's distance from a line, before it is divided

FIXRAD_MODULO int wide_bits(int64_t a) {
  const uint64_t m = a < 0 ? 0u - static_cast<uint64_t>(a) : static_cast<uint64_t>(a);
  const uint32_t high = static_cast<uint32_t>(m >> 32);
  return high != 0 ? 32 + bit_length(high) : bit_length(static_cast<uint32_t>(m));
}

int64_t dot_wide(const Vec3& a, const Vec3& b) {
  return static_cast<int64_t>(a.x) * b.x + static_cast<int64_t>(a.y) * b.y + static_cast<int64_t>(a.z) * b.z;
}

// One family of grid lines: the line before cell k is where cells (normal . (p - origin)) = k extent.
struct GridLines {
  Vec3 normal, origin;
  int64_t extent;
  int32_t cells;

  int64_t side(const Vec3& p, int32_t line) const {
    return cells * dot_wide(normal, p - origin) - line * extent;
  }
};

// Lines of constant coordinate along `axis` run along `other`; normal x other points so that the coordinate
// grows.
GridLines grid_lines(const Face& face, const Vec3& axis, const Vec3& other, int32_t cells, int32_t sign) {
  const Vec3 n = cross(block_normalise(other, kAxisBits), vec(face.normal));
  const Vec3 normal = block_normalise({n.x * sign, n.y * sign, n.z * sign}, kLineBits);
  const Vec3 origin = vec(face.origin);
  return {normal,
          {origin.x * kFineScale, origin.y * kFineScale, origin.z * kFineScale},
          dot_wide(normal, {axis.x * kFineScale, axis.y * kFineScale, axis.z * kFineScale}),
          cells};
}

// One of them; what is kept lies where sign * side >= 0.
struct GridLine {
  const GridLines& lines;
  int32_t number, sign;

  int64_t side(const Vec3& p) const { return sign * lines.side(p, number); }
};

// Coordinates of a cell, Q16.
constexpr int kCellBits = 16;

int32_t cell_coordinate(const GridLines& lines, const Vec3& p, int32_t cell) {
  const int bits = wide_bits(lines.extent);
  const int shift = bits > kSideBits ? bits - kSideBits : 0;
  const int64_t extent = lines.extent >> shift;
  const int64_t way = (lines.side(p, cell) >> shift) * (static_cast<int64_t>(1) << kCellBits);
  return extent > 0 ? static_cast<int32_t>(way / extent) : 0;
}

// A cut of a cell; kept is what lies to its left, or to its right.
struct CutLine {
  const GridLines& columns;
  const GridLines& rows;
  const ElementCells& cells;
  Cut cut;
  bool is_right;

  int64_t side(const Vec3& p) const {
    const int64_t u = cell_coordinate(columns, p, cells.u), v = cell_coordinate(rows, p, cells.first_v);
    const int64_t left = cut.a * u + cut.b * v + cut.c * (static_cast<int64_t>(1) << kCellBits);
    return is_right ? -left : left;
  }
};

// Calls use(line) with each cut on the way to an element.
template <class Use>
void for_cuts(const Scene& scene, const ElementCells& cells, const GridLines& columns, const GridLines& rows,
              Use use) {
  uint16_t side = cells.root;
  for (int i = 0; i < cells.cuts; ++i) {
    const Cut cut = flash_read(scene.cuts, side);
    const bool is_right = (cells.way >> (kMostCuts - 1 - i) & 1) != 0;
    use(CutLine{columns, rows, cells, cut, is_right});
    side = is_right ? cut.right : cut.left;
  }
}

int32_t between(int32_t a, int32_t b, int32_t part, int32_t whole) {
  const int64_t way = static_cast<int64_t>(b - a) * part;
  const int64_t half = way < 0 ? -static_cast<int64_t>(whole / 2) : whole / 2;
  return a + static_cast<int32_t>((way + half) / whole);
}

// The point of the edge from `inside` (side > 0) to `outside` (side < 0) that lies on the line.
Vec3 cut_point(const Vec3& inside, int64_t in, const Vec3& outside, int64_t out) {
  const int bits = wide_bits(in - out);
  const int shift = bits > kSideBits ? bits - kSideBits : 0;
  const int32_t part = static_cast<int32_t>(in >> shift);
  const int32_t whole = part - static_cast<int32_t>(out >> shift);
  if (whole <= 0) {
    return inside;
  }
  return {between(inside.x, outside.x, part, whole), between(inside.y, outside.y, part, whole),
          between(inside.z, outside.z, part, whole)};
}

// Keeps the part where line.side() >= 0 (Sutherland & Hodgman 1974).
template <class Line>
void clip(const Line& line, Polygon& polygon) {
  const Polygon from = polygon;
  polygon.count = 0;
  if (from.count == 0) {
    return;
  }
  Vec3 a = from.corner[from.count - 1];
  int64_t side_a = line.side(a);
  for (int k = 0; k < from.count; ++k) {
    const Vec3 b = from.corner[k];
    const int64_t side_b = line.side(b);
    if (((side_a < 0 && side_b > 0) || (side_a > 0 && side_b < 0)) && polygon.count < Polygon::kMost) {
      polygon.corner[polygon.count++] =
          side_a > 0 ? cut_point(a, side_a, b, side_b) : cut_point(b, side_b, a, side_a);
    }
    if (side_b >= 0 && polygon.count < Polygon::kMost) {
      polygon.corner[polygon.count++] = b;
    }
    a = b;
    side_a = side_b;
  }
}

}  // namespace

void face_outline(const Scene& scene, const Face& face, Polygon& polygon) {
  polygon.count = face.corner_count;
  for (int k = 0; k < face.corner_count; ++k) {
    const Vec3 v = vec(flash_read(scene.vertices, corner_vertex(scene, face, k)));
    polygon.corner[k] = {v.x * kFineScale, v.y * kFineScale, v.z * kFineScale};
  }
}

bool ElementCellWalk::next_row() {
  if (cells_.end_v >= face_.cells_v) {
    return false;
  }
  cells_.first_v = cells_.end_v;
  row_ = flash_read(scene_.cell_rows, static_cast<unsigned>(face_.first_cell_row + cells_.first_v));
  do {
    ++cells_.end_v;
  } while (cells_.end_v < face_.cells_v &&
           flash_read(scene_.cell_rows, static_cast<unsigned>(face_.first_cell_row + cells_.end_v))
                   .first_element == row_.first_element);
  column_ = row_.first_cell;
  return true;
}

// Down the cuts along the way.
void ElementCellWalk::enter_element() {
  uint16_t side = cells_.root;
  for (cells_.cuts = 0; side < kLeaf && cells_.cuts < kMostCuts; ++cells_.cuts) {
    const Cut cut = flash_read(scene_.cuts, side);
    side = (cells_.way >> (kMostCuts - 1 - cells_.cuts) & 1) != 0 ? cut.right : cut.left;
  }
  cells_.element = static_cast<uint16_t>(side & (kLeaf - 1u));
}

bool ElementCellWalk::next() {
  const uint16_t step = static_cast<uint16_t>(1u << (kMostCuts - cells_.cuts));
  if (cells_.cuts > 0 && cells_.way + step < (1 << kMostCuts)) {
    cells_.way = static_cast<uint16_t>(cells_.way + step);  // carries over to the next side not yet seen
    enter_element();
    return true;
  }
  if (column_ > row_.last_cell && !next_row()) {
    return false;
  }
  enter_cell();
  return true;
}

void ElementCellWalk::enter_cell() {
  const uint16_t cell =
      static_cast<uint16_t>(row_.first_element + static_cast<unsigned>(column_ - row_.first_cell));
  cells_.u = static_cast<uint8_t>(column_);
  cells_.first_u = static_cast<uint8_t>(column_ == row_.first_cell ? 0 : column_);
  cells_.end_u = static_cast<uint8_t>(column_ == row_.last_cell ? face_.cells_u : column_ + 1);
  ++column_;
  cells_.way = 0;
  cells_.cuts = 0;
  cells_.element = cell;
  if (scene_.roots != nullptr) {
    cells_.root = flash_read(scene_.roots, cell);
    enter_element();
  }
}

void element_polygon(const Scene& scene, const Face& face, const ElementCells& cells, Polygon& polygon) {
  const Vec3 u = vec(face.axis_u), v = vec(face.axis_v);
  face_outline(scene, face, polygon);
  const GridLines rows = grid_lines(face, v, u, face.cells_v, -1);
  if (cells.first_v > 0) {
    clip(GridLine{rows, cells.first_v, 1}, polygon);
  }
  if (cells.end_v < face.cells_v) {
    clip(GridLine{rows, cells.end_v, -1}, polygon);
  }
  const GridLines columns = grid_lines(face, u, v, face.cells_u, 1);
  if (cells.first_u > 0) {
    clip(GridLine{columns, cells.first_u, 1}, polygon);
  }
  if (cells.end_u < face.cells_u) {
    clip(GridLine{columns, cells.end_u, -1}, polygon);
  }
  for_cuts(scene, cells, columns, rows, [&](const CutLine& cut) { clip(cut, polygon); });
}

CellPoint cell_point(const Face& face, const ElementCells& cells, const Vec3& point) {
  const Vec3 u = vec(face.axis_u), v = vec(face.axis_v);
  return {cell_coordinate(grid_lines(face, u, v, face.cells_u, 1), point, cells.u),
          cell_coordinate(grid_lines(face, v, u, face.cells_v, -1), point, cells.first_v)};
}

void cut_polygon(const Face& face, const ElementCells& cells, const Cut& cut, bool is_right,
                 Polygon& polygon) {
  const Vec3 u = vec(face.axis_u), v = vec(face.axis_v);
  const GridLines columns = grid_lines(face, u, v, face.cells_u, 1);
  const GridLines rows = grid_lines(face, v, u, face.cells_v, -1);
  clip(CutLine{columns, rows, cells, cut, is_right}, polygon);
}

namespace {

// Twice the area of a fan's triangle times the normal's length: 2^-12 square grid units times 2^14.
int64_t triangle(const Face& face, const Polygon& polygon, int k) {
  const Vec3 a = polygon.corner[k] - polygon.corner[0], b = polygon.corner[k + 1] - polygon.corner[0];
  const int64_t x = static_cast<int64_t>(a.y) * b.z - static_cast<int64_t>(a.z) * b.y;
  const int64_t y = static_cast<int64_t>(a.z) * b.x - static_cast<int64_t>(a.x) * b.z;
  const int64_t z = static_cast<int64_t>(a.x) * b.y - static_cast<int64_t>(a.y) * b.x;
  const int64_t area = x * face.normal[0] + y * face.normal[1] + z * face.normal[2];
  return area > 0 ? area : 0;
}

constexpr int kMomentBits = 24;  // of a fan's triangles, together

}  // namespace

PolygonMoments moments_of(const Face& face, const Polygon& polygon) {
  int64_t area = 0;
  for (int k = 1; k + 1 < polygon.count; ++k) {
    area += triangle(face, polygon, k);
  }
  const int shift = wide_bits(area) > kMomentBits ? wide_bits(area) - kMomentBits : 0;
  int64_t weight = 0, x = 0, y = 0, z = 0;
  for (int k = 1; k + 1 < polygon.count; ++k) {
    const Vec3 a = polygon.corner[0], b = polygon.corner[k], c = polygon.corner[k + 1];
    const int64_t w = triangle(face, polygon, k) >> shift;
    weight += w;
    x += w * (static_cast<int64_t>(a.x) + b.x + c.x);
    y += w * (static_cast<int64_t>(a.y) + b.y + c.y);
    z += w * (static_cast<int64_t>(a.z) + b.z + c.z);
  }
  if (weight == 0) {
    return {0, polygon.count > 0 ? polygon.corner[0] : Vec3{0, 0, 0}};
  }
  return {static_cast<uint64_t>(area),
          {static_cast<int32_t>(x / (3 * weight)), static_cast<int32_t>(y / (3 * weight)),
           static_cast<int32_t>(z / (3 * weight))}};
}

namespace {

int32_t cell_of_point(const GridLines& lines, const Vec3& point) {
  int32_t cell = 0;
  while (cell + 1 < lines.cells && lines.side(point, cell + 1) >= 0) {
    ++cell;
  }
  return cell;
}

}  // namespace

ElementCells cells_at(const Scene& scene, const Face& face, const Vec3& point) {
  const Vec3 u = vec(face.axis_u), v = vec(face.axis_v);
  const GridLines columns = grid_lines(face, u, v, face.cells_u, 1);
  const GridLines rows = grid_lines(face, v, u, face.cells_v, -1);
  const int32_t column = cell_of_point(columns, point);
  const int32_t row = cell_of_point(rows, point);
  ElementCellWalk walk(scene, face);
  while (walk.next()) {
    const ElementCells& c = walk.cells();
    bool holds = column >= c.first_u && column < c.end_u && row >= c.first_v && row < c.end_v;
    for_cuts(scene, c, columns, rows, [&](const CutLine& cut) {
      const int64_t side = cut.side(point);
      holds = holds && (side > 0 || (side == 0 && !cut.is_right));
    });
    if (holds) {
      break;
    }
  }
  return walk.cells();
}

ElementCells cells_of(const Scene& scene, const Face& face, uint16_t element) {
  ElementCellWalk walk(scene, face);
  while (walk.next() && walk.cells().element != element) {
  }
  return walk.cells();
}

}  // namespace fixrad
