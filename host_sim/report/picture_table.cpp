// SPDX-License-Identifier: MIT
#include "host_sim/report/picture_table.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "host_sim/io/model.h"
#include "host_sim/report/automatic_camera.h"
#include "host_sim/report/conforming_mesh.h"
#include "host_sim/report/mirrors.h"
#include "host_sim/report/tone.h"
#include "lib/picture/highlight.h"

namespace fixrad::host {
namespace {

constexpr double kUnitVector = 16384;  // Q14
constexpr double kLightOne = 1 << kLightBits;

template <class Integer>
Integer rounded(double value, double low, double high) {
  return static_cast<Integer>(std::llround(std::clamp(value, low, high)));
}

void store(const glm::dvec3& unit, std::int16_t (&to)[3]) {
  for (int k = 0; k < 3; ++k) {
    to[k] = rounded<std::int16_t>(kUnitVector * unit[k], -kUnitVector, kUnitVector);
  }
}

// A grey device looks at the first channel only.
double channel_of(const glm::dvec3& colour, int channel) {
  return colour[channel];
}

PictureCamera device_camera(const Camera& camera, bool z_up, const Grid& grid,
                            const PictureOptions& picture) {
  const Projection checked(camera, z_up, picture.width, picture.height);  // throws for what is no camera
  PictureCamera result = {};
  const ViewAxes axes = view_axes(glm::normalize(camera.target - camera.eye), z_up);
  const glm::dvec3 eye = (camera.eye - grid.origin) * grid.scale;
  for (int k = 0; k < 3; ++k) {
    if (eye[k] < kCameraLow || eye[k] > kCameraHigh) {
      throw InputError(
          "fixrad: error: the camera is too far away for the device's renderer; bring it nearer, to at most "
          "three times the size of the scene");
    }
    result.eye[k] = rounded<std::int32_t>(eye[k], kCameraLow, kCameraHigh);
  }
  store(axes.right, result.right);
  store(axes.up, result.up);
  store(axes.forward, result.forward);
  const double focal = 0.5 * picture.height / std::tan(glm::radians(camera.vertical_fov) / 2);
  result.focal = rounded<std::uint32_t>(256 * focal, 1, kMaxFocal - 1);
  result.width = static_cast<std::uint16_t>(picture.width);
  result.height = static_cast<std::uint16_t>(picture.height);
  return result;
}

// 32 bits of the factor from radiosity units to light.
Exposure device_exposure(double light_per_unit) {
  int exponent = 0;
  const double mantissa = std::frexp(light_per_unit, &exponent);  // 0.5 .. 1
  const int shift = std::clamp(32 - exponent, 0, 63);
  return {rounded<std::uint32_t>(std::ldexp(mantissa, exponent + shift), 0, 4294967295.0),
          static_cast<std::uint8_t>(shift)};
}

PictureMaterial device_material(const Appearance& appearance) {
  PictureMaterial material = {};
  for (int c = 0; c < kMaxChannels; ++c) {
    material.specular[c] = rounded<std::uint16_t>(65536 * appearance.specular[c], 0, 65535);
  }
  material.exponent = appearance.specular == glm::dvec3(0.0)
                          ? std::uint16_t{0}
                          : rounded<std::uint16_t>(appearance.exponent, 0, 1000);
  return material;
}

PictureLamp device_lamp(const BakedLamp& lamp, const Grid& grid, double scale, int channels) {
  PictureLamp result = {};
  const glm::dvec3 at = (lamp.position - grid.origin) * grid.scale * static_cast<double>(kEyeScale);
  for (int k = 0; k < 3; ++k) {
    result.at[k] = rounded<std::uint16_t>(at[k], 0, 65535);
  }
  store(lamp.normal, result.normal);
  result.area = rounded<std::uint32_t>(8 * lamp.area * grid.scale * grid.scale, 1, 4294967295.0);
  for (int c = 0; c < channels; ++c) {
    result.light[c] =
        rounded<std::uint32_t>(channel_of(lamp.radiosity, c) * scale * kLightOne, 0, 4294967295.0);
  }
  return result;
}

PictureMirror device_mirror(const MirrorPlane& plane, const Grid& grid) {
  PictureMirror mirror = {};
  store(plane.normal, mirror.normal);
  const double offset = (plane.offset - glm::dot(plane.normal, grid.origin)) * grid.scale;
  mirror.offset = rounded<std::int32_t>(kUnitVector * offset, -5e8, 5e8);
  mirror.material = static_cast<std::uint8_t>(plane.appearance);
  return mirror;
}

void require_count(std::size_t count, std::size_t most, const char* what) {
  if (count > most) {
    throw InputError("fixrad: error: the picture has " + std::to_string(count) + " " + what +
                     ", the device's renderer takes " + std::to_string(most) + "; use fewer elements");
  }
}

void add_surface(const BakedMesh& mesh, const Mirrors& mirrors, const Grid& grid, PictureTable& table) {
  const ConformingMesh conforming = make_conforming(mesh, grid);
  require_count(conforming.positions.size(), 65535, "vertices");
  require_count(conforming.triangles.size(), 65535, "triangles");
  for (const glm::ivec3& p : conforming.positions) {
    table.vertices.push_back(
        {static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y), static_cast<std::int16_t>(p.z)});
  }
  for (const InsertedPoint& p : conforming.inserted) {
    table.side_points.push_back({static_cast<std::uint16_t>(p.from), static_cast<std::uint16_t>(p.to),
                                 rounded<std::uint16_t>(65536 * p.part, 0, 65535)});
  }
  for (std::size_t t = 0; t < conforming.triangles.size(); ++t) {
    const auto& [a, b, c] = conforming.triangles[t];
    const std::uint32_t source = conforming.source[t];
    const std::uint32_t mirror = mirrors.of_triangle[source];
    table.triangles.push_back(
        {{static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(c)},
         mesh.appearances.empty() ? std::uint8_t{0}
                                  : static_cast<std::uint8_t>(mesh.triangle_appearance[source]),
         mirror == Mirrors::kNone ? kNoMirror : static_cast<std::uint8_t>(mirror)});
  }
  for (std::size_t v = 0; v < conforming.positions.size(); ++v) {
    const std::size_t of = v < mesh.normals.size() ? v : conforming.inserted[v - mesh.normals.size()].from;
    std::int16_t normal[3];
    store(mesh.normals[of], normal);
    table.normals.insert(table.normals.end(), normal, normal + 3);
  }
}

}  // namespace

PictureScene PictureTable::view() const {
  PictureScene scene = {};
  scene.vertices = vertices.data();
  scene.side_points = side_points.data();
  scene.normals = normals.empty() ? nullptr : normals.data();
  scene.triangles = triangles.data();
  scene.materials = materials.data();
  scene.mirrors = mirrors.data();
  scene.lamps = lamps.data();
  scene.vertex_count = static_cast<std::uint16_t>(vertices.size());
  scene.side_point_count = static_cast<std::uint16_t>(side_points.size());
  scene.triangle_count = static_cast<std::uint16_t>(triangles.size());
  scene.material_count = static_cast<std::uint8_t>(materials.size());
  scene.mirror_count = static_cast<std::uint8_t>(mirrors.size());
  scene.lamp_count = static_cast<std::uint8_t>(lamps.size());
  scene.highlights = lamps.empty() ? nullptr : add_highlights;
  scene.channels = static_cast<std::uint8_t>(channels);
  scene.background = rounded<std::uint16_t>(kBackground * kLightOne, 0, kLightMax);
  return scene;
}

PictureTable make_picture_table(const BakedMesh& mesh, const DeviceUnits& units, const Display& display,
                                const PictureOptions& picture) {
  PictureTable table;
  table.channels = units.channels;
  const double aspect = static_cast<double>(picture.width) / picture.height;
  const Camera camera = picture.camera ? *picture.camera : automatic_camera(mesh, display.z_up, aspect);
  table.camera = device_camera(camera, display.z_up, units.grid, picture);
  const double scale = exposure_scale(mesh, display);
  table.exposure = device_exposure(scale * units.radiosity * kLightOne);
  const Mirrors mirrors = find_mirrors(mesh);
  require_count(mesh.appearances.size(), 255, "materials");
  require_count(mirrors.planes.size(), 255, "mirrors");
  require_count(mesh.lamps.size(), 255, "lamps");
  add_surface(mesh, mirrors, units.grid, table);
  bool is_shiny = false;
  for (const Appearance& appearance : mesh.appearances) {
    table.materials.push_back(device_material(appearance));
    is_shiny = is_shiny || table.materials.back().exponent != 0;
  }
  if (mesh.appearances.empty()) {
    table.materials.push_back({});
  }
  for (const MirrorPlane& plane : mirrors.planes) {
    table.mirrors.push_back(device_mirror(plane, units.grid));
  }
  if (is_shiny) {
    for (const BakedLamp& lamp : mesh.lamps) {
      table.lamps.push_back(device_lamp(lamp, units.grid, scale, units.channels));
    }
  } else {
    table.normals.clear();
  }
  return table;
}

std::vector<std::uint16_t> exposed_light(const BakedMesh& mesh, const DeviceUnits& units,
                                         const PictureTable& table) {
  std::vector<std::uint16_t> light;
  for (const glm::dvec3& radiosity : mesh.radiosity) {
    for (int c = 0; c < units.channels; ++c) {
      const auto raw = rounded<std::uint32_t>(channel_of(radiosity, c) / units.radiosity, 0, 4294967295.0);
      light.push_back(expose(table.exposure, Radiosity::from_raw(raw)));
    }
  }
  return light;
}

Image draw_on_device(const PictureTable& table, const std::vector<std::uint16_t>& light, int band_rows) {
  struct Source {
    const std::uint16_t* light;
    int channels;
  };
  Source source = {light.data(), table.channels};
  const LightSource from_array = {&source, [](void* context, std::uint16_t vertex, std::uint16_t* to) {
                                    const Source& s = *static_cast<const Source*>(context);
                                    std::copy_n(s.light + std::ptrdiff_t{vertex} * s.channels, s.channels,
                                                to);
                                  }};
  struct Sink {
    Image image;
    int channels;
  };
  Sink sink = {{table.camera.width, table.camera.height, {}}, table.channels};
  const PictureRows rows = {&sink, [](void* context, std::uint16_t, const std::uint8_t* pixels) {
                              Sink& s = *static_cast<Sink*>(context);
                              for (int i = 0; i < 3 * s.image.width; ++i) {
                                s.image.rgb.push_back(pixels[s.channels == 1 ? i / 3 : i]);
                              }
                            }};
  const std::size_t pixels =
      static_cast<std::size_t>(table.camera.width) * static_cast<std::size_t>(band_rows);
  std::vector<std::uint16_t> depth(pixels), colours(pixels * static_cast<std::size_t>(table.channels));
  const PictureBand band = {depth.data(), colours.data(), static_cast<std::uint16_t>(band_rows)};
  const PictureStatus status = draw_picture(table.view(), table.camera, from_array, band, rows);
  if (status != PictureStatus::ok) {
    throw InputError("fixrad: error: the device's renderer refuses the picture (status " +
                     std::to_string(static_cast<int>(status)) + "); choose another size or camera");
  }
  return std::move(sink.image);
}

std::uint64_t picture_digest(const Image& image, int channels) {
  std::uint64_t hash = 14695981039346656037u;
  for (std::size_t i = 0; i < image.rgb.size(); i += channels == 1 ? 3 : 1) {
    hash = (hash ^ image.rgb[i]) * 1099511628211u;
  }
  return hash;
}

}  // namespace fixrad::host
