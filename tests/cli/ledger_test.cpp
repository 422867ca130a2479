// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

constexpr const char* kColumns[] = {"emitted", "absorbed", "unshot", "escaped", "back"};

// Emitted = absorbed + unshot + escaped + back, in integers, in every carried channel.
void expect_balance(const nlohmann::json& json) {
  const nlohmann::json& ledger = json.at("ledger");
  EXPECT_GT(ledger.at("unit_watts").get<double>(), 0);
  const auto channels = json.at("channels").get<std::size_t>();
  for (const char* column : kColumns) {
    ASSERT_EQ(ledger.at(column).size(), channels) << column;
    for (const auto& value : ledger.at(column)) {
      ASSERT_TRUE(value.is_number_integer()) << column;
      // Overshooting may end with a little more shot than there was.
      EXPECT_TRUE(value.get<std::int64_t>() >= 0 || column == std::string("unshot")) << column << value;
    }
  }
  const auto at = [&](const char* column, std::size_t c) {
    return ledger.at(column).at(c).get<std::int64_t>();
  };
  for (std::size_t c = 0; c < channels; ++c) {
    EXPECT_EQ(at("emitted", c), at("absorbed", c) + at("unshot", c) + at("escaped", c) + at("back", c))
        << "channel " << c;
  }
}

std::vector<std::string> sample_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(FIXRAD_SOURCE_DIR) + "/scenes")) {
    if (entry.path().extension() == ".obj") {
      names.push_back(entry.path().stem());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

class SampleScene : public ::testing::TestWithParam<std::string> {};

TEST_P(SampleScene, LedgerBalancesAndAllIsMeasured) {
  // Hundreds of separate faces do not fit 13 KB.
  const bool is_big = GetParam() == "furnished_room";
  std::vector<std::string> options = {"--profile", "small"};
  if (is_big) {
    options = {"--profile", "large", "--elements", "500"};
  }
  const auto json = baked_json(sample_scene(GetParam()), options);
  for (const char* key : {"profile", "engine", "resolution", "elements", "patches", "vertices", "shots",
                          "seconds", "ram_bytes", "rom_bytes", "unshot_fraction", "digest", "ledger"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  ASSERT_NO_FATAL_FAILURE(expect_balance(json));
  EXPECT_LE(json["unshot_fraction"].get<double>(), 0.001);
  EXPECT_LE(json["ram_bytes"].get<int>(), (is_big ? 480 : 13) * 1024);
  const auto digest = json["digest"].get<std::string>();
  EXPECT_EQ(digest.size(), 16u);
  EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
  if (json["closed"].get<bool>()) {
    for (std::size_t c = 0; c < json["channels"].get<std::size_t>(); ++c) {
      EXPECT_EQ(json["ledger"]["escaped"][c].get<std::int64_t>(), 0);
      EXPECT_EQ(json["ledger"]["back"][c].get<std::int64_t>(), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SampleScene, ::testing::ValuesIn(sample_names()),
                         [](const auto& tested) { return tested.param; });

TEST(Ledger, ScenesWithoutHolesAreFoundClosed) {
  for (const char* name : {"closed_box", "unit_cube_one_emitter", "small_lamp"}) {
    EXPECT_TRUE(baked_json(sample_scene(name), {"--profile", "tiny"})["closed"].get<bool>()) << name;
  }
  for (const char* name : {"cornell", "parallel_plates"}) {
    EXPECT_FALSE(baked_json(sample_scene(name), {"--profile", "tiny"})["closed"].get<bool>()) << name;
  }
}

TEST(Ledger, EmittedFluxIsEmissionTimesLampArea) {
  const auto json = baked_json(sample_scene("unit_cube_one_emitter"), {"--profile", "tiny"});
  const double watts =
      json["ledger"]["unit_watts"].get<double>() * json["ledger"]["emitted"][0].get<double>();
  EXPECT_NEAR(watts, 1.0, 1e-4);
}

TEST(Ledger, GatheringBalancesToo) {
  const auto json = baked_json(sample_scene("cornell"),
                               {"--solver", "gathering", "--elements", "150", "--profile", "large"});
  EXPECT_EQ(json["solver"], "gathering");
  expect_balance(json);
}

TEST(Ledger, PixelsBalanceToo) {
  const auto json =
      baked_json(sample_scene("cornell"), {"--engine", "pixels", "--profile", "small", "--no-overshoot"});
  EXPECT_EQ(json["engine"], "pixels");
  expect_balance(json);
}

TEST(Ledger, OvershootingBalancesToo) {
  expect_balance(baked_json(sample_scene("small_lamp"), {"--overshoot", "--profile", "small"}));
}

}  // namespace
}  // namespace fixrad::host::testing
