// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/clip.h"
#include "lib/picture/shading.h"

namespace fixrad {

/// What is done with the pixels of a triangle. A pixel's depth word is its depth; with kMirrorBit the nearest
/// surface is a mirror's; while a mirror's image is drawn, 0 is a pixel that is not its own.
enum class Pass : uint8_t {
  scene,       ///< draw what is nearer
  open,        ///< of a mirror: make its visible pixels empty
  reflection,  ///< draw what is nearer into empty pixels, weakened
  surface      ///< of a mirror: add its own light and close the pixel
};
constexpr uint16_t kMirrorBit = 0x8000;

/// Draws into a band of rows.
class BandPainter {
 public:
  BandPainter(const PictureScene& scene, const LightSource& light, const PictureBand& band, int32_t first_row,
              int32_t end_row, uint16_t width);

  /// Everything in the band becomes background.
  void clear();
  /// Draws all triangles; `mirror`: the one whose image or surface is drawn.
  void draw(const Projection& projection, Pass pass, uint8_t mirror);
  /// Only pixels of mirrors stay open to what follows.
  void close_all_but_mirrors();
  /// Number of pixels that Pass::open has emptied since the last call.
  uint32_t take_opened();

 private:
  struct Look {  // of a triangle
    PictureMaterial material;
    bool is_mirror;
  };
  bool load(const Projection& projection, const PictureTriangle& triangle, ViewPolygon& polygon) const;
  bool keep_before_mirror(const PictureTriangle& triangle, ViewPolygon& polygon) const;
  void fetch(const PictureTriangle& triangle, bool with_normals, ViewPolygon& polygon) const;
  void read_light(uint16_t vertex, uint16_t* light) const;
  bool misses_band(const Projection& projection, const ViewPolygon& polygon) const;
  void draw_polygon(const Projection& projection, const ViewPolygon& polygon, const Look& look);
  void draw_triangle(const Projection& projection, const ViewCorner* const* corners,
                     const ScreenCorner* screen, const Look& look);
  void own_light(const Projection& projection, const ViewCorner* const* corners, const SurfacePoint& point,
                 const Look& look, uint16_t* own) const;
  bool claims(uint16_t& stored, uint16_t depth, const Look& look);
  void light_pixel(uint32_t pixel, const uint16_t* own);

  const PictureScene& scene_;
  const LightSource& source_;
  const PictureBand& band_;
  int32_t first_row_, end_row_;
  uint16_t width_;
  Pass pass_ = Pass::scene;
  uint8_t mirror_ = kNoMirror;
  PictureMirror plane_ = {};  // of mirror_
  PictureMaterial mirror_material_ = {};
  uint32_t opened_ = 0;
};

}  // namespace fixrad
