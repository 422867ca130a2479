// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fixrad::host {

/// The text of one OBJ or MTL file, owned, with the addresses that messages need. Views into view() are
/// tokens.
class SourceText {
 public:
  /// `kind` is "OBJ" or "MTL". Throws InputError if the text is binary: NUL bytes, UTF-16, glTF.
  SourceText(std::string path, std::string text, const char* kind);
  SourceText(const SourceText&) = delete;
  SourceText& operator=(const SourceText&) = delete;

  const std::string& path() const { return path_; }
  const char* kind() const { return kind_; }

  /// The text without a byte order mark.
  std::string_view view() const;

  /// `file:line:column` of a token, a view into view(). Both count from 1, columns in characters of UTF-8.
  /// O(size), for tokens in the order of the file once: for messages only.
  std::string locate(std::string_view token) const;

  /// Throws InputError `file:line:column: error: message`; message is "what is wrong; what to do".
  [[noreturn]] void fail(std::string_view token, const std::string& message) const;

 private:
  void refuse_binary() const;

  // How far locate() has counted lines.
  struct Located {
    std::size_t offset = 0, line_begin = 0;
    int line = 1;
  };

  std::string path_;
  std::string text_;
  const char* kind_;
  mutable Located located_;
};

/// One statement: a line, or several joined by a backslash at the end of each but the last.
struct Statement {
  std::string_view keyword;
  std::vector<std::string_view> arguments;  ///< separated by blanks, without the comment
  std::string_view rest;                    ///< everything after the keyword as it stands in the file
  int line = 0;                             ///< of the keyword, from 1

  /// What follows the keyword as one name, which may contain blanks. A lone `#` starts a comment, `#12` does
  /// not: modelling tools do write names such as "Material #12".
  std::string name() const;
};

/// Splits a text into statements; skips empty lines and comments. Lines end with LF, CRLF or CR.
class StatementReader {
 public:
  explicit StatementReader(const SourceText& source) : source_(source), text_(source.view()) {}

  /// Reads the next statement into `statement`. False at the end of the text.
  /// Throws InputError for a statement longer than 1 MiB or a keyword that is no printable ASCII.
  bool next(Statement& statement);

 private:
  std::string_view take_line();
  bool read_pieces(Statement& statement);

  const SourceText& source_;
  std::string_view text_;
  std::size_t position_ = 0;
  int line_ = 0;
};

/// A token between quotes, made safe to print: control characters replaced, cut after 60 bytes.
std::string quote(std::string_view token);

/// `text` without blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace fixrad::host
