// SPDX-License-Identifier: MIT
#include "host_sim/report/frame_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "host_sim/report/data_page.h"
#include "host_sim/report/tone.h"

namespace fixrad::host {
namespace {

constexpr int kThumbnailWidth = 256;

double linear_from_srgb(std::uint8_t code) {
  const double x = code / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return result;
}

std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * part);
  return text;
}

std::string picture(const Frame& frame) {
  return "<a href=\"" + escaped(frame.file) + "\"><img src=\"" + png_data_url(frame.thumbnail) + "\" alt=\"" +
         std::to_string(frame.shots) + " shots" + (frame.with_ambient ? ", with the ambient estimate" : "") +
         "\" width=\"" + std::to_string(frame.thumbnail.width) + "\" height=\"" +
         std::to_string(frame.thumbnail.height) + "\"></a>";
}

constexpr char kStyle[] =
    "body{margin:1.5rem;background:#1c1c1f;color:#ddd;font:15px/1.4 system-ui,sans-serif}"
    "h1{font-size:1.2rem;font-weight:600;margin:0 0 .3rem}p{margin:0 0 1rem;max-width:60em;color:#aaa}"
    "main{display:flex;flex-wrap:wrap;gap:1rem}figure{margin:0}img{display:block;margin-bottom:3px}"
    "figcaption{display:flex;justify-content:space-between;gap:1rem;padding:.1rem 0 "
    ".3rem;font-variant-numeric:tabular-"
    "nums}figcaption span{color:#aaa}";

}  // namespace

std::string frame_page(const std::string& scene, const std::vector<Frame>& frames) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(scene) +
      ": progressive solution</title>\n<style>" + kStyle + "</style></head>\n<body><h1>" + escaped(scene) +
      ": progressive solution</h1>\n<p>After each doubling of shots, at one exposure. Above: what "
      "has been shot; below: with the ambient estimate of what is still unshot. The last one is "
      "the finished solution.</p>\n<main>\n";
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame& frame = frames[i];
    if (frame.with_ambient) {
      continue;
    }
    const bool has_twin = i + 1 < frames.size() && frames[i + 1].with_ambient;
    page += "<figure><figcaption>" + std::to_string(frame.shots) + (frame.shots == 1 ? " shot" : " shots") +
            "<span>" + percent(frame.unshot_fraction) + " unshot</span></figcaption>" + picture(frame) +
            picture(has_twin ? frames[i + 1] : frame) + "</figure>\n";
  }
  return page + "</main></body></html>\n";
}

Image thumbnail(const Image& image) {
  std::array<double, 256> linear{};
  for (std::size_t code = 0; code < linear.size(); ++code) {
    linear[code] = linear_from_srgb(static_cast<std::uint8_t>(code));
  }
  const int reduction = std::max(1, image.width / kThumbnailWidth);
  Image small{image.width / reduction, std::max(1, image.height / reduction), {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      glm::dvec3 sum(0.0);
      int count = 0;
      for (int v = reduction * y; v < std::min(reduction * (y + 1), image.height); ++v) {
        for (int u = reduction * x; u < std::min(reduction * (x + 1), image.width); ++u, ++count) {
          const auto at = static_cast<std::size_t>(3 * (v * image.width + u));
          sum += glm::dvec3(linear[image.rgb[at]], linear[image.rgb[at + 1]], linear[image.rgb[at + 2]]);
        }
      }
      const Srgb8 colour = srgb8(sum / static_cast<double>(count));
      small.rgb.insert(small.rgb.end(), colour.begin(), colour.end());
    }
  }
  return small;
}

}  // namespace fixrad::host
