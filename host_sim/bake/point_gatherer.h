// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "host_sim/bake/bake.h"
#include "host_sim/meshing/gather_points.h"

namespace fixrad::host {

/// Gathers irradiance and radiosity at points of a finished solution: the core's gather_vertex() with 64
/// lunes, whatever engine and resolution solved the scene. Queries may run on any number of threads; each
/// depends on the solution and its points only. Takes what it needs from `result`, but for its device scene,
/// which must outlive it.
class PointGatherer {
 public:
  /// @throws InputError if the core refuses the scene
  explicit PointGatherer(const BakeResult& result);
  ~PointGatherer();
  PointGatherer(const PointGatherer&) = delete;
  PointGatherer& operator=(const PointGatherer&) = delete;

  VertexLight gather(const VertexGather& vertex) const;

  /// W/m^2, always three channels.
  glm::dvec3 physical(const Radiosity (&of)[kMaxChannels]) const;

  /// Of the solution with these radiosities at its vertices, see digest().
  std::uint64_t digest_with(const std::vector<Radiosity>& displayed) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fixrad::host
