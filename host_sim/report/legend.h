// SPDX-License-Identifier: MIT
#pragma once

#include "host_sim/report/picture.h"

namespace fixrad::host {

/// Pixels that a legend adds to a picture's height.
inline constexpr int kLegendHeight = 48;

/// The picture of false_colours() with its scale below: colours from -limit to +limit with five marks in per
/// cent.
Image with_legend(const Image& picture, double limit);

}  // namespace fixrad::host
