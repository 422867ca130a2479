// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/report/picture_table.h"
#include "tests/report/sample_mesh.h"

namespace fixrad::host::testing {

/// A grid over the cube from `low` with sides of `side`, as quantise() lays it.
inline DeviceUnits units_over(const glm::dvec3& low, double side) {
  DeviceUnits units;
  units.grid.scale = 16367 / side;
  units.grid.origin = low - 8.0 / units.grid.scale;
  units.radiosity = 1e-6;
  return units;
}

/// The mesh as the core draws it.
inline Image device_picture(const BakedMesh& mesh, const DeviceUnits& units, const PictureOptions& picture,
                            int band_rows = 16) {
  const PictureTable table = make_picture_table(mesh, units, {}, picture);
  return draw_on_device(table, exposed_light(mesh, units, table), band_rows);
}

/// Red, green, blue of a pixel.
inline std::array<int, 3> pixel_of(const Image& image, int x, int y) {
  const auto at = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

}  // namespace fixrad::host::testing
