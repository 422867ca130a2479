// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host_sim/cli/session.h"
#include "host_sim/report/error_map.h"
#include "host_sim/sweep/truth.h"

namespace fixrad::host {

/// Radiosity below which errors are relative to it instead of to the truth: a tenth of the mean over what is
/// lit and no lamp, sum of the channels, W/m^2.
double dark_floor(const BakedMesh& mesh);

/// The relative error of the mean of each element's input face against the truth, an element each.
std::vector<ErrorPolygon> face_error_polygons(const LoadedScene& scene, const Truth& truth,
                                              const BakeResult& result, double floor);

/// Those errors in false colours above their scale, which ends at a round number that most of the picture
/// does not exceed.
Image error_picture(const CommonOptions& options, const LoadedScene& scene, const Truth& truth,
                    const BakeResult& result, const BakedMesh& mesh);

}  // namespace fixrad::host
