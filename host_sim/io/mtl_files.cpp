// SPDX-License-Identifier: MIT
#include "host_sim/io/mtl_files.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "host_sim/io/limits.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kMaxWordsInFileName = 16;  // bounds the look-ups that one broken statement costs

class MtlFiles {
 public:
  MtlFiles(const SourceText& obj, const LoadText& load_mtl, MtlLibrary& library, Warnings& warnings)
      : obj_(obj), load_mtl_(load_mtl), library_(library), warnings_(warnings) {}

  void load(const Statement& statement);

 private:
  bool load_one(std::string name, std::string_view token);
  std::size_t load_longest(const std::vector<std::string_view>& words, std::size_t first);

  const SourceText& obj_;
  const LoadText& load_mtl_;
  MtlLibrary& library_;
  Warnings& warnings_;
  std::set<std::string> names_, loaded_;  // as statements give them; paths
  std::size_t lookups_ = 0, bytes_ = 0;
};

// A relative path that stays in its folder, whatever the file system holds.
bool stays_inside(const std::filesystem::path& name) {
  const std::filesystem::path normal = name.lexically_normal();
  const bool has_drive = name.native().size() > 1 && name.native()[1] == ':';
  return !normal.is_absolute() && !has_drive && (normal.empty() || *normal.begin() != "..");
}

bool MtlFiles::load_one(std::string name, std::string_view token) {
  if (names_.count(name) != 0) {
    return true;
  }
  const std::string given = name;
  std::replace(name.begin(), name.end(), '\\', '/');
  if (!stays_inside(name)) {
    obj_.fail(token, "the material file " + quote(given) +
                         " lies outside the OBJ file's folder; copy it there and correct mtllib");
  }
  const std::string path = (std::filesystem::path(obj_.path()).parent_path() / name).string();
  if (loaded_.count(path) == 0) {
    if (++lookups_ > kMaxFileLookups) {
      obj_.fail(token, "mtllib statements name too many files; write each file once, names without blanks");
    }
    std::optional<std::string> text = load_mtl_(path);
    if (!text) {
      return false;
    }
    bytes_ += text->size();
    if (loaded_.size() == kMaxMtlFiles || bytes_ > kMaxMtlBytes) {
      obj_.fail(token, "the scene has more than " + std::to_string(kMaxMtlFiles) + " material files or " +
                           std::to_string(kMaxMtlBytes >> 20) + " MiB of them; leave out what no face uses");
    }
    loaded_.insert(path);
    library_.load(path, std::move(*text), warnings_);
  }
  names_.insert(given);
  return true;
}

/// How many words from words[first] on make the longest name of a file that exists; that file is loaded.
std::size_t MtlFiles::load_longest(const std::vector<std::string_view>& words, std::size_t first) {
  for (std::size_t count = std::min(words.size() - first, kMaxWordsInFileName); count > 0; --count) {
    std::string name(words[first]);
    for (std::size_t i = 1; i < count; ++i) {
      name.append(" ").append(words[first + i]);
    }
    if (load_one(name, words[first])) {
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
  if (load_one(name, words.empty() ? statement.keyword : words.front())) {
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
