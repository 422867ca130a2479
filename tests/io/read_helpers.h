// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host_sim/io/obj_reader.h"

namespace fixrad::host {

/// MTL files in memory, by the path that the reader asks for.
using Files = std::map<std::string, std::string>;

inline const char* const kWhiteAndLamp = "newmtl white\nKd 0.7 0.6 0.5\nnewmtl lamp\nKd 0 0 0\nKe 10 9 8\n";

inline const char* const kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// A square whose material is a lamp; faces go after it.
inline std::string lit_square(const std::string& more = "") {
  return std::string("mtllib m.mtl\n") + kSquare + "usemtl lamp\nf 1 2 3 4\n" + more;
}

inline Model read(const std::string& text, const Files& files = {{"m.mtl", kWhiteAndLamp}},
                  const ReadOptions& options = {}) {
  const auto load = [&](const std::string& path) -> std::optional<std::string> {
    const auto file = files.find(path);
    return file == files.end() ? std::nullopt : std::optional<std::string>(file->second);
  };
  return read_obj_text(text, "s.obj", load, options);
}

/// A lamp square whose MTL file holds `mtl` as well, and a triangle in the material `name` on line 8.
inline Model read_with_material(const std::string& name, const std::string& mtl,
                                const ReadOptions& options = {}) {
  return read(lit_square("usemtl " + name + "\nf 1 2 3\n"), {{"m.mtl", "newmtl lamp\nKe 1 1 1\n" + mtl}},
              options);
}

/// The message of the InputError that `action` throws; empty if it throws none.
template <typename Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace fixrad::host
