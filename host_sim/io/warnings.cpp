// SPDX-License-Identifier: MIT
#include "host_sim/io/warnings.h"

#include "host_sim/io/limits.h"

namespace fixrad::host {
void Warnings::say_once(const std::string& kind, const SourceText& source, std::string_view token,
                        const std::string& message) {
  if (lines_.size() >= kMaxWarnings || !kinds_.insert(kind).second) {
    return;
  }
  const bool is_last = lines_.size() + 1 == kMaxWarnings;
  lines_.push_back(source.locate(token) +
                   ": warning: " + (is_last ? "further warnings are left out" : message));
}

}  // namespace fixrad::host
