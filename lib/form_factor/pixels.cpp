// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_sampling.h"
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

// Clears the row and draws all faces on it.
void draw_row(const Scene& scene, const PixelRow& row, Workspace& work) {
  for (int pixel = 0; pixel < 1 << row.resolution_log2; ++pixel) {
    row.items[pixel] = {kEscapedSlot, kNothing};
  }
  for (uint16_t i = 0; i < work.view_count; ++i) {
    if ((work.views[i].rows & row.at.bit) != 0) {
      draw_face_row(scene, row, i, work);
    }
  }
}

void write_pixels(const PixelRow& row, const DeltaRow& delta, uint32_t base, RowWriter& writer) {
  for (int pixel = 0; pixel < 1 << row.resolution_log2; ++pixel) {
    const int32_t end = (pixel + 1) << row.frac_bits();
    writer.add(row.items[pixel].slot, base + delta.sum_to(end));
  }
}

}  // namespace

Status hemicube_pixels(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                       FormFactorRow& row) {
  if ((static_cast<uint32_t>(1) << (2 * table.resolution_log2)) > work.item_capacity) {
    return Status::item_buffer_too_small;
  }
  ViewCursor& at = work.at;
  if (at.next == 0) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    make_view(scene, sample.eye, backs_in(sample), work);
    make_grids(scene, sample.eye, work);
    make_depths(scene, sample.eye, work);
    at.next = 1;
    spend(work);
  }
  RowWriter writer(row, sample.weight, at.sum);
  for (int done = at.done(); done < 3 << table.resolution_log2; ++done, ++at.next, spend(work)) {
    if (is_used_up(work)) {
      return Status::in_progress;
    }
    const SideRow place = side_row(table, done);
    enter_side_row(scene, table, place, work);
    const PixelRow pixels = {band_row(table, place.first, place.row - place.first),
                             work.items + (static_cast<uint32_t>(place.row) << table.resolution_log2),
                             table.resolution_log2};
    draw_row(scene, pixels, work);
    const DeltaRow delta = delta_row(table, place.side == kTop, place.row);
    write_pixels(pixels, delta, at.sum, writer);
    at.sum += 2 * delta.half_total;
  }
  return end_view(work, Status::ok);
}

}  // namespace fixrad
