// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/row.h"

namespace fixrad {

/// An entry that balance_row() leaves as it is, while a row is being corrected.
constexpr uint32_t kFixedShare = 1ul << 31;

/// Brings a row to the sum `one` by scaling every entry that is not fixed, back faces and what escapes
/// included, by one ratio; running sums are rounded, so the sum is exact. Marks of fixed entries are taken
/// off. Where nothing is left to scale, the rest escapes; where the fixed entries alone pass `one`, these are
/// scaled. Cost: one 64-bit division and a wide product for each entry that is not 0.
void balance_row(FormFactorRow& row, uint32_t one);

}  // namespace fixrad
