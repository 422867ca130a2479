// SPDX-License-Identifier: MIT
#include "host_sim/bake/state_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "host_sim/io/atomic_file.h"
#include "host_sim/io/model.h"
#include "host_sim/io/text_file.h"

namespace fixrad::host {
namespace {

[[noreturn]] void refuse(const std::string& path, SaveStatus status) {
  throw InputError(path + ": error: " + describe(status));
}

bool read_bytes(void* context, std::uint32_t offset, std::uint8_t* to, std::uint8_t count) {
  const std::string& bytes = *static_cast<const std::string*>(context);
  if (offset > bytes.size() || bytes.size() - offset < count) {
    return false;
  }
  std::memcpy(to, bytes.data() + offset, count);
  return true;
}

bool append_bytes(void* context, const std::uint8_t* from, std::uint8_t count) {
  static_cast<std::string*>(context)->append(reinterpret_cast<const char*>(from), count);
  return true;
}

}  // namespace

const char* describe(SaveStatus status) {
  switch (status) {
    case SaveStatus::ok:
      return "ok";
    case SaveStatus::write_failed:
      return "the state could not be written";
    case SaveStatus::refined:
      return "elements have been split while the solution went on, and such a state is not saved; solve anew";
    case SaveStatus::not_a_state:
      return "this is no saved state; name a file that `fixrad bake --save` or a device has written";
    case SaveStatus::truncated:
      return "the saved state ends early; copy all of it, or take an older one";
    case SaveStatus::damaged:
      return "the saved state is damaged: its checksum is wrong; copy it again, or take an older one";
    case SaveStatus::older_version:
      return "the saved state has an older format; resume it with the version that saved it";
    case SaveStatus::newer_version:
      return "the saved state has a newer format; use a newer fixrad";
    case SaveStatus::foreign_scene:
      return "this is the state of another scene, or of another mesh of it; give the scene and the "
             "--profile, "
             "--mesh and --elements that it was saved with";
    case SaveStatus::foreign_settings:
      return "this is the state of a solution with other settings; give the --profile, --engine, "
             "--resolution, "
             "--unshot and so on that it was saved with";
    case SaveStatus::inconsistent:
      return "the checksum is right, but no solution comes to such a state; take an older one";
  }
  return "unknown status";
}

StateFile::StateFile(const std::string& path) : path_(path), bytes_(read_text_file(path)) {}

StateSource StateFile::source() const {
  return {const_cast<std::string*>(&bytes_), read_bytes};
}

SavedHeader StateFile::header() const {
  SavedHeader header = {};
  const SaveStatus status = read_header(source(), header);
  if (status != SaveStatus::ok) {
    refuse(path_, status);
  }
  return header;
}

void StateFile::resume(State& state, const Identity& identity) const {
  const SaveStatus status = load_state(state, identity, source());
  if (status != SaveStatus::ok) {
    refuse(path_, status);
  }
}

void write_state(const std::string& path, const State& state, const Identity& identity,
                 std::uint32_t sequence) {
  std::string bytes;
  const SaveStatus status = save_state(state, identity, {&bytes, append_bytes}, sequence);
  if (status != SaveStatus::ok) {
    refuse(path, status);
  }
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      throw std::runtime_error(errno != 0 ? std::strerror(errno) : "the disk refused the data");
    }
  });
}

}  // namespace fixrad::host
