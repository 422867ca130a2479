// SPDX-License-Identifier: MIT
#include "host_sim/io/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <string>
#include <system_error>

#include "host_sim/io/model.h"

namespace fixrad::host {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& target, const std::string& reason, const std::string& remedy) {
  throw InputError(target.string() + ": error: cannot write the file: " + reason + "; " + remedy);
}

/// The file that a chain of symbolic links ends at, so that a rename replaces the file and not the link.
fs::path resolve_links(const fs::path& target) {
  std::error_code error;
  fs::path resolved = target;
  if (fs::is_symlink(fs::symlink_status(target, error))) {
    resolved = fs::weakly_canonical(target, error);
  }
  return error ? target : resolved;
}

void check_target(const fs::path& target, const fs::path& resolved) {
  std::error_code error;
  if (!resolved.has_filename()) {
    refuse(target, "this is no file name", "name a file");
  }
  const fs::path folder = resolved.has_parent_path() ? resolved.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    refuse(target, "the folder " + folder.string() + " does not exist", "create it or name another file");
  }
  const fs::file_status status = fs::status(resolved, error);
  if (fs::is_directory(status)) {
    refuse(target, "it is a folder", "name a file in it");
  }
  // A rename would replace a device node such as /dev/null by a plain file.
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(target, "it is not a regular file", "name another file");
  }
}

/// A name in the same folder, so that the rename never crosses file systems; unique among threads and
/// processes.
fs::path temporary_beside(const fs::path& resolved) {
  static std::atomic<unsigned> counter{0};
  const std::string unique = std::to_string(::getpid()) + "-" + std::to_string(counter++);
  fs::path name = "." + resolved.stem().string() + "." + unique + ".tmp" + resolved.extension().string();
  return resolved.parent_path() / name;
}

class Temporary {
 public:
  explicit Temporary(fs::path path) : path_(std::move(path)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    fs::remove(path_, ignored);  // nothing is left to remove after the rename
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void write_atomically(const fs::path& target, const std::function<void(const fs::path& temporary)>& write) {
  const fs::path resolved = resolve_links(target);
  check_target(target, resolved);
  const Temporary temporary(temporary_beside(resolved));
  try {
    write(temporary.path());
  } catch (const InputError&) {
    throw;  // a complete line already
  } catch (const std::exception& failure) {
    refuse(target, failure.what(), "check the folder's permissions and the space on the disk");
  }
  std::error_code error;
  if (!fs::is_regular_file(temporary.path(), error)) {
    refuse(target, "the folder is not writable", "check its permissions or name another file");
  }
  fs::rename(temporary.path(), resolved, error);
  if (error) {
    refuse(target, error.message(), "check the folder's permissions or name another file");
  }
}

}  // namespace fixrad::host
