// SPDX-License-Identifier: MIT
#include "host_sim/reference/twin_hemisphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/reference/twin_split.h"
#include "lib/form_factor/scanline.h"

namespace fixrad::host {
namespace {

constexpr std::uint32_t kEscaped = 0xffffffff;
constexpr std::uint32_t kBack = 0xfffffffe;

// As in the core: an uncovered interval of a closed scene no wider than this belongs to its neighbour; the
// row is 2 long.
constexpr double kSliver = 2.0 / 256;

int first_row_of(int side, int resolution) {
  return side == kTop ? 0 : resolution / 2;
}

double weight_of(const EyeSample& sample) {
  return static_cast<double>(sample.weight) / kRowOne;
}

void give(TwinFormFactors& row, std::uint32_t slot, double part) {
  if (slot == kEscaped) {
    row.escaped += part;
  } else if (slot == kBack) {
    row.back += part;
  } else {
    row.share[slot] += part;
  }
}

}  // namespace

TwinHemisphere::TwinHemisphere(const TwinScene& scene, TwinEngine engine)
    : scene_(scene), engine_(engine), view_(scene), visible_(scene.faces.size()) {}

const TwinDeltaTable& TwinHemisphere::hemicube_table(int resolution) {
  return tables_.try_emplace(resolution, resolution).first->second;
}

void TwinHemisphere::add(const RecordedEye& eye, TwinFormFactors& row) {
  make_twin_view(scene_, eye.sample.eye, backs_in(eye.sample), view_);
  switch (engine_) {
    case TwinEngine::rows:
      add_hemicube_rows(eye, row);
      break;
    case TwinEngine::pixels:
      add_pixels(eye, row);
      break;
    case TwinEngine::lunes:
      add_lunes(eye, row);
      break;
  }
}

void TwinHemisphere::add_hemicube_rows(const RecordedEye& eye, TwinFormFactors& row) {
  const TwinDeltaTable& table = hemicube_table(eye.resolution);
  for (int side = 0; side < kSides; ++side) {
    enter_twin_side(scene_, side, eye.resolution, view_);
    for (int r = first_row_of(side, eye.resolution); r < eye.resolution; ++r) {
      sample_row(r, twin_row(side, r, eye.resolution), !eye.sample.back_faces,
                 {row, table.row(side == kTop, r), weight_of(eye.sample), 0});
    }
  }
}

void TwinHemisphere::add_lunes(const RecordedEye& eye, TwinFormFactors& row) {
  enter_twin_lunes(scene_, eye.resolution, view_);
  for (int r = 0; r < eye.resolution; ++r) {
    sample_row(r, twin_lune(r, eye.resolution), !eye.sample.back_faces,
               {row, twin_lune_delta_row(eye.resolution), weight_of(eye.sample), 0});
  }
}

void TwinHemisphere::sample_row(int r, const TwinRow& at, bool is_closed, Sink sink) {
  find_visible(r, at);
  write_row(at, is_closed, sink);
}

void TwinHemisphere::find_visible(int r, const TwinRow& at) {
  visible_.reset();
  for (std::uint32_t i = 0; i < view_.count; ++i) {
    TwinFaceView& seen = view_.faces[i];
    if (r < seen.first_row || r > seen.last_row) {
      continue;
    }
    const TwinInterval part = twin_face_interval(scene_, at, view_, seen);
    if (part.begin < part.end) {
      visible_.insert(i, part, at, view_);
    }
  }
}

std::uint32_t TwinHemisphere::covering_view(std::uint32_t i, std::uint32_t previous, bool is_closed) const {
  const std::uint32_t seen = visible_[i].view;
  if (seen != kTwinNothing || !is_closed || visible_.end_of(i) - visible_[i].start > kSliver) {
    return seen;
  }
  if (previous != kTwinNothing) {
    return previous;
  }
  const std::uint32_t next = visible_[i].next;
  return next == kTwinNothing ? kTwinNothing : visible_[next].view;
}

void TwinHemisphere::write_row(const TwinRow& at, bool is_closed, Sink& sink) const {
  std::uint32_t previous = kTwinNothing;
  for (std::uint32_t i = 0; i != kTwinNothing; i = visible_[i].next) {
    const TwinInterval part = {visible_[i].start, visible_.end_of(i)};
    const std::uint32_t index = covering_view(i, previous, is_closed);
    previous = index;
    if (part.begin >= part.end) {
      continue;
    }
    if (index == kTwinNothing || view_.faces[index].is_back) {
      (index == kTwinNothing ? sink.row.escaped : sink.row.back) += sink.advance(part.end);
      continue;
    }
    for (TwinElementWalk walk(scene_, view_.faces[index], at, part); walk.next();) {
      sink.row.share[walk.element()] += sink.advance(walk.end());
    }
  }
}

void TwinHemisphere::add_pixels(const RecordedEye& eye, TwinFormFactors& row) {
  const int size = eye.resolution;
  const TwinDeltaTable& table = hemicube_table(size);
  for (int side = 0; side < kSides; ++side) {
    items_.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                  {-std::numeric_limits<double>::infinity(), kEscaped});
    enter_twin_side(scene_, side, size, view_);
    for (std::size_t i = 0; i < view_.count; ++i) {
      draw_face(side, size, view_.faces[i]);
    }
    write_pixels(side, table, size, weight_of(eye.sample), row);
  }
}

void TwinHemisphere::draw_face(int side, int size, TwinFaceView& seen) {
  for (int r = seen.first_row; r <= seen.last_row; ++r) {
    const TwinRow at = twin_row(side, r, size);
    const TwinInterval part = twin_face_interval(scene_, at, view_, seen);
    if (part.begin >= part.end) {
      continue;
    }
    Item* items = items_.data() + static_cast<std::ptrdiff_t>(r) * size;
    if (seen.is_back) {
      draw(items, size, at, seen, kBack, part);
      continue;
    }
    double begin = part.begin;
    for (TwinElementWalk walk(scene_, seen, at, part); walk.next(); begin = walk.end()) {
      draw(items, size, at, seen, walk.element(), {begin, walk.end()});
    }
  }
}

// Pixels whose centres lie in the interval: both ends round alike, so neighbours share no pixel.
void TwinHemisphere::draw(Item* items, int size, const TwinRow& at, const TwinFaceView& seen,
                          std::uint32_t slot, TwinInterval part) {
  const auto first_from = [size](double x) { return static_cast<int>(std::ceil((x + 1) * size / 2 - 0.5)); };
  const double middle = glm::dot(seen.plane, at.middle);
  const double slope = glm::dot(seen.plane, at.along) / size;
  const int end = first_from(part.end);
  for (int pixel = first_from(part.begin); pixel < end; ++pixel) {
    const double inverse_depth = middle + slope * (2 * pixel + 1 - size);
    if (inverse_depth > items[pixel].inverse_depth) {
      items[pixel] = {inverse_depth, slot};
    }
  }
}

void TwinHemisphere::write_pixels(int side, const TwinDeltaTable& table, int size, double weight,
                                  TwinFormFactors& row) const {
  for (int r = first_row_of(side, size); r < size; ++r) {
    const Item* items = items_.data() + static_cast<std::ptrdiff_t>(r) * size;
    const TwinDeltaRow delta = table.row(side == kTop, r);
    for (int pixel = 0; pixel < size; ++pixel) {
      give(row, items[pixel].slot, weight * delta.pixel(pixel));
    }
  }
}

}  // namespace fixrad::host
