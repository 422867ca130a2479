// SPDX-License-Identifier: MIT
#include "tests/lib/gathered.h"

#include <gtest/gtest.h>

namespace fixrad::host {

int gather(Solution& solution) {
  constexpr int kMostSweeps = 5000;
  State& state = solution.state();
  const std::size_t n = state.scene.element_count;
  std::vector<std::uint16_t> share(n * n), back(n);
  std::vector<std::int32_t> exitent(n * state.scene.channels);
  FormFactorMatrix matrix = {share.data(), back.data(), exitent.data()};
  for (std::uint16_t e = 0; e < n; ++e) {
    EXPECT_EQ(sample_matrix_row(state, matrix, e), Status::ok);
  }
  int sweeps = 1;
  while (!gather_sweep(state, matrix) && sweeps < kMostSweeps) {
    ++sweeps;
  }
  EXPECT_LT(sweeps, kMostSweeps);
  book_gathering(state, matrix);
  return sweeps;
}

}  // namespace fixrad::host
