// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

namespace fixrad::host {

/// Writes `target` completely or not at all.
///
/// Calls `write` with the path of a temporary file in target's folder (same suffix as target, so that
/// libraries which choose a format by suffix work), then renames that file onto target. A symbolic link is
/// followed. `write` reports failure by throwing; what it throws becomes the reason in the message, an
/// InputError is passed on as it is.
///
/// Throws InputError `target: error: cannot write the file: reason; what to do` if the folder is missing or
/// not writable, if target is a folder or a device, or if `write` throws or leaves no file. Then the
/// temporary is gone and a former target is as it was. Exceptions that are not std::exception pass through,
/// after the same clean-up.
void write_atomically(const std::filesystem::path& target,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

}  // namespace fixrad::host
