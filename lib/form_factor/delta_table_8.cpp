// SPDX-License-Identifier: MIT
// Made by host_sim/tables/make_delta_tables.cpp; do not edit.
// clang-format off
#include "lib/form_factor/delta_table.h"

namespace fixrad {
namespace {

constexpr FIXRAD_IN_FLASH uint16_t kTop[] = {
    19262, 34699, 45226, 51824, 15437, 28074, 36975, 42742, 10527, 19428, 26027, 30540, 6598, 12365, 16878, 20156,
};

constexpr FIXRAD_IN_FLASH uint16_t kSide[] = {
    2360, 4255, 5552, 6367, 5686, 10349, 13641, 15780, 6483, 11971, 16048, 18841, 5706, 10698, 14609, 17453,
};

}  // namespace

const FIXRAD_IN_FLASH DeltaTable kDelta8 = {3, kTop, kSide, nullptr};

}  // namespace fixrad
