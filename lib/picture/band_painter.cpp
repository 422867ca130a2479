// SPDX-License-Identifier: MIT
#include "lib/picture/band_painter.h"

#include "lib/picture/coverage.h"

namespace fixrad {
namespace {

// A face this far over a mirror's plane lies in it: grid units.
constexpr int32_t kInPlane = 2;

uint16_t saturated(uint32_t light) {
  return static_cast<uint16_t>(saturate(light, Place::light_of_picture, kLightMax));
}

uint16_t part_of(uint16_t specular, uint16_t light) {
  return static_cast<uint16_t>(static_cast<uint32_t>(specular) * light >> 16);
}

}  // namespace

BandPainter::BandPainter(const PictureScene& scene, const LightSource& light, const PictureBand& band,
                         int32_t first_row, int32_t end_row, uint16_t width)
    : scene_(scene), source_(light), band_(band), first_row_(first_row), end_row_(end_row), width_(width) {}

void BandPainter::clear() {
  const uint32_t pixels = static_cast<uint32_t>(end_row_ - first_row_) * width_;
  for (uint32_t i = 0; i < pixels; ++i) {
    band_.depth[i] = kFarthest;
  }
  for (uint32_t i = 0; i < pixels * scene_.channels; ++i) {
    band_.light[i] = scene_.background;
  }
}

void BandPainter::close_all_but_mirrors() {
  const uint32_t pixels = static_cast<uint32_t>(end_row_ - first_row_) * width_;
  for (uint32_t i = 0; i < pixels; ++i) {
    if ((band_.depth[i] & kMirrorBit) == 0) {
      band_.depth[i] = 0;
    }
  }
}

uint32_t BandPainter::take_opened() {
  const uint32_t opened = opened_;
  opened_ = 0;
  return opened;
}

// Not inlined, or the polygon would be on the stack once for each pass.
__attribute__((noinline)) void BandPainter::draw(const Projection& projection, Pass pass, uint8_t mirror) {
  pass_ = pass;
  mirror_ = mirror;
  if (mirror != kNoMirror) {
    plane_ = flash_read(scene_.mirrors, mirror);
    mirror_material_ = flash_read(scene_.materials, plane_.material);
  }
  const bool is_of_mirror = pass == Pass::open || pass == Pass::surface;
  for (uint16_t i = 0; i < scene_.triangle_count; ++i) {
    const PictureTriangle triangle = flash_read(scene_.triangles, i);
    if ((is_of_mirror && triangle.mirror != mirror) ||
        (pass == Pass::reflection && triangle.mirror == mirror)) {
      continue;
    }
    ViewPolygon polygon;
    if (load(projection, triangle, polygon)) {
      Look look = {flash_read(scene_.materials, triangle.material), triangle.mirror != kNoMirror};
      look.material.exponent = look.is_mirror ? 0 : look.material.exponent;
      draw_polygon(projection, polygon, look);
    }
  }
}

bool BandPainter::load(const Projection& projection, const PictureTriangle& triangle,
                       ViewPolygon& polygon) const {
  polygon.count = 3;
  for (int i = 0; i < 3; ++i) {
    polygon.corner[i].at = to_view(projection, vec(flash_read(scene_.vertices, triangle.corner[i])));
  }
  if (misses_band(projection, polygon)) {
    return false;
  }
  fetch(triangle, flash_read(scene_.materials, triangle.material).exponent != 0, polygon);
  return (pass_ != Pass::reflection || keep_before_mirror(triangle, polygon)) &&
         clip_to_view(projection, polygon);
}

bool BandPainter::misses_band(const Projection& projection, const ViewPolygon& polygon) const {
  int32_t low = 0x7fffffff, high = -0x7fffffff;
  for (uint8_t i = 0; i < polygon.count; ++i) {
    const Vec3 at = polygon.corner[i].at;
    const uint64_t limit = static_cast<uint64_t>(at.z > 0 ? at.z : 0) * projection.guard_y;
    if (at.z < kNearest || magnitude(at.y) > (limit >> 12)) {
      return false;  // it is to be cut first
    }
    const int32_t y = to_screen(projection, at).y;
    low = y < low ? y : low;
    high = y > high ? y : high;
  }
  return floor_shift(high, kPixelBits) < first_row_ || floor_shift(low, kPixelBits) > end_row_;
}

void BandPainter::fetch(const PictureTriangle& triangle, bool with_normals, ViewPolygon& polygon) const {
  for (int i = 0; i < 3; ++i) {
    ViewCorner& corner = polygon.corner[i];
    read_light(triangle.corner[i], corner.light);
    for (unsigned k = 0; k < 3; ++k) {
      corner.normal[k] = with_normals ? flash_read(scene_.normals, 3u * triangle.corner[i] + k) : int16_t{0};
    }
  }
}

void BandPainter::read_light(uint16_t vertex, uint16_t* light) const {
  for (int c = 0; c < kMaxChannels; ++c) {
    light[c] = 0;
  }
  const uint16_t lit = static_cast<uint16_t>(scene_.vertex_count - scene_.side_point_count);
  if (vertex < lit) {
    source_.read(source_.context, vertex, light);
    return;
  }
  const SidePoint point = flash_read(scene_.side_points, static_cast<unsigned>(vertex - lit));
  uint16_t end[kMaxChannels] = {0, 0, 0};
  source_.read(source_.context, point.from, light);
  source_.read(source_.context, point.to, end);
  for (uint8_t c = 0; c < scene_.channels; ++c) {
    const uint32_t rest = 0x10000ul - point.part;
    const uint32_t sum = rest * light[c] + static_cast<uint32_t>(point.part) * end[c];
    light[c] = static_cast<uint16_t>(sum >> 16);
  }
}

bool BandPainter::keep_before_mirror(const PictureTriangle& triangle, ViewPolygon& polygon) const {
  int32_t height[3];
  bool is_before = false, is_cut = false;
  for (int i = 0; i < 3; ++i) {
    height[i] = height_over(plane_, vec(flash_read(scene_.vertices, triangle.corner[i])));
    is_before = is_before || height[i] > kInPlane * kUnit;
    is_cut = is_cut || height[i] < 0;
  }
  if (is_before && is_cut) {
    clip(polygon, height);
  }
  return is_before;
}

// As a fan round the first corner; fronts run anticlockwise, seen in a mirror clockwise.
void BandPainter::draw_polygon(const Projection& projection, const ViewPolygon& polygon, const Look& look) {
  ScreenCorner screen[3];
  screen[0] = to_screen(projection, polygon.corner[0].at);
  screen[1] = to_screen(projection, polygon.corner[1].at);
  for (uint8_t i = 2; i < polygon.count; ++i) {
    const ViewCorner* corners[3] = {&polygon.corner[0], &polygon.corner[i - 1], &polygon.corner[i]};
    screen[2] = to_screen(projection, polygon.corner[i].at);
    const ScreenCorner next = screen[2];
    if (!projection.is_mirrored) {
      screen[2] = screen[1];
      screen[1] = next;
      corners[1] = &polygon.corner[i];
      corners[2] = &polygon.corner[i - 1];
    }
    draw_triangle(projection, corners, screen, look);
    screen[1] = next;
  }
}

void BandPainter::draw_triangle(const Projection& projection, const ViewCorner* const* corners,
                                const ScreenCorner* screen, const Look& look) {
  const int64_t area = screen_area(screen[0], screen[1], screen[2]);
  if (area <= 0) {
    return;
  }
  TriangleShading shading(screen[0], screen[1], screen[2], area);
  const Coverage coverage(screen[0], screen[1], screen[2]);
  coverage.rows(first_row_, end_row_, width_, [&](int32_t y, int32_t from, int32_t to) {
    shading.start(from, y);
    uint32_t pixel = static_cast<uint32_t>(y - first_row_) * width_ + static_cast<uint32_t>(from);
    for (int32_t x = from; x < to; ++x, ++pixel, shading.step()) {
      const SurfacePoint point = shading.point();
      if (claims(band_.depth[pixel], point.depth, look)) {
        uint16_t own[kMaxChannels];
        own_light(projection, corners, point, look, own);
        light_pixel(pixel, own);
      }
    }
  });
}

void BandPainter::own_light(const Projection& projection, const ViewCorner* const* corners,
                            const SurfacePoint& point, const Look& look, uint16_t* own) const {
  const ViewCorner &a = *corners[0], &b = *corners[1], &c = *corners[2];
  for (uint8_t k = 0; k < scene_.channels; ++k) {
    own[k] = pass_ == Pass::open
                 ? scene_.background
                 : static_cast<uint16_t>(interpolate(point, a.light[k], b.light[k], c.light[k]));
  }
  if (look.material.exponent == 0 || pass_ == Pass::open || scene_.highlights == nullptr) {
    return;
  }
  const Vec3 view = {interpolate_wide(point, a.at.x, b.at.x, c.at.x),
                     interpolate_wide(point, a.at.y, b.at.y, c.at.y),
                     interpolate_wide(point, a.at.z, b.at.z, c.at.z)};
  const Vec3 normal = {interpolate(point, a.normal[0], b.normal[0], c.normal[0]),
                       interpolate(point, a.normal[1], b.normal[1], c.normal[1]),
                       interpolate(point, a.normal[2], b.normal[2], c.normal[2])};
  scene_.highlights(scene_, look.material, to_grid(projection, view), normal, projection.eye, own);
}

bool BandPainter::claims(uint16_t& stored, uint16_t depth, const Look& look) {
  switch (pass_) {
    case Pass::scene:
      if (depth >= (stored & ~kMirrorBit)) {
        return false;
      }
      stored = static_cast<uint16_t>(depth | (look.is_mirror ? kMirrorBit : 0u));
      return true;
    case Pass::open:
      if (stored != (depth | kMirrorBit)) {
        return false;
      }
      stored = kFarthest;
      ++opened_;
      return true;
    case Pass::reflection:
      if (stored >= kMirrorBit || depth >= stored) {
        return false;
      }
      stored = depth;
      return true;
    case Pass::surface:
      break;
  }
  if (stored >= kMirrorBit || stored == 0) {
    return false;
  }
  stored = 0;
  return true;
}

void BandPainter::light_pixel(uint32_t pixel, const uint16_t* own) {
  uint16_t* light = band_.light + pixel * scene_.channels;
  for (uint8_t c = 0; c < scene_.channels; ++c) {
    switch (pass_) {
      case Pass::open:
      case Pass::reflection:
        light[c] = part_of(mirror_material_.specular[c], own[c]);
        break;
      case Pass::surface:
        light[c] = saturated(static_cast<uint32_t>(light[c]) + own[c]);
        break;
      case Pass::scene:
        light[c] = own[c];
    }
  }
}

}  // namespace fixrad
