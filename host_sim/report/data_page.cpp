// SPDX-License-Identifier: MIT
#include "host_sim/report/data_page.h"

#include <algorithm>
#include <cstdint>

#include "host_sim/io/model.h"
#include "host_sim/report/encode.h"

namespace fixrad::host {
namespace {

constexpr std::string_view kDataMark = "@FIXRAD_DATA@";
constexpr std::string_view kTitleMark = "@FIXRAD_TITLE@";

// No text may end the element that it stands in.
std::string without_tags(std::string_view text, std::string_view less_than) {
  std::string safe;
  for (const char c : text) {
    safe += c == '<' ? std::string(less_than) : std::string(1, c);
  }
  return safe;
}

void replace(std::string& page, std::string_view mark, const std::string& text) {
  const std::size_t at = page.find(mark);
  if (at != std::string::npos) {
    page.replace(at, mark.size(), text);
  }
}

}  // namespace

std::string page_with(const std::string& json, const std::string& title) {
  std::string page(page_template());
  if (page.empty()) {
    throw InputError(
        "fixrad: error: this fixrad was built without its page; install the packages nodejs and npm and "
        "build it "
        "again, or write a .csv");
  }
  replace(page, kTitleMark, without_tags(title, "&lt;"));
  replace(page, kDataMark, without_tags(json, "\\u003c"));
  return page;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    }
    const std::size_t digits = std::min<std::size_t>(bytes.size() - i, 3) + 1;
    for (std::size_t k = 0; k < 4; ++k) {
      text += k < digits ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return text;
}

std::string png_data_url(const Image& image) {
  return "data:image/png;base64," + base64(encode_png(image));
}

std::string glb_base64(const BakedMesh& mesh, const Display& display) {
  return base64(encode_glb(mesh, display));
}

}  // namespace fixrad::host
