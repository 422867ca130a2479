// SPDX-License-Identifier: MIT
// The loops of a view, each on input that makes it dear, in a region of its own: scripts/time_bound.py takes
// what one turn of each costs from the largest counts. Directions, normals and depths are random within the
// ranges that load() and the engines promise, since what a turn costs depends on bits (shifts, divisions,
// which way two faces pierce each other).

#include <stdint.h>

#include "firmware/apps/text.h"
#include "firmware/regions.h"
#include "lib/fixrad.h"
#include "lib/form_factor/row_sampling.h"
#include "lib/form_factor/split.h"

FIXRAD_REGION(between);
FIXRAD_REGION(view_8_vertices);
FIXRAD_REGION(view_64_vertices);
FIXRAD_REGION(view_16_faces);
FIXRAD_REGION(grid_16_faces);
FIXRAD_REGION(depth_16_faces);
FIXRAD_REGION(band_8_vertices);
FIXRAD_REGION(band_64_vertices);
FIXRAD_REGION(band_16_faces);
FIXRAD_REGION(interval);
FIXRAD_REGION(row_0_faces);
FIXRAD_REGION(row_16_faces);
FIXRAD_REGION(meet_8_spans);
FIXRAD_REGION(meet_32_spans);
FIXRAD_REGION(shift_8_spans);
FIXRAD_REGION(shift_32_spans);
FIXRAD_REGION(span);
FIXRAD_REGION(piece);
FIXRAD_REGION(sum);
FIXRAD_REGION(candidate);

namespace {

using namespace fixrad;

constexpr uint16_t kVertexCount = 64, kFaceCount = 17, kSpanCount = 100, kCells = 16;
constexpr int kTrials = 60;

uint32_t state_of_dice = 1;

uint32_t bits() {
  state_of_dice ^= state_of_dice << 13;
  state_of_dice ^= state_of_dice >> 17;
  state_of_dice ^= state_of_dice << 5;
  return state_of_dice;
}

int32_t between(int32_t low, int32_t high) {
  return low + static_cast<int32_t>(bits() % static_cast<uint32_t>(high - low + 1));
}

int16_t short_between(int32_t low, int32_t high) {
  return static_cast<int16_t>(between(low, high));
}

Vertex vertices[kVertexCount];
uint16_t corners[kFaceCount * kMaxCorners];
Face faces[kFaceCount];
CellRow cell_rows[kCells];
Direction directions[kVertexCount];
FaceView views[kFaceCount];
Span spans[kSpanCount];
uint32_t share[kCells * kCells];
Workspace work;
FormFactorRow row = {share, kCells* kCells, 0, 0};

// A component of a vector that is not longer than one, Q14.
int16_t part_of_unit() {
  return short_between(-9459, 9459);
}

// Half of the vertices lie below the eyes, half above; a face has its first seven corners below, so that all
// eight are looked at. Face 0 is the eyes' own.
void make_scene() {
  for (uint16_t i = 0; i < kVertexCount; ++i) {
    const bool is_low = i < kVertexCount / 2;
    vertices[i] = {short_between(0, kGridMax), short_between(0, kGridMax),
                   is_low ? short_between(0, 4000) : short_between(12000, kGridMax)};
  }
  for (uint16_t f = 0; f < kFaceCount; ++f) {
    Face& face = faces[f];
    face.first_corner = static_cast<uint16_t>(f * kMaxCorners);
    face.corner_count = kMaxCorners;
    face.cells_u = face.cells_v = kCells;
    for (int k = 0; k < kMaxCorners; ++k) {
      corners[f * kMaxCorners + k] = static_cast<uint16_t>(between(0, kVertexCount / 2 - 1) +
                                                           (k == kMaxCorners - 1 ? kVertexCount / 2 : 0));
    }
    for (int i = 0; i < 3; ++i) {
      face.normal[i] = part_of_unit();
      face.tangent[i] = 0;
      face.origin[i] = short_between(0, kGridMax);
      face.axis_u[i] = short_between(-kGridMax, kGridMax);
      face.axis_v[i] = short_between(-kGridMax, kGridMax);
    }
  }
  faces[0].normal[0] = faces[0].normal[1] = 0;
  faces[0].normal[2] = faces[0].tangent[0] = kUnit;
  for (uint16_t v = 0; v < kCells; ++v) {
    cell_rows[v] = {static_cast<uint16_t>(v * kCells), 0, kCells - 1};
  }
}

Scene scene_of(uint16_t vertex_count, uint16_t face_count) {
  Scene scene = {};
  scene.vertices = vertices;
  scene.corners = corners;
  scene.faces = faces;
  scene.cell_rows = cell_rows;
  scene.vertex_count = vertex_count;
  scene.face_count = face_count;
  return scene;
}

EyePoint random_eye() {
  return {{between(0, 65535), between(0, 65535), between(28000, 36000)},
          0,
          static_cast<uint8_t>(bits() % kTurns)};
}

// Runs `use` in the region that `enter` names.
template <class Enter, class Use>
void measure(const Enter& enter, const Use& use) {
  enter();
  use();
  fixrad_region_between();
}

void measure_views(const Scene& all) {
  const EyePoint eye = random_eye();
  const Scene few = scene_of(8, 1), many = scene_of(kVertexCount, 1);
  measure(fixrad_region_view_8_vertices, [&] { make_view(few, eye, Backs::all, work); });
  measure(fixrad_region_view_64_vertices, [&] { make_view(many, eye, Backs::all, work); });
  const DeltaTable table = flash_read(kLunes, 3);
  work.view_count = 0;
  measure(fixrad_region_band_8_vertices, [&] { enter_band(few, table, 0, kBandRows, work); });
  measure(fixrad_region_band_64_vertices, [&] { enter_band(many, table, 0, kBandRows, work); });
  measure(fixrad_region_view_16_faces, [&] { make_view(all, eye, Backs::all, work); });
  measure(fixrad_region_band_16_faces, [&] { enter_band(all, table, 0, kBandRows, work); });
  measure(fixrad_region_depth_16_faces, [&] { make_depths(all, eye, work); });
  for (uint16_t i = 0; i < work.view_count; ++i) {
    work.views[i].is_back = false;
  }
  measure(fixrad_region_grid_16_faces, [&] { make_grids(all, eye, work); });
}

// Both ways to the interval of a face: edges looked for anew, and all edges where rounding has bent it.
void measure_intervals(const Scene& all) {
  const DeltaTable table = flash_read(kLunes, 3);
  for (uint16_t i = 0; i < work.view_count; ++i) {
    const BandRow at = band_row(table, 0, static_cast<int>(bits() % kBandRows));
    FaceView& view = work.views[i];
    for (int is_ragged = 0; is_ragged < 2; ++is_ragged) {
      view.ragged = is_ragged != 0 ? 0xffff : 0;
      view.left.rows = view.right.rows = 0;
      if ((view.rows & at.bit) != 0) {
        measure(fixrad_region_interval, [&] { face_interval(all, at, work.directions, view); });
      }
    }
  }
}

void measure_empty_rows(const Scene& all) {
  const EyePoint eye = random_eye();
  const DeltaTable table = flash_read(kLunes, 3);
  VisibleSpans visible(all, eye, work);
  RowWriter writer(row, kRowOne / 9, 0);
  const uint16_t count = work.view_count;
  for (uint16_t i = 0; i < count; ++i) {
    work.views[i].rows = 0;
  }
  measure(fixrad_region_row_16_faces, [&] {
    sample_row(all, {table, true, 0, 3, false}, work, visible, writer);
  });
  work.view_count = 0;
  measure(fixrad_region_row_0_faces, [&] {
    sample_row(all, {table, true, 0, 4, false}, work, visible, writer);
  });
  work.view_count = count;
  forget_view(work);
}

void random_depth(FaceView& view) {
  for (int16_t& part : view.depth) {
    part = short_between(-16384, 16384);
  }
  view.depth_shift = static_cast<uint8_t>(between(14, 20));
}

// A row of `count` spans, each of another face than its neighbours.
void fill_row(VisibleSpans& visible, int count, const RowPlane& plane) {
  visible.reset();
  for (int i = 0; i < count; ++i) {
    visible.insert(static_cast<uint16_t>(1 + i % (kFaceCount - 2)),
                   {kRowEnd * i / count, kRowEnd * (i + 1) / count}, plane);
  }
}

// A face that meets all spans of a row, and one that pushes them all aside.
void measure_inserts(const Scene& all) {
  const EyePoint eye = random_eye();
  const RowPlane plane = row_plane(flash_read(kLunes, 3), static_cast<int>(bits() % 32));
  for (FaceView& view : views) {
    random_depth(view);
  }
  work.view_count = kFaceCount;
  VisibleSpans visible(all, eye, work);
  fill_row(visible, 8, plane);
  measure(fixrad_region_meet_8_spans, [&] { visible.insert(0, {1, kRowEnd - 1}, plane); });
  fill_row(visible, 32, plane);
  measure(fixrad_region_meet_32_spans, [&] { visible.insert(0, {1, kRowEnd - 1}, plane); });
  for (FaceView& view : views) {  // equally near everywhere but for face 0, which is nearest
    view.depth[0] = view.depth[1] = 0;
    view.depth[2] = &view == views ? 16384 : 8192;
    view.depth_shift = 16;
  }
  fill_row(visible, 8, plane);
  measure(fixrad_region_shift_8_spans, [&] { visible.insert(0, {1, 2}, plane); });
  fill_row(visible, 32, plane);
  measure(fixrad_region_shift_32_spans, [&] { visible.insert(0, {1, 2}, plane); });
}

void measure_pieces(const Scene& all) {
  const RowPlane plane = row_plane(flash_read(kLunes, 3), static_cast<int>(bits() % 32));
  const DeltaRow delta = delta_row(flash_read(kLunes, 3), true, 5);
  for (uint16_t i = 0; i < 4; ++i) {
    const FaceView& view = work.views[i];
    const int32_t begin = between(0, kRowEnd - 2);
    const Interval part = {begin, between(begin + 1, kRowEnd)};
    fixrad_region_span();
    ElementWalk walk(all, view, plane, part);
    fixrad_region_between();
    for (bool goes_on = true; goes_on;) {
      measure(fixrad_region_piece, [&] { goes_on = walk.next(); });
      RowWriter writer(row, 0x71c71);
      // More than 2^15, which is a wide part.
      measure(fixrad_region_sum, [&] { writer.add(walk.element(), 40000u + delta.sum_to(walk.end())); });
    }
  }
}

// A place for an eye in an element that is a whole cell.
void measure_candidates(const Scene& all) {
  const Element element = {40000, {30000, 30000, 30000}, 0, 0, 0};
  faces[0].cell_area = element.area;
  Scene scene = all;
  scene.elements = &element;
  scene.element_count = 1;
  measure(fixrad_region_candidate, [&] { eye_candidate(scene, 0, kFinestLevel, bits() % 9); });
}

}  // namespace

int main() {
  fixrad_region_between();
  work.directions = directions;
  work.views = views;
  work.spans = spans;
  work.span_capacity = kSpanCount;
  for (int trial = 0; trial < kTrials; ++trial) {
    make_scene();
    const Scene all = scene_of(kVertexCount, kFaceCount);
    measure_views(all);
    measure_intervals(all);
    measure_pieces(all);
    measure_empty_rows(all);
    measure_inserts(all);
    measure_candidates(all);
  }
  fixrad::text::write_line("trials", static_cast<uint32_t>(kTrials));
  return 0;
}
