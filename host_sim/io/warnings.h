// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/io/source_text.h"

namespace fixrad::host {

/// Collects warnings, one a kind and at most 100.
class Warnings {
 public:
  /// Adds `file:line:column: warning: message` for a token of `source`, unless `kind` was said before.
  void say_once(const std::string& kind, const SourceText& source, std::string_view token,
                const std::string& message);

  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::set<std::string> kinds_;
  std::vector<std::string> lines_;
};

}  // namespace fixrad::host
