// SPDX-License-Identifier: MIT
#include "host_sim/io/warnings.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kMaxWarnings = 100;

}  // namespace

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
