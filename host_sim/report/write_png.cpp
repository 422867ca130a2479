// SPDX-License-Identifier: MIT
#include <png.h>

#include <stdexcept>
#include <string>

#include "host_sim/report/encode.h"
#include "host_sim/report/text.h"
#include "host_sim/report/writers.h"

namespace fixrad::host {

std::string encode_png(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("the PNG library cannot encode the picture: ") + png.message);
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& target, const BakedMesh& mesh, const Display& display,
               const PictureOptions& options) {
  write_text(target, encode_png(render_picture(mesh, display, options)));
}

}  // namespace fixrad::host
