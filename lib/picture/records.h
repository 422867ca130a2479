// SPDX-License-Identifier: MIT
// What a picture is drawn from: tables in flash, made by the host tool, and the memory to draw in.
#pragma once

#include <stdint.h>

#include "lib/fixed/flash.h"
#include "lib/scene/scene.h"

namespace fixrad {

/// Light as a picture holds it: radiosity times exposure, UQ4.12. A value of 12 is displayed as white, so
/// what saturates at 16 looks the same.
constexpr int kLightBits = 12;
constexpr uint32_t kLightMax = 0xffff;

/// Where a camera may stand, grid units: up to three times the scene's extent away, so that the offset of a
/// vertex from the eye has 16 bits and a sign (docs/numbers.md).
constexpr int32_t kCameraLow = -49152, kCameraHigh = 65535;

constexpr uint16_t kMaxPictureSide = 2048;  ///< pixels
constexpr uint32_t kMaxFocal = 1ul << 21;   ///< PictureCamera::focal is below
constexpr uint8_t kNoMirror = 0xff;         ///< PictureTriangle::mirror

/// A pinhole camera in the middle of its picture.
struct PictureCamera {
  int32_t eye[3];                       ///< grid units, kCameraLow .. kCameraHigh
  int16_t right[3], up[3], forward[3];  ///< orthonormal, Q14, of length at most 16,391
  uint32_t focal;                       ///< distance of the picture plane: UQ13.8 pixels, > 0
  uint16_t width, height;               ///< pixels, 1 .. kMaxPictureSide
};

/// A triangle of the displayed mesh, counter-clockwise seen from the lit side.
struct PictureTriangle {
  uint16_t corner[3];  ///< into the vertices
  uint8_t material;    ///< into PictureScene::materials
  uint8_t mirror;      ///< into PictureScene::mirrors, or kNoMirror
};

/// A vertex that has no light of its own: it lies on a side between two that have, where another surface has
/// a vertex, so that both are drawn with the same corners.
struct SidePoint {
  uint16_t from, to;  ///< vertices with light
  uint16_t part;      ///< UQ0.16 of the way from the first to the second
};

/// What a material shows beside diffuse light. Transport knows nothing of it.
struct PictureMaterial {
  uint16_t specular[kMaxChannels];  ///< UQ0.16: of highlights, or of the mirror image
  uint16_t exponent;                ///< of Phong's lobe, 1 .. 1000; 0: no highlights
};

/// The plane of a flat mirror: the points p with normal . p = offset.
struct PictureMirror {
  int16_t normal[3];  ///< Q14, towards the lit side
  int32_t offset;     ///< Q14 grid units
  uint8_t material;   ///< into PictureScene::materials
};

/// A lamp as highlights see it: a Lambertian point light.
struct PictureLamp {
  uint16_t at[3];                ///< quarters of a grid unit
  int16_t normal[3];             ///< Q14, towards the lit side
  uint32_t area;                 ///< UQ29.3 square grid units
  uint32_t light[kMaxChannels];  ///< UQ20.12: emitted radiosity times exposure
};

struct PictureScene;

/// Adds to `light` what a shiny material shows of the lamps: add_highlights(). A pointer, so that a program
/// without shiny materials has no code for them.
using Highlights = void (*)(const PictureScene& scene, const PictureMaterial& material, const Vec3& at,
                            const Vec3& normal, const Vec3& eye, uint16_t* light);

/// Everything about a picture that its maker knows: tables in flash, owned by the caller.
struct PictureScene {
  const FIXRAD_FLASH Vertex* vertices;        ///< [vertex_count] grid units
  const FIXRAD_FLASH SidePoint* side_points;  ///< [side_point_count], of the last vertices
  const FIXRAD_FLASH int16_t* normals;        ///< [vertex_count][3] Q14, or null without highlights
  const FIXRAD_FLASH PictureTriangle* triangles;
  const FIXRAD_FLASH PictureMaterial* materials;
  const FIXRAD_FLASH PictureMirror* mirrors;
  const FIXRAD_FLASH PictureLamp* lamps;
  uint16_t vertex_count, side_point_count, triangle_count;
  uint8_t material_count, mirror_count, lamp_count;
  Highlights highlights;  ///< null: none
  uint8_t channels;       ///< 1 or 3
  uint16_t background;    ///< light where nothing is seen, every channel
};

/// Where the light of a vertex comes from: a solver, an array or a table. Writes `light` [channels] of one of
/// the vertices with light of their own.
struct LightSource {
  void* context;
  void (*read)(void* context, uint16_t vertex, uint16_t* light);
};

/// Memory for some rows of a picture, the caller's: width * rows * 2 * (1 + channels) bytes. A picture is
/// drawn band by band; more rows take less time, since each band looks at every triangle.
struct PictureBand {
  uint16_t* depth;  ///< [width * rows]
  uint16_t* light;  ///< [width * rows * channels]
  uint16_t rows;    ///< >= 1
};

/// Takes a finished row, from the top: `channels` sRGB bytes a pixel, valid during the call.
struct PictureRows {
  void* context;
  void (*take)(void* context, uint16_t y, const uint8_t* pixels);
};

/// Outcome of drawing.
enum class PictureStatus : uint8_t {
  ok,
  bad_index,          ///< a record points outside its table
  bad_camera,         ///< its eye, focal length or size is out of range
  bad_channel_count,  ///< neither 1 nor 3
  no_memory,          ///< a band without rows
};

}  // namespace fixrad
