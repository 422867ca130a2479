// SPDX-License-Identifier: MIT
#include "lib/form_factor/row_balance.h"

namespace fixrad {
namespace {

// Scales parts by to / from, by running sums: from in parts gives to, exactly.
class RowScale {
 public:
  RowScale(uint32_t from, uint32_t to)
      : from_(from), to_(to), ratio_(from == 0 ? 0 : (static_cast<uint64_t>(to) << 32) / from) {}

  void scale(uint32_t& part) {
    if (part == 0) {
      return;
    }
    in_ += part;
    // Both factors of the sum are below 2^22 and 2^42 at most: row sums stay below 4.
    const uint32_t sum = in_ == from_ ? to_ : static_cast<uint32_t>((ratio_ * in_) >> 32);
    part = sum - out_;
    out_ = sum;
  }

 private:
  uint32_t from_, to_;
  uint64_t ratio_;
  uint32_t in_ = 0, out_ = 0;
};

}  // namespace

void balance_row(FormFactorRow& row, uint32_t one) {
  uint32_t fixed = 0, loose = row.escaped + row.back;
  for (uint16_t j = 0; j < row.count; ++j) {
    const bool is_fixed = (row.share[j] & kFixedShare) != 0;
    (is_fixed ? fixed : loose) += row.share[j] & ~kFixedShare;
  }
  const bool keeps_fixed = fixed <= one;
  RowScale loose_scale(loose, keeps_fixed ? one - fixed : 0);
  RowScale fixed_scale(fixed, keeps_fixed ? fixed : one);
  for (uint16_t j = 0; j < row.count; ++j) {
    const bool is_fixed = (row.share[j] & kFixedShare) != 0;
    row.share[j] &= ~kFixedShare;
    (is_fixed ? fixed_scale : loose_scale).scale(row.share[j]);
  }
  loose_scale.scale(row.back);
  loose_scale.scale(row.escaped);
  if (loose == 0 && keeps_fixed) {
    row.escaped = one - fixed;
  }
}

}  // namespace fixrad
