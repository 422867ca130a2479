// SPDX-License-Identifier: MIT
#include <map>
#include <sstream>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

// Directly opposed and adjoining faces of a cube, from the closed forms of parallel and perpendicular squares
// (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11 and C-14).
constexpr double kOpposite = 0.199825;
constexpr double kAdjacent = 0.200044;

using Factors = std::map<std::pair<int, int>, double>;

Factors form_factors_of(const std::string& scene) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"form-factors", scene, "--csv", folder / "factors.csv"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto lines = lines_of(contents(folder / "factors.csv"));
  Factors factors;
  if (lines.empty() || lines.front() != "i,j,F") {
    ADD_FAILURE() << "no header i,j,F";
    return factors;
  }
  for (std::size_t k = 1; k < lines.size(); ++k) {
    std::istringstream fields(lines[k]);
    int i = -1, j = -1;
    double factor = -1;
    char comma = 0, second_comma = 0;
    fields >> i >> comma >> j >> second_comma >> factor;
    EXPECT_TRUE(fields && comma == ',' && second_comma == ',') << lines[k];
    EXPECT_GT(factor, 0) << "only pairs that are not zero";
    EXPECT_TRUE(factors.insert({{i, j}, factor}).second) << "twice: " << lines[k];
  }
  return factors;
}

TEST(FormFactorsCommand, ParallelSquaresMeetTheClosedForm) {
  const Factors factors = form_factors_of(sample_scene("parallel_plates"));
  ASSERT_EQ(factors.size(), 2u);
  EXPECT_NEAR(factors.at({0, 1}), kOpposite, 0.005 * kOpposite);
  EXPECT_NEAR(factors.at({1, 0}), kOpposite, 0.005 * kOpposite);
}

TEST(FormFactorsCommand, FacesOfACubeMeetTheClosedFormsAndSumToOne) {
  const Factors factors = form_factors_of(sample_scene("closed_box"));
  ASSERT_EQ(factors.size(), 30u);  // no face sees itself
  std::map<int, double> sum;
  for (const auto& [pair, factor] : factors) {
    const auto [i, j] = pair;
    const bool is_opposite = i / 2 == j / 2;  // the file lists opposite faces one after the other
    const double expected = is_opposite ? kOpposite : kAdjacent;
    EXPECT_NEAR(factor, expected, 0.005 * expected) << i << ',' << j;
    sum[i] += factor;
  }
  ASSERT_EQ(sum.size(), 6u);
  for (const auto& [face, total] : sum) {
    EXPECT_NEAR(total, 1.0, 0.001) << "face " << face;
  }
}

}  // namespace
}  // namespace fixrad::host::testing
