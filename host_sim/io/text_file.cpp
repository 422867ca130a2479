// SPDX-License-Identifier: MIT
#include "host_sim/io/text_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "host_sim/io/model.h"

namespace fixrad::host {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void refuse(const std::string& path, const std::string& message) {
  throw InputError(path + ": error: " + message);
}

[[noreturn]] void refuse_unreadable(const std::string& path, int code) {
  refuse(path, "cannot be read: " + std::generic_category().message(code) + "; check its permissions");
}

}  // namespace

std::string read_text_file(const std::string& path, std::size_t most) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    refuse(path, "there is no such file; check the path");
  }
  if (std::filesystem::is_directory(status)) {
    refuse(path, "is a folder, not a file; name a file in it");
  }
  const auto refuse_size = [&] {
    refuse(path, "is larger than " + std::to_string(most >> 20) + " MiB; reduce the scene");
  };
  const std::uintmax_t size =
      std::filesystem::is_regular_file(status) ? std::filesystem::file_size(path, error) : 0;
  if (!error && size > most) {
    refuse_size();
  }
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    refuse_unreadable(path, errno);
  }
  std::string text;
  text.reserve(error ? 0 : static_cast<std::size_t>(size));
  std::array<char, 65536> block{};
  for (std::size_t count = block.size(); count > 0;) {
    count = std::fread(block.data(), 1, block.size(), file.get());
    text.append(block.data(), count);
    if (text.size() > most) {
      refuse_size();
    }
  }
  if (std::ferror(file.get()) != 0) {
    refuse_unreadable(path, errno);
  }
  return text;
}

}  // namespace fixrad::host
