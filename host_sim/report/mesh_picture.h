// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/meshing/element_mesh.h"
#include "host_sim/report/picture.h"

namespace fixrad::host {

/// The elements as flat polygons of their radiosity; exposure, cameras and lamps as for `mesh`, whose
/// elements these are. Shows diffuse light only.
BakedMesh flat_mesh(const BakedMesh& mesh, const ElementMesh& elements);

/// The picture of render_picture() with the borders of elements drawn over it, a pixel wide, anti-aliased,
/// and hidden where their elements are: dark on light surfaces, light on dark ones.
Image render_mesh_picture(const BakedMesh& mesh, const ElementMesh& elements, const Display& display,
                          const PictureOptions& options);

}  // namespace fixrad::host
