// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/report/mirrors.h"
#include "host_sim/report/rasterizer.h"

namespace fixrad::host {

/// What materials show beside diffuse light: highlights, and mirror images in which mirrors show their
/// diffuse light only. Nothing where the mesh names no appearances.
class ViewDependent {
 public:
  /// `background`: radiosity where a mirror shows nothing. `mesh` must outlive the object.
  ViewDependent(const BakedMesh& mesh, const Projection& camera, double near_distance,
                const glm::dvec3& background);

  /// Adds it to the radiosity of the samples, which draw() was given with the triangles of the mesh as
  /// sources.
  void add(SampleBand& band) const;

 private:
  struct Image {  // of a mirror
    MirrorPlane plane;
    BakedMesh mesh;  // what stands before it
    Projection projection;
    std::vector<ScreenTriangle> triangles;
    std::vector<std::uint32_t> sources;
  };
  void add_images(SampleBand& band) const;

  const BakedMesh& mesh_;
  Projection camera_;
  glm::dvec3 background_;
  Mirrors mirrors_;
  std::vector<Image> images_;
};

}  // namespace fixrad::host
