// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "host_sim/io/limits.h"

namespace fixrad::host {

/// The bytes of a file. Throws InputError `path: error: ...` if it is missing, a folder, unreadable or larger
/// than `most` bytes, in whole MiB; a regular file before it is read (pipes are read as well).
std::string read_text_file(const std::string& path, std::size_t most = kMaxObjBytes);

}  // namespace fixrad::host
