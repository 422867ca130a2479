// SPDX-License-Identifier: MIT
#include "lib/form_factor/engine.h"
#include "lib/form_factor/spans.h"
#include "lib/form_factor/split.h"

namespace fixrad {
namespace {

struct PixelRow {
  BandRow at;
  Item* items;  // [R]
  uint8_t resolution_log2;

  int32_t frac_bits() const { return kRowLog2 - resolution_log2; }
  int32_t centre(int32_t pixel) const { return (pixel << frac_bits()) + (1 << (frac_bits() - 1)); }

  // First pixel whose centre is at or right of x: both ends of an interval round alike, so neighbours share
  // no pixel.
  int32_t first_from(int32_t x) const { return (x + (1 << (frac_bits() - 1)) - 1) >> frac_bits(); }
};

void draw(const PixelRow& row, uint16_t view, uint16_t slot, Interval part, const FaceView* views) {
  const int32_t end = row.first_from(part.end);
  const RowDepth depth = row_depth(views[view], row.at.plane);
  for (int32_t pixel = row.first_from(part.begin); pixel < end; ++pixel) {
    Item& item = row.items[pixel];
    if (item.view == kNothing ||
        nearness(depth, row_depth(views[item.view], row.at.plane), row.centre(pixel)) > 0) {
      item = {slot, view};
    }
  }
}

void draw_face_row(const Scene& scene, const PixelRow& row, uint16_t index, Workspace& work) {
  FaceView& view = work.views[index];
  const Interval part = face_interval(scene, row.at, work.directions, view);
  if (part.begin >= part.end) {
    return;
  }
  if (view.is_back) {
    draw(row, index, kBackSlot, part, work.views);
    return;
  }
  int32_t begin = part.begin;
  for (ElementWalk walk(scene, view, row.at.plane, part); walk.next(); begin = walk.end()) {
    draw(row, index, walk.element(), {begin, walk.end()}, work.views);
  }
}

void draw_side(const Scene& scene, const DeltaTable& table, int side, Workspace& work) {
  const int size = 1 << table.resolution_log2;
  const uint32_t pixels = static_cast<uint32_t>(1) << (2 * table.resolution_log2);
  for (uint32_t i = 0; i < pixels; ++i) {
    work.items[i] = {kEscapedSlot, kNothing};
  }
  for (int first = side == kTop ? 0 : size / 2; first < size; first += kBandRows) {
    const int count = band_count(table, first);
    enter_side_band(scene, table, side, first, count, work);
    for (int r = 0; r < count; ++r) {
      const PixelRow row = {band_row(table, first, r),
                            work.items + (static_cast<uint32_t>(first + r) << table.resolution_log2),
                            table.resolution_log2};
      for (uint16_t i = 0; i < work.view_count; ++i) {
        if ((work.views[i].rows & row.at.bit) != 0) {
          draw_face_row(scene, row, i, work);
        }
      }
    }
  }
}

}  // namespace

Status hemicube_pixels(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                       FormFactorRow& row) {
  if ((static_cast<uint32_t>(1) << (2 * table.resolution_log2)) > work.item_capacity) {
    return Status::item_buffer_too_small;
  }
  make_view(scene, sample.eye, backs_in(sample), work);
  make_grids(scene, sample.eye, work);
  make_depths(scene, sample.eye, work);
  RowWriter writer(row, sample.weight);
  const int size = 1 << table.resolution_log2;
  uint32_t base = 0;
  for (int side = 0; side < kSides; ++side) {
    if (side != kTop) {
      turn_view(side, scene.vertex_count, work);
    }
    draw_side(scene, table, side, work);
    for (int r = side == kTop ? 0 : size / 2; r < size; ++r) {
      const Item* items = work.items + (static_cast<uint32_t>(r) << table.resolution_log2);
      const DeltaRow delta = delta_row(table, side == kTop, r);
      for (int pixel = 0; pixel < size; ++pixel) {
        const int32_t end = (pixel + 1) << (kRowLog2 - table.resolution_log2);
        writer.add(items[pixel].slot, base + delta.sum_to(end));
      }
      base += 2 * delta.half_total;
    }
  }
  return Status::ok;
}

}  // namespace fixrad
