// SPDX-License-Identifier: MIT
// make_samples FOLDER: writes the files that other programs check: room.glb, room_z_up.glb, hand_made.hpp.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "host_sim/report/writers.h"
#include "tests/report/sample_mesh.h"

int main(int argc, char** argv) {
  namespace host = fixrad::host;
  try {
    const std::filesystem::path folder = argc == 2 ? argv[1] : ".";
    const host::BakedMesh room = host::testing::open_room();
    host::Display z_up;
    z_up.z_up = true;
    host::write_glb(folder / "room.glb", room, {});
    host::write_glb(folder / "room_z_up.glb", room, z_up);
    host::write_hpp(folder / "hand_made.hpp", room, {});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
