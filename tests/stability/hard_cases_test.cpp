// SPDX-License-Identifier: MIT
// Every hard case within the bound that theory gives it, in the fixed-point core.
#include <gtest/gtest.h>

#include <fstream>
#include <ostream>
#include <sstream>

#include "host_sim/simulate/simulated_device.h"
#include "tests/stability/properties.h"
#include "tests/stability/trial.h"

namespace fixrad::host {
namespace {

[[maybe_unused]] void PrintTo(const HardCase& hard, std::ostream* out) {
  *out << hard.name;
}

class HardCases : public testing::TestWithParam<HardCase> {};

TEST_P(HardCases, EndWithinTheBoundsThatTheoryGives) {
  const Trial trial = try_case(GetParam(), {false, false});
  ASSERT_EQ(trial.status, Status::converged)
      << describe(trial.status) << " after " << trial.shots << " shots";
  for (const Finding& finding : trial.fixed.findings) {
    EXPECT_TRUE(finding.holds()) << finding.what << ": " << finding.value << ", expected " << finding.expected
                                 << " to within " << finding.bound;
  }
  EXPECT_EQ(trial.imbalance, 0) << "flux units";
  EXPECT_EQ(trial.saturated, 0u) << "radiosities";
  if (!GetParam().settings.overshoot) {
    EXPECT_EQ(trial.rises, 0u) << "unshot flux grew in sum";
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, HardCases, testing::ValuesIn(hard_cases()),
                         [](const auto& c) { return c.param.name; });

// scripts/measure_stability.py writes it.
TEST(StabilityPage, TellsOfEveryCaseAndEveryProperty) {
  std::ifstream file(FIXRAD_SOURCE_DIR "/docs/stability.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const HardCase& hard : hard_cases()) {
    EXPECT_NE(page.str().find("\n### " + hard.name + "\n"), std::string::npos) << hard.name;
    EXPECT_NE(page.str().find(hard.theory), std::string::npos) << hard.name;
  }
  for (const Property& property : properties()) {
    EXPECT_NE(page.str().find("| " + property.name + " | " + property.theory + " |"), std::string::npos)
        << property.name;
  }
}

}  // namespace
}  // namespace fixrad::host
