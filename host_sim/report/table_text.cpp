// SPDX-License-Identifier: MIT
#include "host_sim/report/table_text.h"

#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr std::size_t kLineWidth = 110;

}  // namespace

std::string literal(std::int64_t value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string unsigned_literal(std::uint32_t value) {
  return literal(value) + "u";
}

std::string hex_literal(std::uint64_t value) {
  std::string digits = "ull";
  for (int i = 0; i < 16; ++i, value >>= 4) {
    digits.insert(digits.begin(), "0123456789abcdef"[value & 15]);
  }
  return "0x" + digits;
}

std::string braced(const std::vector<std::string>& parts) {
  std::string text = "{";
  for (const std::string& part : parts) {
    text += text.size() == 1 ? "" : ", ";
    text += part;
  }
  return text + "}";
}

void append_table(std::string& text, std::string_view declaration, const std::vector<std::string>& records) {
  text += "constexpr FIXRAD_IN_FLASH ";
  text += declaration;
  text += " = {";
  std::size_t width = kLineWidth;  // the first record begins a line
  for (const std::string& record : records) {
    if (width + 2 + record.size() > kLineWidth) {
      text += "\n   ";
      width = 3;
    }
    text += ' ';
    text += record;
    text += ',';
    width += 2 + record.size();
  }
  text += "\n};\n";
}

void append_function(std::string& text, const std::string& type, const std::string& name,
                     const std::vector<std::pair<const char*, std::string>>& members) {
  text += "\nstatic inline fixrad::" + type + " " + name + "() {\n  fixrad::" + type + " result = {};\n";
  for (const auto& [member, value] : members) {
    text += std::string("  result.") + member + " = " + value + ";\n";
  }
  text += "  return result;\n}\n";
}

}  // namespace fixrad::host
