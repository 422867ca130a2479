// SPDX-License-Identifier: MIT
#include "host_sim/meshing/critical_merge.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

#include "host_sim/meshing/critical_edges.h"

namespace fixrad::host {
namespace {

constexpr double kOneLine = 1.0;      // grid units between pieces of one line
constexpr double kGap = 2.0;          // along it
constexpr double kShortest = 4.0;     // a line shorter than this cuts off slivers only
constexpr double kElementSize = 500;  // grid units; importance is judged for elements of about this size

/// A line with its ends in space, grid units.
struct Piece {
  CriticalLine line;
  glm::dvec3 a, b;
};

auto position_key(const CriticalLine& l) {
  return std::make_tuple(l.a.x, l.a.y, l.b.x, l.b.y, l.order, l.kind, l.irradiance, l.width);
}

bool is_longer(const Piece& p, const Piece& q) {
  return p.line.length != q.line.length ? p.line.length > q.line.length
                                        : position_key(p.line) < position_key(q.line);
}

bool is_more_important(const Piece& p, const Piece& q) {
  const double light_p = misplaced_light(p.line, kElementSize),
               light_q = misplaced_light(q.line, kElementSize);
  return light_p != light_q ? light_p > light_q : position_key(p.line) < position_key(q.line);
}

double distance_to_segment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = b - a;
  const double squared = glm::dot(d, d);
  const double along = squared > 0 ? std::clamp(glm::dot(point - a, d) / squared, 0.0, 1.0) : 0.0;
  return glm::length(point - a - along * d);
}

/// Takes `piece` up into the longer `whole`, if both are parts of one line.
bool join(Piece& whole, const Piece& piece) {
  const glm::dvec3 d = whole.b - whole.a;
  const double length = glm::length(d);
  const glm::dvec3 unit = d / length;
  const auto off = [&](const glm::dvec3& p) {
    return glm::length(p - whole.a - glm::dot(p - whole.a, unit) * unit);
  };
  double from = glm::dot(piece.a - whole.a, unit), to = glm::dot(piece.b - whole.a, unit);
  if (from > to) {
    std::swap(from, to);
  }
  if (to < -kGap || from > length + kGap || off(piece.a) > kOneLine || off(piece.b) > kOneLine) {
    return false;
  }
  const glm::dvec3 start = whole.a;
  whole.a = start + std::min(0.0, from) * unit;
  whole.b = start + std::max(length, to) * unit;
  const auto key = [](const CriticalLine& l) {
    return std::make_tuple(l.order, -l.irradiance, l.width, l.kind);
  };
  if (key(piece.line) < key(whole.line)) {
    whole.line = piece.line;
  }
  whole.line.length = glm::length(whole.b - whole.a);
  return true;
}

/// One round of joining; whether anything was.
bool join_all(std::vector<Piece>& pieces) {
  std::sort(pieces.begin(), pieces.end(), is_longer);
  std::vector<Piece> joined;
  for (const Piece& piece : pieces) {
    if (std::none_of(joined.begin(), joined.end(), [&](Piece& whole) { return join(whole, piece); })) {
      joined.push_back(piece);
    }
  }
  const bool is_changed = joined.size() < pieces.size();
  pieces.swap(joined);
  return is_changed;
}

bool is_on_border(const PreparedScene& scene, const Piece& piece) {
  const std::vector<std::uint32_t>& corners = scene.faces[piece.line.face].corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 p(scene.vertices.positions[corners[k]]);
    const glm::dvec3 q(scene.vertices.positions[corners[(k + 1) % corners.size()]]);
    if (distance_to_segment(piece.a, p, q) <= kTouchingPlane &&
        distance_to_segment(piece.b, p, q) <= kTouchingPlane) {
      return true;
    }
  }
  return false;
}

std::vector<Piece> without_neighbours(std::vector<Piece> pieces, double separation) {
  std::sort(pieces.begin(), pieces.end(), is_more_important);
  std::vector<Piece> kept;
  for (const Piece& piece : pieces) {
    const auto is_beside = [&](const Piece& other) {
      return distance_to_segment(piece.a, other.a, other.b) <= separation &&
             distance_to_segment(piece.b, other.a, other.b) <= separation;
    };
    if (std::none_of(kept.begin(), kept.end(), is_beside)) {
      kept.push_back(piece);
    }
  }
  return kept;
}

}  // namespace

std::vector<CriticalLine> merge_lines(const PreparedScene& scene, std::vector<CriticalLine> lines,
                                      double separation) {
  std::vector<std::vector<Piece>> by_face(scene.faces.size());
  for (const CriticalLine& line : lines) {
    const FaceFrame& frame = scene.frames[line.face];
    Piece piece = {line, frame.to_grid(line.a), frame.to_grid(line.b)};
    piece.line.length = glm::length(piece.b - piece.a);
    if (piece.line.length >= kGap) {
      by_face[line.face].push_back(piece);
    }
  }
  lines.clear();
  for (std::vector<Piece>& pieces : by_face) {
    while (join_all(pieces)) {
    }
    const auto is_useless = [&](const Piece& piece) {
      return piece.line.length < kShortest || is_on_border(scene, piece);
    };
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_useless), pieces.end());
    for (const Piece& piece : without_neighbours(std::move(pieces), separation)) {
      const FaceFrame& frame = scene.frames[piece.line.face];
      lines.push_back(piece.line);
      lines.back().a = frame.to_frame(piece.a);
      lines.back().b = frame.to_frame(piece.b);
    }
  }
  return lines;
}

}  // namespace fixrad::host
