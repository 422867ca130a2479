// SPDX-License-Identifier: MIT
#include <cmath>
#include <sstream>

#include "tests/cli/tool.h"

namespace fixrad::host::testing {
namespace {

struct TruthRow {
  std::string material;
  double face = -1, emits = -1, area = 0, b = 0, error = 0;  // of the red channel
};

std::vector<TruthRow> traced(const std::string& scene) {
  const ScratchFolder folder;
  const Outcome run = run_tool({"truth", scene, "--csv", folder / "truth.csv", "--paths", "400000"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto lines = lines_of(contents(folder / "truth.csv"));
  if (lines.empty() || lines.front() != "face,material,emits,area,B_r,B_g,B_b,error_r,error_g,error_b") {
    ADD_FAILURE() << "no header";
    return {};
  }
  std::vector<TruthRow> rows;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    std::istringstream line(lines[k]);
    std::vector<std::string> fields;
    for (std::string field; std::getline(line, field, ',');) {
      fields.push_back(field);
    }
    EXPECT_EQ(fields.size(), 10u) << lines[k];
    rows.push_back({fields[1], std::stod(fields[0]), std::stod(fields[2]), std::stod(fields[3]),
                    std::stod(fields[4]), std::stod(fields[7])});
  }
  return rows;
}

// Every face emits 1 W/m^2 and reflects a half: B = E / (1 - rho).
TEST(TruthCommand, OfAFurnaceIsTheClosedFormOnEveryFace) {
  const auto rows = traced(sample_scene("closed_box"));
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t f = 0; f < rows.size(); ++f) {
    EXPECT_EQ(rows[f].face, f);
    EXPECT_EQ(rows[f].emits, 1);
    EXPECT_DOUBLE_EQ(rows[f].area, 1);
    EXPECT_GT(rows[f].error, 0);
    EXPECT_LT(rows[f].error, 0.01);
    EXPECT_NEAR(rows[f].b, 2, 5 * rows[f].error);
  }
}

// In a closed scene of one reflectance what is emitted is absorbed: sum of A (1 - rho) B = sum of A E.
TEST(TruthCommand, OfACubeWithOneEmitterKeepsItsEnergy) {
  const auto rows = traced(sample_scene("unit_cube_one_emitter"));
  ASSERT_EQ(rows.size(), 6u);
  double sum = 0, variance = 0, lamps = 0;
  for (const TruthRow& row : rows) {
    sum += row.area * row.b;
    variance += row.area * row.error * row.area * row.error;
    lamps += row.emits;
  }
  EXPECT_EQ(lamps, 1);
  EXPECT_NEAR(sum, 1 / (1 - 0.5), 5 * std::sqrt(variance));
}

TEST(TruthCommand, NamesAFolderThatIsNotThere) {
  const Outcome run = run_tool({"truth", sample_scene("closed_box"), "--csv", "no_such_folder/truth.csv"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("no_such_folder"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace fixrad::host::testing
