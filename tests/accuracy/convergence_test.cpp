// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "host_sim/io/obj_reader.h"
#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

constexpr double kUnshot = 0.001;
constexpr std::size_t kManyFaces = 100;  // more do not fit those profiles

// Every scene of a folder; rooms are made from their seeds when the test is built.
std::vector<std::string> all_scenes() {
  std::vector<std::string> files;
  for (const std::string& folder :
       {std::string(FIXRAD_SOURCE_DIR) + "/scenes", std::string(FIXRAD_ROOMS_DIR)}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".obj") {
        files.push_back(entry.path().string());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

// With every option that trades certainty for speed.
BakeOptions all_options_on(const std::string& profile, const Model& model) {
  BakeOptions options = on_profile(profile);
  if (model.faces.size() > kManyFaces) {
    options = on_profile("large");
    options.elements = 600;  // seconds instead of half a minute
  }
  options.overshoot = true;
  options.ambient = true;
  options.unshot = kUnshot;
  return options;
}

// The brightest of n elements holds at least 1/n of the unshot flux, and of what it sends at most rho comes
// back: k shots leave at most (1 - (1 - rho) / n)^k (Southwell's method, Gortler et al. 1994, "Radiosity and
// Relaxation Methods"). Overshooting is to need fewer; if it diverged, it would go on.
std::uint32_t most_shots(const Model& model, std::uint32_t elements) {
  double rho = 0;
  for (const Material& material : model.materials) {
    rho = std::max({rho, material.reflectance.x, material.reflectance.y, material.reflectance.z});
  }
  return static_cast<std::uint32_t>(std::ceil(elements * -std::log(kUnshot) / (1 - rho)));
}

class Convergence : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(Convergence, TakesNoMoreShotsThanTheBrightestFirstNeedAndTheLedgerBalances) {
  const Model model = read_obj(std::get<1>(GetParam()), {});
  const PreparedScene prepared = prepare(model);
  const BakeOptions options = all_options_on(std::get<0>(GetParam()), model);
  const std::uint32_t limit = most_shots(model, make_plan(prepared, options).sizes.elements);
  const BakeResult result =
      bake(prepared, options, [limit](std::uint32_t shots, double, double) { return shots <= limit; });
  ASSERT_FALSE(result.interrupted) << result.shots << " shots, " << result.unshot_fraction << " unshot";
  EXPECT_LE(result.shots, limit);
  EXPECT_LE(result.unshot_fraction, kUnshot);
  for (const Ledger& ledger : result.ledger) {
    EXPECT_EQ(ledger.imbalance(), 0);
    EXPECT_GT(ledger.emitted, 0);
    EXPECT_LE(std::abs(static_cast<double>(ledger.unshot)), kUnshot * static_cast<double>(ledger.emitted));
  }
  RecordProperty("shots", static_cast<int>(result.shots));
  RecordProperty("limit", static_cast<int>(limit));
}

INSTANTIATE_TEST_SUITE_P(AllScenes, Convergence,
                         ::testing::Combine(::testing::Values("small", "medium"),
                                            ::testing::ValuesIn(all_scenes())),
                         [](const auto& test) {
                           return std::filesystem::path(std::get<1>(test.param)).stem().string() + "_" +
                                  std::get<0>(test.param);
                         });

}  // namespace
}  // namespace fixrad::host::testing
