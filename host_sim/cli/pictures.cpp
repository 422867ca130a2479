// SPDX-License-Identifier: MIT
#include "host_sim/cli/pictures.h"

#include "host_sim/cli/error_view.h"
#include "host_sim/report/mesh_picture.h"
#include "host_sim/report/picture_table.h"
#include "host_sim/sweep/truth.h"

namespace fixrad::host {
namespace {

Image draw_by_device(const CommonOptions& options, const BakeResult& result, const BakedMesh& mesh,
                     const Display& display) {
  if (options.picture.width > kMaxPictureSide || options.picture.height > kMaxPictureSide) {
    throw InputError("fixrad: error: --renderer device draws at most " + std::to_string(kMaxPictureSide) +
                     " pixels a side; choose a smaller --size");
  }
  const DeviceUnits units = {result.device.grid, result.device.unit_radiosity, result.device.channels};
  const PictureTable table = make_picture_table(mesh, units, display, options.picture.options());
  return draw_on_device(table, exposed_light(mesh, units, table));
}

}  // namespace

Image draw_vertices(const CommonOptions& options, const BakeResult& result, const BakedMesh& mesh,
                    const Display& display) {
  return options.picture.renderer == "device" ? draw_by_device(options, result, mesh, display)
                                              : render_picture(mesh, display, options.picture.options());
}

Image make_picture(const CommonOptions& options, const LoadedScene& scene, const BakeResult& result,
                   const BakedMesh& mesh) {
  const std::string& show = options.picture.show;
  if (show == "vertex") {
    return draw_vertices(options, result, mesh, options.display);
  }
  if (show == "radiosity") {
    return draw_vertices(options, result, flat_mesh(mesh, result.device.mesh), options.display);
  }
  if (show == "mesh") {
    return render_mesh_picture(mesh, result.device.mesh, options.display, options.picture.options());
  }
  say(options, "tracing the truth");
  exit_on_interrupt();
  const Truth truth = trace_truth(scene.prepared);
  catch_interrupt();
  return error_picture(options, scene, truth, result, mesh);
}

}  // namespace fixrad::host
