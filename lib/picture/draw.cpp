// SPDX-License-Identifier: MIT
#include "lib/picture/draw.h"

#include "lib/picture/band_painter.h"
#include "lib/picture/tone.h"

namespace fixrad {
namespace {

void draw_mirrors(const PictureScene& scene, const Projection& camera, BandPainter& painter) {
  if (scene.mirror_count == 0) {
    return;
  }
  painter.close_all_but_mirrors();
  for (uint8_t m = 0; m < scene.mirror_count; ++m) {
    Projection reflected;
    painter.draw(camera, Pass::open, m);
    if (painter.take_opened() > 0 && mirrored(camera, flash_read(scene.mirrors, m), reflected)) {
      painter.draw(reflected, Pass::reflection, m);
    }
    painter.draw(camera, Pass::surface, m);
  }
}

// Not inlined: what it keeps on the stack is not to lie under the drawing of triangles. The display colours
// of a row take the place of its light, which needs more memory.
__attribute__((noinline)) void hand_over(const PictureScene& scene, const PictureBand& band, uint16_t width,
                                         int32_t first_row, int32_t end_row, const PictureRows& rows) {
  const uint32_t row_length = static_cast<uint32_t>(width) * scene.channels;
  for (int32_t y = first_row; y < end_row; ++y) {
    uint16_t* light = band.light + static_cast<uint32_t>(y - first_row) * row_length;
    uint8_t* pixels = reinterpret_cast<uint8_t*>(light);
    for (uint32_t i = 0; i < row_length; i += scene.channels) {
      display_pixel(light + i, scene.channels, pixels + i);
    }
    rows.take(rows.context, static_cast<uint16_t>(y), pixels);
  }
}

}  // namespace

PictureStatus draw_picture(const PictureScene& scene, const PictureCamera& camera, const LightSource& light,
                           const PictureBand& band, const PictureRows& rows) {
  const PictureStatus status = check_picture(scene, camera, band);
  if (status != PictureStatus::ok) {
    return status;
  }
  const Projection projection = projection_of(camera);
  for (int32_t first = 0; first < camera.height; first += band.rows) {
    const int32_t end = first + band.rows < camera.height ? first + band.rows : camera.height;
    BandPainter painter(scene, light, band, first, end, camera.width);
    painter.clear();
    painter.draw(projection, Pass::scene, kNoMirror);
    draw_mirrors(scene, projection, painter);
    hand_over(scene, band, camera.width, first, end, rows);
  }
  return PictureStatus::ok;
}

}  // namespace fixrad
