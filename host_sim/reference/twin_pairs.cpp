// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_pairs.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "host_sim/reference/contour.h"

namespace fixrad::host {
namespace {

constexpr double kGap = 1.0 / 1024;    // of a closed scene, that contour_row() closes
constexpr double kRayGap = 1.0 / 256;  // the same of ray_row()
constexpr int kLostRows = 16;          // lunes that measure what reaches no front

double weight_of(const RecordedEye& eye) {
  return static_cast<double>(eye.sample.weight) / kRowOne;
}

std::vector<glm::dvec3> corners_of(const Polygon& polygon, bool reversed) {
  std::vector<glm::dvec3> corners;
  corners.reserve(static_cast<std::size_t>(polygon.count));
  for (int k = 0; k < polygon.count; ++k) {
    corners.push_back(to_double(polygon.corner[k]));
  }
  if (reversed) {
    std::reverse(corners.begin(), corners.end());
  }
  return corners;
}

}  // namespace

TwinPairs::TwinPairs(const Scene& scene, const TwinScene& twin)
    : scene_(scene), twin_(twin), lunes_(twin, TwinEngine::lunes), views_(scene.face_count) {
  work_.views = views_.data();
}

double TwinPairs::factor(const Vec3& point, std::uint32_t from_face, const Polygon& polygon) const {
  return point_to_polygon(to_double(point), twin_.faces[from_face].normal, corners_of(polygon, false));
}

double TwinPairs::mean_factor(const AreaSource& source, std::uint32_t from_face,
                              const Polygon& target) const {
  double sum = 0;
  for (int i = 0; i < AreaSource::kPoints; ++i) {
    sum += factor(source.point(i), from_face, target);
  }
  return sum / AreaSource::kPoints;
}

bool TwinPairs::shows_front(std::uint32_t face, const EyePoint& eye) const {
  const TwinFace& f = twin_.faces[face];
  return glm::dot(f.normal, to_double(eye.position) - twin_.vertices[twin_.corners[f.first_corner]]) > 0;
}

void TwinPairs::add_contours(const RecordedEye& eye, TwinFormFactors& row) const {
  const EyePoint& at = eye.sample.eye;
  const Vec3 point = fine_point(at.position);
  double sum = 0, largest = 0;
  std::size_t largest_element = 0;
  const auto take = [&sum](double part) {
    const double taken = std::min(part, 1 - sum);
    sum += taken;
    return taken;
  };
  for (std::uint32_t f = 0; f < scene_.face_count; ++f) {
    const fixrad::Face face = flash_read(scene_.faces, f);
    Polygon polygon;
    if (f != at.face && shows_front(f, at)) {
      for (ElementCellWalk walk(scene_, face); walk.next();) {
        element_polygon(scene_, face, walk.cells(), polygon);
        const double part = factor(point, at.face, polygon);
        row.share[walk.cells().element] += weight_of(eye) * take(part);
        largest_element = part > largest ? walk.cells().element : largest_element;
        largest = std::max(part, largest);
      }
    } else if (f != at.face && eye.sample.back_faces) {
      face_outline(scene_, face, polygon);
      row.back += weight_of(eye) * take(point_to_polygon(to_double(point), twin_.faces[at.face].normal,
                                                         corners_of(polygon, true)));
    }
  }
  const bool is_gap = !eye.sample.back_faces && largest > 0 && 1 - sum <= kGap;
  (is_gap ? row.share[largest_element] : row.escaped) += weight_of(eye) * (1 - sum);
}

double TwinPairs::lost_share(const RecordedEye& eye) {
  RecordedEye probe = {eye.sample, kLostRows};
  probe.sample.weight = kRowOne;
  probe.sample.back_faces = true;
  TwinFormFactors seen;
  seen.share.resize(scene_.element_count);
  lunes_.add(probe, seen);
  const double lost = seen.escaped + seen.back;
  return !eye.sample.back_faces && lost <= kRayGap ? 0 : lost;
}

// Adds what one face receives before anything is scaled; returns what its back takes.
double TwinPairs::add_ray_face(std::uint32_t f, const RecordedEye& eye, RayPairs& pairs,
                               TwinFormFactors& row) {
  const EyePoint& at = eye.sample.eye;
  const fixrad::Face face = flash_read(scene_.faces, f);
  const bool is_front = shows_front(f, at);
  Polygon target;
  face_outline(scene_, face, target);
  const double whole = point_to_polygon(to_double(pairs.eye().position), twin_.faces[at.face].normal,
                                        corners_of(target, !is_front));
  if (whole <= 0 || (!is_front && !eye.sample.back_faces)) {
    return 0;
  }
  pairs.enter_target(static_cast<std::uint16_t>(f));
  const auto arriving = [&](std::uint16_t slot, double part) {
    return part > 0 ? part * pairs.free_rays(slot, target) / (1 << pairs.log2()) : 0.0;
  };
  if (!is_front) {
    return arriving(kBackSlot, whole);
  }
  for (ElementCellWalk walk(scene_, face); walk.next();) {
    const std::uint16_t element = walk.cells().element;
    element_polygon(scene_, face, walk.cells(), target);
    const double part = pairs.is_near(element) ? mean_factor(pairs.source(), at.face, target)
                                               : factor(pairs.eye().position, at.face, target);
    row.share[element] += weight_of(eye) * arriving(element, part);
  }
  return 0;
}

// As the core: what is lost is known from rows, and all entries so far are scaled to make up the rest.
void TwinPairs::add_rays(const RecordedEye& eye, TwinFormFactors& row) {
  const double before = std::accumulate(row.share.begin(), row.share.end(), 0.0);
  const double lost = weight_of(eye) * lost_share(eye);
  RayPairs pairs(scene_, eye.sample, bit_length(static_cast<std::uint32_t>(eye.resolution)) - 1, work_);
  double back = 0;
  for (std::uint32_t f = 0; f < scene_.face_count; ++f) {
    back += f == eye.sample.eye.face ? 0 : add_ray_face(f, eye, pairs, row);
  }
  const double seen = std::accumulate(row.share.begin(), row.share.end(), 0.0);
  const double wanted = before + weight_of(eye) - lost;
  const double taken = std::min(weight_of(eye) * back, lost);
  row.back += taken;
  row.escaped += lost - taken + (seen > 0 ? 0 : wanted);
  for (double& share : row.share) {
    share *= seen > 0 ? wanted / seen : 0;
  }
}

}  // namespace fixrad::host
