// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "lib/fixrad.h"

namespace fixrad::host {

/// What each SaveStatus means to a person, and what to do about it; for what is not ok.
const char* describe(SaveStatus status);

/// A saved state as a file: what save_state() writes and a device saves, byte for byte.
class StateFile {
 public:
  /// Reads the file. Throws InputError if it is missing or unreadable.
  explicit StateFile(const std::string& path);

  /// The beginning, if the whole is a saved state. Throws InputError `path: error: what is wrong; what to
  /// do`.
  SavedHeader header() const;

  /// Lets `state`, which has been loaded, go on from here. Throws InputError as above; `state` is then as it
  /// was.
  void resume(State& state, const Identity& identity) const;

 private:
  StateSource source() const;

  std::string path_, bytes_;
};

/// Writes the state between two shots to `path`, completely or not at all. Throws InputError if it cannot.
void write_state(const std::string& path, const State& state, const Identity& identity,
                 std::uint32_t sequence);

}  // namespace fixrad::host
