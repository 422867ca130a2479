// SPDX-License-Identifier: MIT
// Solves the scene FIXRAD_SCENE, compiled into flash, draws the picture that its header describes, band by
// band with FIXRAD_PICTURE_ROWS rows of memory, and compares a digest of the pixels with the host's. Exit
// code 0 if they agree and the stack kept to its place.

#include <stdint.h>

#include FIXRAD_SCENE_HEADER
#include "firmware/apps/report.h"
#include "firmware/apps/text.h"

#define FIXRAD_TEXT_OF(name) #name
#define FIXRAD_TEXT(name) FIXRAD_TEXT_OF(name)

namespace baked = FIXRAD_SCENE;

namespace {

baked::Solver solver;

// The colours of one row, and what the band needs beside.
constexpr uint32_t kPixels = static_cast<uint32_t>(FIXRAD_PICTURE_WIDTH) * FIXRAD_PICTURE_ROWS;
uint16_t depth[kPixels];
uint16_t light[kPixels * baked::Limits::channels];

struct Vertices {
  fixrad::VertexMap map;
  fixrad::Exposure exposure;
};

void read_vertex(void* context, uint16_t vertex, uint16_t* to) {
  const Vertices& vertices = *static_cast<const Vertices*>(context);
  for (int c = 0; c < baked::Limits::channels; ++c) {
    to[c] = fixrad::expose(vertices.exposure, solver.vertex_radiosity(vertices.map, vertex, c));
  }
}

struct Digest {
  uint64_t value;
  uint32_t row_length;
};

void take_row(void* context, uint16_t, const uint8_t* pixels) {
  Digest& digest = *static_cast<Digest*>(context);
  for (uint32_t i = 0; i < digest.row_length; ++i) {
    digest.value = (digest.value ^ pixels[i]) * 1099511628211u;
  }
}

fixrad::PictureStatus draw(Digest& digest) {
  const fixrad::PictureCamera camera = baked::picture_camera();
  if (camera.width > FIXRAD_PICTURE_WIDTH) {
    return fixrad::PictureStatus::no_memory;
  }
  Vertices vertices = {baked::vertex_map(), baked::picture_exposure()};
  digest = {14695981039346656037u, static_cast<uint32_t>(camera.width) * baked::Limits::channels};
  return fixrad::draw_picture(baked::picture(), camera, {&vertices, read_vertex},
                              {depth, light, FIXRAD_PICTURE_ROWS}, {&digest, take_row});
}

}  // namespace

int main() {
  fixrad::text::write_line("scene", FIXRAD_TEXT(FIXRAD_SCENE));
  fixrad::Status status = solver.load(baked::scene(), baked::settings());
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  Digest digest = {0, 0};
  const fixrad::PictureStatus drawn = draw(digest);
  fixrad::text::write_line("picture_bytes", static_cast<uint32_t>(sizeof depth + sizeof light));
  fixrad::text::write("picture_digest ");
  fixrad::text::write_hex(digest.value);
  fixrad::text::write("\n");
  const bool stack_fits = fixrad::report::write_stack();
  const bool is_equal = status == fixrad::Status::converged && drawn == fixrad::PictureStatus::ok &&
                        digest.value == baked::expected::kPictureDigest;
  fixrad::text::write(is_equal ? "picture equal\n" : "picture differs\n");
  return is_equal && stack_fits ? 0 : 1;
}
