// SPDX-License-Identifier: MIT
// Exported scenes in a translation unit that uses nothing of them, compiled as firmware would be (see
// CMakeLists.txt).
#include "firmware/scenes/colonnade_small.h"
#include "fresh/cornell_pixels.hpp"

static_assert(colonnade_small::Limits::faces == 58 && cornell_pixels::Limits::channels == 3,
              "as in the scenes");
