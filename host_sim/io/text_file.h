// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fixrad::host {

/// The bytes of a file. Throws InputError `path: error: ...` if it is missing, a folder, unreadable or larger
/// than 256 MiB (pipes are read as well).
std::string read_text_file(const std::string& path);

}  // namespace fixrad::host
