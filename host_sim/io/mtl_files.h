// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/io/mtl_library.h"
#include "host_sim/io/obj_reader.h"
#include "host_sim/io/source_text.h"
#include "host_sim/io/warnings.h"

namespace fixrad::host {

/// Loads the files of all `mtllib` statements of an OBJ text into `library`, each file once.
/// A statement names one file with blanks in its name or several files: the longest name that exists wins,
/// starting with all of the line. A backslash separates folders like a slash. Throws InputError for a file
/// that is missing or would lie outside the folder of the OBJ file, and beyond what limits.h allows.
void load_mtl_files(const SourceText& obj, const LoadText& load_mtl, MtlLibrary& library, Warnings& warnings);

}  // namespace fixrad::host
