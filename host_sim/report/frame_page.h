// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/report/picture.h"

namespace fixrad::host {

/// A picture of a progressive sequence.
struct Frame {
  std::string file;  ///< name in the page's folder
  std::uint32_t shots = 0;
  double unshot_fraction = 0;
  bool with_ambient = false;
  Image thumbnail;
};

/// A page that shows the sequence side by side, above without and below with the ambient estimate, each with
/// its shots and unshot flux; the last frame, of the finished solution, stands in both rows. The small
/// pictures are part of the page and lead to the files.
std::string frame_page(const std::string& scene, const std::vector<Frame>& frames);

/// The picture about 256 pixels wide, or as it is if it is smaller: means of square blocks of pixels, in
/// linear light.
Image thumbnail(const Image& image);

}  // namespace fixrad::host
