// SPDX-License-Identifier: MIT
#include "host_sim/io/source_text.h"

#include <algorithm>
#include <utility>

#include "host_sim/io/limits.h"
#include "host_sim/io/model.h"

namespace fixrad::host {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kMaxQuotedBytes = 60;

bool starts_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

bool is_blank(char c) {
  return kBlanks.find(c) != std::string_view::npos;
}

bool is_utf8_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The line up to its comment, which starts at a # at the head of a word: "1.#INF" holds none.
std::string_view without_comment(std::string_view line) {
  std::size_t hash = line.find('#');
  while (hash != std::string_view::npos && hash > 0 && !is_blank(line[hash - 1])) {
    hash = line.find('#', hash + 1);
  }
  return line.substr(0, hash);
}

/// Whether the line goes on in the next one. A comment hides the backslash: "# C:\scenes\" joins nothing.
bool is_continued(std::string_view line) {
  const std::size_t last = line.find_last_not_of(kBlanks);
  return last != std::string_view::npos && line[last] == '\\' && without_comment(line).size() == line.size();
}

void append_arguments(std::string_view line, std::vector<std::string_view>& arguments) {
  line = without_comment(line);
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    arguments.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
}

/// Where a comment starts in a name: at a # between blanks or ends of the line.
std::size_t find_comment_in_name(const std::string& name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool opens = i == 0 || is_blank(name[i - 1]);
    const bool stands_alone = i + 1 == name.size() || is_blank(name[i + 1]);
    if (name[i] == '#' && opens && stands_alone) {
      return i;
    }
  }
  return name.size();
}

}  // namespace

SourceText::SourceText(std::string path, std::string text, const char* kind)
    : path_(std::move(path)), text_(std::move(text)), kind_(kind) {
  refuse_binary();
}

std::string_view SourceText::view() const {
  const std::string_view text = text_;
  return starts_with(text, kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

std::string SourceText::locate(std::string_view token) const {
  const std::string_view text = view();
  const auto offset = static_cast<std::size_t>(token.data() - text.data());
  if (offset < located_.offset) {
    located_ = {};
  }
  for (std::size_t& i = located_.offset; i < offset; ++i) {
    const bool cr_alone = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
    if (text[i] == '\n' || cr_alone) {
      ++located_.line;
      located_.line_begin = i + 1;
    }
  }
  int column = 1;
  for (std::size_t i = located_.line_begin; i < offset; ++i) {
    column += is_utf8_continuation(text[i]) ? 0 : 1;
  }
  return path_ + ":" + std::to_string(located_.line) + ":" + std::to_string(column);
}

void SourceText::fail(std::string_view token, const std::string& message) const {
  throw InputError(locate(token) + ": error: " + message);
}

void SourceText::refuse_binary() const {
  const std::string_view text = text_;
  const std::string remedy = std::string("export the scene as a Wavefront .obj with its .mtl");
  const std::string no_text = std::string("is not a text ") + kind_ + " file";
  if (starts_with(text, "glTF")) {
    throw InputError(path_ + ": error: " + no_text + " but binary glTF (.glb); " + remedy);
  }
  if (starts_with(text, "\xFF\xFE") || starts_with(text, "\xFE\xFF")) {
    throw InputError(path_ + ": error: " + no_text + " in UTF-8 but UTF-16; save it as UTF-8");
  }
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    throw InputError(path_ + ": error: " + no_text + " (byte " + std::to_string(nul) + " is NUL); " + remedy);
  }
}

std::string_view StatementReader::take_line() {
  const std::size_t begin = position_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", begin), text_.size());
  position_ = end;
  if (text_.substr(position_, 2) == "\r\n") {
    position_ += 2;
  } else if (position_ < text_.size()) {
    position_ += 1;
  }
  ++line_;
  return text_.substr(begin, end - begin);
}

bool StatementReader::read_pieces(Statement& statement) {
  std::vector<std::string_view>& words = statement.arguments;
  words.clear();
  const std::size_t begin = position_;
  std::size_t end = begin;
  for (bool continued = true; continued && position_ < text_.size();) {
    std::string_view line = take_line();
    if (position_ - begin > kMaxStatementBytes) {
      source_.fail(text_.substr(begin, 1), "the line is longer than 1 MiB; split it");
    }
    continued = is_continued(line);
    if (continued) {
      line = line.substr(0, line.find_last_of('\\'));
    }
    const std::size_t known = words.size();
    append_arguments(line, words);
    if (known == 0 && !words.empty()) {
      statement.line = line_;
    }
    end = static_cast<std::size_t>(line.data() - text_.data()) + line.size();
  }
  if (words.empty()) {
    return false;
  }
  statement.keyword = words.front();
  words.erase(words.begin());
  const auto after =
      static_cast<std::size_t>(statement.keyword.data() - text_.data()) + statement.keyword.size();
  statement.rest = text_.substr(after, end - after);
  return true;
}

bool StatementReader::next(Statement& statement) {
  while (position_ < text_.size()) {
    if (!read_pieces(statement)) {
      continue;
    }
    const auto is_printable = [](char c) { return c > ' ' && c < '\x7F'; };
    const std::string_view keyword = statement.keyword;
    if (!std::all_of(keyword.begin(), keyword.end(), is_printable)) {
      source_.fail(keyword, std::string("is not a text ") + source_.kind() + " file: " + quote(keyword) +
                                " is no statement; export the scene as a Wavefront .obj with its .mtl");
    }
    return true;
  }
  return false;
}

std::string Statement::name() const {
  std::string joined;
  for (const char c : rest) {
    if (c != '\r' && c != '\n') {
      joined.push_back(c);
      continue;
    }
    // An end of line inside a statement follows a backslash, which is no part of the name.
    joined.resize(joined.find_last_not_of(kBlanks) + 1);
    if (!joined.empty() && joined.back() == '\\') {
      joined.back() = ' ';
    }
  }
  joined.resize(find_comment_in_name(joined));
  return std::string(trimmed(joined));
}

std::string quote(std::string_view token) {
  const bool cut = token.size() > kMaxQuotedBytes;
  if (cut) {
    std::size_t size = kMaxQuotedBytes;
    while (size > 0 && is_utf8_continuation(token[size])) {
      --size;
    }
    token = token.substr(0, size);
  }
  std::string text = "'";
  for (const char c : token) {
    const bool is_control = static_cast<unsigned char>(c) < 0x20U || c == '\x7F';
    text.push_back(is_control ? '?' : c);
  }
  return text + (cut ? "...'" : "'");
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    return {};
  }
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace fixrad::host
