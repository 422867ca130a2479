// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/cli/session.h"
#include "host_sim/report/picture.h"

namespace fixrad::host {

/// The picture that --show, --camera, --size and --renderer ask for. Throws InputError where they do not go
/// together. `error` traces the truth first.
Image make_picture(const CommonOptions& options, const LoadedScene& scene, const BakeResult& result,
                   const BakedMesh& mesh);

/// Vertex colours of `mesh` by the renderer that is chosen.
Image draw_vertices(const CommonOptions& options, const BakeResult& result, const BakedMesh& mesh,
                    const Display& display);

}  // namespace fixrad::host
