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
constexpr double kBound = 0.001;  // relative

using Factors = std::map<std::pair<int, int>, double>;

Factors form_factors_of(const std::string& scene, const std::vector<std::string>& options = {}) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = {"form-factors", scene, "--csv", folder / "factors.csv"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = run_tool(arguments);
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
  EXPECT_NEAR(factors.at({0, 1}), kOpposite, kBound * kOpposite);
  EXPECT_NEAR(factors.at({1, 0}), kOpposite, kBound * kOpposite);
}

TEST(FormFactorsCommand, FacesOfACubeMeetTheClosedFormsAndSumToOne) {
  const Factors factors = form_factors_of(sample_scene("closed_box"));
  ASSERT_EQ(factors.size(), 30u);  // no face sees itself
  std::map<int, double> sum;
  for (const auto& [pair, factor] : factors) {
    const auto [i, j] = pair;
    const bool is_opposite = i / 2 == j / 2;  // the file lists opposite faces one after the other
    const double expected = is_opposite ? kOpposite : kAdjacent;
    EXPECT_NEAR(factor, expected, kBound * expected) << i << ',' << j;
    sum[i] += factor;
  }
  ASSERT_EQ(sum.size(), 6u);
  for (const auto& [face, total] : sum) {
    EXPECT_NEAR(total, 1.0, 0.001) << "face " << face;
  }
}

TEST(FormFactorsCommand, EveryEngineMeetsTheClosedFormsOfACube) {
  constexpr double kRows = 0.01;  // of a few hundred elements
  for (const char* engine : {"pixels", "rows", "lunes", "rays", "contour"}) {
    const Factors factors =
        form_factors_of(sample_scene("closed_box"), {"--engine", engine, "--elements", "216"});
    ASSERT_EQ(factors.size(), 30u) << engine;
    EXPECT_NEAR(factors.at({0, 1}), kOpposite, kRows * kOpposite) << engine;
    EXPECT_NEAR(factors.at({0, 2}), kAdjacent, kRows * kAdjacent) << engine;
  }
}

TEST(FormFactorsCommand, RowsOfARoomWithHiddenPairsAddUpToOne) {
  std::map<int, double> sum;
  for (const auto& [pair, factor] : form_factors_of(sample_scene("small_lamp"))) {
    sum[pair.first] += factor;
  }
  ASSERT_EQ(sum.size(), 18u);
  for (const auto& [face, total] : sum) {
    EXPECT_NEAR(total, 1.0, 0.01) << "face " << face;
  }
}

}  // namespace
}  // namespace fixrad::host::testing
