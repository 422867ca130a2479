// SPDX-License-Identifier: MIT
#pragma once

#include "lib/picture/records.h"

namespace fixrad {

/// Draws the displayed mesh as `camera` sees it and hands the rows to `rows`, from the top, band by band:
/// Gouraud shading of radiosity (which stands in place of the ambient term), interpolated in space, hidden
/// surfaces removed by depth, back faces left out. Materials that ask for it get highlights and mirror
/// images; in a mirror, mirrors show their diffuse light only. Nothing is taken unless the status is ok.
/// Cost: for each band 9 products and a 64-bit division a vertex of each triangle, about 20 products of 64
/// bits a triangle in the band, a 32-bit division a pixel; as much again for each mirror that the band sees.
[[nodiscard]] PictureStatus draw_picture(const PictureScene& scene, const PictureCamera& camera,
                                         const LightSource& light, const PictureBand& band,
                                         const PictureRows& rows);

/// Whether all indices of the scene are in range and the camera is where it may be.
PictureStatus check_picture(const PictureScene& scene, const PictureCamera& camera, const PictureBand& band);

}  // namespace fixrad
