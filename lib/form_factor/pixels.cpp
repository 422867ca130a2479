// SPDX-License-Identifier: MIT
#include "lib/form_factor/engine.h"
#include "lib/form_factor/spans.h"
#include "lib/form_factor/split.h"

namespace fixrad {
namespace {

struct PixelRow {
  RowPosition at;
  Item* items;  // [R]

  int32_t frac_bits() const { return kRowLog2 - at.resolution_log2; }
  int32_t centre(int32_t pixel) const { return (pixel << frac_bits()) + (1 << (frac_bits() - 1)); }

  // First pixel whose centre is at or right of x: both ends of an interval round alike, so neighbours share
  // no pixel.
  int32_t first_from(int32_t x) const { return (x + (1 << (frac_bits() - 1)) - 1) >> frac_bits(); }
};

void draw(const PixelRow& row, uint16_t view, uint16_t slot, Interval part, const FaceView* views) {
  const int32_t end = row.first_from(part.end);
  for (int32_t pixel = row.first_from(part.begin); pixel < end; ++pixel) {
    Item& item = row.items[pixel];
    if (item.view == kNothing ||
        nearness(views[view], views[item.view], row.at.direction(row.centre(pixel))) > 0) {
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
  for (ElementWalk walk(scene, view, row.at, part); walk.next(); begin = walk.end()) {
    draw(row, index, walk.element(), {begin, walk.end()}, work.views);
  }
}

void draw_side(const Scene& scene, int side, uint8_t resolution_log2, Workspace& work) {
  const uint32_t size = 1u << resolution_log2;
  for (uint32_t i = 0; i < size * size; ++i) {
    work.items[i] = {kEscapedSlot, kNothing};
  }
  enter_side(scene, side, resolution_log2, work);
  for (uint16_t i = 0; i < work.view_count; ++i) {
    const int last = work.views[i].last_row;
    for (int r = work.views[i].first_row; r <= last; ++r) {
      const RowPosition at = row_position(r, resolution_log2);
      draw_face_row(scene, {at, work.items + (static_cast<uint32_t>(r) << resolution_log2)}, i, work);
    }
  }
}

}  // namespace

Status hemicube_pixels(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                       FormFactorRow& row) {
  if ((static_cast<uint32_t>(1) << (2 * table.resolution_log2)) > work.item_capacity) {
    return Status::item_buffer_too_small;
  }
  make_view(scene, sample.eye, sample.back_faces, work);
  RowWriter writer(row, sample.begin, sample.weight);
  const int size = 1 << table.resolution_log2;
  uint32_t base = 0;
  for (int side = 0; side < kSides; ++side) {
    draw_side(scene, side, table.resolution_log2, work);
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
