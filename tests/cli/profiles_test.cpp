// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

TEST(Profiles, SolverStaysWithinTheirMemory) {
  const std::pair<const char*, int> bytes[] = {{"tiny", 6 * 1024},
                                               {"small", 13 * 1024},
                                               {"medium", 60 * 1024},
                                               {"large", 480 * 1024},
                                               {"host", 64 * 1024 * 1024}};
  for (const auto& [profile, most] : bytes) {
    // Memory does not depend on how far the light is followed.
    const auto json = baked_json(sample_scene("cornell"), {"--profile", profile, "--unshot", "0.5"});
    EXPECT_EQ(json["profile"], profile);
    EXPECT_LE(json["ram_bytes"].get<int>(), most) << profile;
    EXPECT_GT(json["ram_bytes"].get<int>(), 0) << profile;
  }
}

TEST(Profiles, SmallCarriesTheCornellBoxInEightKilobytes) {
  const auto json = baked_json(sample_scene("cornell"), {"--profile", "small"});
  EXPECT_EQ(json["channels"], 3);
  EXPECT_GE(json["resolution"].get<int>(), 16);
  EXPECT_GE(json["elements"].get<int>(), 250);
  EXPECT_LE(json["ram_bytes"].get<int>(), 8192);
}

TEST(Profiles, AFurtherElementCostsAtMost22Bytes) {
  int fewest = 0, least = 0, widest = 0;
  for (int wanted = 260; wanted <= 400; wanted += 10) {
    const auto json = baked_json(sample_scene("cornell"), {"--profile", "small", "--unshot", "0.5",
                                                           "--elements", std::to_string(wanted)});
    const int elements = json["elements"].get<int>(), bytes = json["ram_bytes"].get<int>();
    if (fewest == 0) {
      fewest = elements;
      least = bytes;
    }
    // Two elements share a word of accounts in each of three channels.
    EXPECT_LE(bytes - least, 22 * (elements - fewest) + 6) << elements << " elements";
    widest = std::max(widest, elements - fewest);
  }
  EXPECT_GE(widest, 20) << "nothing was compared";
}

TEST(Profiles, ElementsStayBelowTheWantedNumber) {
  for (const int most : {40, 100, 333}) {
    const auto json = baked_json(sample_scene("cornell"), {"--profile", "large", "--elements",
                                                           std::to_string(most), "--unshot", "0.1"});
    EXPECT_LE(json["elements"].get<int>(), most);
    EXPECT_GT(json["elements"].get<int>(), most / 2);
  }
}

TEST(Profiles, GreySceneCarriesOneChannelInLessMemory) {
  const auto grey = baked_json(sample_scene("cornell_grey"), {"--profile", "small"});
  const auto colour = baked_json(sample_scene("cornell"), {"--profile", "small"});
  EXPECT_EQ(grey["channels"], 1);
  EXPECT_EQ(grey["ledger"]["emitted"].size(), 1u);
  EXPECT_LT(grey["ram_bytes"].get<int>(), colour["ram_bytes"].get<int>());
}

}  // namespace
}  // namespace fixrad::host::testing
