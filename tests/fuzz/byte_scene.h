// SPDX-License-Identifier: MIT
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <vector>

#include "lib/fixrad.h"

namespace fixrad::fuzz {

/// Tables of a scene that bytes have made, each in a block of its own and of its exact size, so that a read
/// beyond one is seen. Counts never promise more than a table holds; all else may be wrong.
struct ByteScene {
  std::vector<Vertex> vertices;
  std::vector<uint16_t> corners;
  std::vector<Face> faces;
  std::vector<CellRow> cell_rows;
  std::vector<uint16_t> roots;
  std::vector<Cut> cuts;
  std::vector<Element> elements;
  std::vector<Patch> patches;
  std::vector<uint16_t> patch_elements;
  std::vector<Material> materials;
  std::vector<Sight> sights;
  uint8_t channels = 3, emission_shift = 0, radiosity_shift = 0;

  Scene view() const;
};

/// Capacities of the solvers that the scenes are loaded into; scenes of wild_scene() may pass them.
constexpr uint16_t kVertices = 40, kFaces = 12, kElements = 64;
using FuzzLimits = Limits<kVertices, kFaces, kElements, 2 * kFaces + 6, 3, 8>;

/// Tables of small counts whose records are bytes as they come. check_scene() refuses nearly all.
ByteScene wild_scene(FuzzedDataProvider& in);

/// Up to six walls of a box, and parallelograms and triangles anywhere, with grids, cuts, patches, materials
/// and sights as the bytes say, made as the tables of the host are: check_scene() takes nearly all.
ByteScene sound_scene(FuzzedDataProvider& in);

/// Overwrites single bytes of the scene's records: what a damaged flash holds.
void damage(FuzzedDataProvider& in, ByteScene& scene);

/// Engine, tables and fractions as the bytes say: engines of rows and pixels, or those that look at elements
/// pair by pair, which take far longer. The finest table has 32 rows, and that seldom.
Settings any_settings(FuzzedDataProvider& in, bool of_pairs);

/// One run of a fuzzer: settings and a scene from the bytes, then load(), which either refuses or is followed
/// by shots that must be defined and keep the ledger.
void load_and_shoot(const std::uint8_t* data, std::size_t size, bool of_pairs);

/// Traps unless emitted = absorbed + unshot + escaped + back in every channel, to the unit.
void require_ledger(const State& state);

}  // namespace fixrad::fuzz
