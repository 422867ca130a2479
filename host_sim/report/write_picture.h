// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host_sim/report/picture_table.h"

namespace fixrad::host {

/// Appends to the header of a scene what a firmware draws it from: tables for flash and the functions
/// picture() (a PictureScene), picture_camera() and picture_exposure().
void append_picture(std::string& text, const PictureTable& table);

}  // namespace fixrad::host
