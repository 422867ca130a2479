// SPDX-License-Identifier: MIT
#include "host_sim/cli/error_view.h"

#include <algorithm>

#include "host_sim/io/model.h"
#include "host_sim/report/automatic_camera.h"
#include "host_sim/report/legend.h"

namespace fixrad::host {
namespace {

constexpr double kDark = 0.1;
constexpr double kScalePart = 0.95;  // of the samples lie within the scale

}  // namespace

double dark_floor(const BakedMesh& mesh) {
  double light = 0, area = 0;
  for (const BakedElement& element : mesh.elements) {
    if (!element.lamp) {
      light += element.area * channel_sum(element.radiosity);
      area += element.area;
    }
  }
  return area > 0 && light > 0 ? kDark * light / area : 1.0;
}

std::vector<ErrorPolygon> face_error_polygons(const LoadedScene& scene, const Truth& truth,
                                              const BakeResult& result, double floor) {
  const std::vector<glm::dvec3> means =
      face_means(scene.model, result.device.overlaps, result.element_radiosity);
  std::vector<ErrorPolygon> polygons;
  for (const MeshElement& element : result.device.mesh.elements) {
    const double right = channel_sum(truth.means[element.input_face]);
    polygons.push_back(
        {element.polygon, (channel_sum(means[element.input_face]) - right) / std::max(right, floor)});
  }
  return polygons;
}

Image error_picture(const CommonOptions& options, const LoadedScene& scene, const Truth& truth,
                    const BakeResult& result, const BakedMesh& mesh) {
  PictureOptions picture = options.picture.options();
  if (picture.height <= kLegendHeight) {
    throw InputError("fixrad: error: --show error needs a --size higher than its scale, " +
                     std::to_string(kLegendHeight) + " pixels");
  }
  picture.height -= kLegendHeight;
  const bool z_up = options.display.z_up;
  if (!picture.camera) {
    picture.camera = automatic_camera(mesh, z_up, static_cast<double>(picture.width) / picture.height);
  }
  const ErrorMap map =
      polygon_errors(face_error_polygons(scene, truth, result, dark_floor(mesh)), z_up, picture);
  const double limit = nice_limit(error_quantile(map, kScalePart));
  return with_legend(false_colours(map, limit), limit);
}

}  // namespace fixrad::host
