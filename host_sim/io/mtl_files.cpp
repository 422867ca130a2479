// SPDX-License-Identifier: MIT
#include "host_sim/io/mtl_files.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace fixrad::host {
namespace {

constexpr std::size_t kMaxWordsInFileName = 16;  // bounds the look-ups that one broken statement costs

class MtlFiles {
 public:
  MtlFiles(const SourceText& obj, const LoadText& load_mtl, MtlLibrary& library, Warnings& warnings)
      : obj_(obj), load_mtl_(load_mtl), library_(library), warnings_(warnings) {}

  void load(const Statement& statement);

 private:
  bool load_one(std::string name);
  std::size_t load_longest(const std::vector<std::string_view>& words, std::size_t first);

  const SourceText& obj_;
  const LoadText& load_mtl_;
  MtlLibrary& library_;
  Warnings& warnings_;
  std::set<std::string> loaded_;
};

bool MtlFiles::load_one(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::string path = (std::filesystem::path(obj_.path()).parent_path() / name).string();
  if (loaded_.count(path) != 0) {
    return true;
  }
  std::optional<std::string> text = load_mtl_(path);
  if (!text) {
    return false;
  }
  loaded_.insert(path);
  library_.load(path, std::move(*text), warnings_);
  return true;
}

/// How many words from words[first] on make the longest name of a file that exists; that file is loaded.
std::size_t MtlFiles::load_longest(const std::vector<std::string_view>& words, std::size_t first) {
  for (std::size_t count = std::min(words.size() - first, kMaxWordsInFileName); count > 0; --count) {
    std::string name(words[first]);
    for (std::size_t i = 1; i < count; ++i) {
      name.append(" ").append(words[first + i]);
    }
    if (load_one(name)) {
      return count;
    }
  }
  return 0;
}

void MtlFiles::load(const Statement& statement) {
  const std::string name = statement.name();
  const std::vector<std::string_view>& words = statement.arguments;
  if (name.empty()) {
    warnings_.say_once("empty mtllib", obj_, statement.keyword, "mtllib names no file and is ignored");
    return;
  }
  if (load_one(name)) {
    return;
  }
  std::size_t done = 0;
  while (done < words.size()) {
    const std::size_t count = load_longest(words, done);
    if (count == 0) {
      break;
    }
    done += count;
  }
  if (words.empty() || done < words.size()) {
    const std::string_view token = words.empty() ? statement.keyword : words[done];
    const std::string missing = done == 0 ? name : std::string(token);
    obj_.fail(token, "there is no material file " + quote(missing) +
                         "; put it into the OBJ file's folder or correct mtllib");
  }
}

}  // namespace

void load_mtl_files(const SourceText& obj, const LoadText& load_mtl, MtlLibrary& library,
                    Warnings& warnings) {
  MtlFiles files(obj, load_mtl, library, warnings);
  StatementReader reader(obj);
  Statement statement;
  while (reader.next(statement)) {
    if (statement.keyword == "mtllib") {
      files.load(statement);
    }
  }
}

}  // namespace fixrad::host
