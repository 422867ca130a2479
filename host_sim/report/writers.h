// SPDX-License-Identifier: MIT
// A solution as files. Each writer works atomically (the file appears complete or not at all), writes the
// same bytes for the same mesh on every machine and in every locale, and throws InputError (one line for the
// user) if the file cannot be written, std::invalid_argument if check_mesh refuses the mesh. Display colours
// are those of tone.h, with one exposure for all files of a mesh. Lengths are in the scene's unit, radiosity
// in W/m^2.
#pragma once

#include <filesystem>

#include "host_sim/report/baked_mesh.h"
#include "host_sim/report/picture.h"

namespace fixrad::host {

/// ASCII PLY 1.0. Vertices: float x y z nx ny nz, uchar red green blue (display), float B_r B_g B_b (linear
/// radiosity, shortest text that reads back as the same float). Faces: triangles. Comments name unit and
/// exposure.
void write_ply(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display);

/// glTF 2.0 binary, one primitive: POSITION, NORMAL, COLOR_0 (linear, tone-mapped, in [0, 1]),
/// KHR_materials_unlit, back faces culled. A z-up scene is turned so that glTF's +Y is up. Passes the Khronos
/// validator.
void write_glb(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display);

/// A self-contained freestanding C++ header with constexpr tables for flash: quantised positions, display
/// colours, radiosity as RGBE8, triangles. The header documents its own encoding; see write_hpp.cpp.
void write_hpp(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display);

/// CSV (RFC 4180 quoting, \n line ends) with a row an element: element,face,material,x,y,z,area,B_r,B_g,B_b,
/// where x y z is the centroid. Numbers read back as the same double. Display has no influence.
void write_csv(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display);

/// 8-bit RGB PNG of render_picture.
void write_png(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display,
               const PictureOptions& options = {});

}  // namespace fixrad::host
