// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <memory>

#include "host_sim/sweep/sweep.h"
#include "tests/bake/sample.h"

namespace fixrad::host::testing {
namespace {

struct Counted {
  BakeResult result;
  Work work = {};
};

Counted count(const std::string& scene, const std::string& engine) {
  const auto loaded = sample(scene);
  BakeOptions options = on_profile("small");
  options.engine = engine;
  options.resolution = 16;
  std::unique_ptr<WorkRecorder> recorder;
  Counted counted;
  counted.result = bake(loaded->prepared, options, {}, [&](const State& state) {
    recorder = std::make_unique<WorkRecorder>(state);
    return recorder->observer();
  });
  counted.work = count_work(counted.result, options, *recorder).value();
  return counted;
}

TEST(Work, CountsEveryEyeWithItsVertices) {
  const Counted c = count("cornell", "lunes");
  EXPECT_EQ(c.work[kEye], c.result.eyes);
  EXPECT_EQ(c.work[kVertex], std::uint64_t{c.result.eyes} * c.result.plan.sizes.vertices);
  EXPECT_EQ(c.work[kFace], std::uint64_t{c.result.eyes} * c.result.plan.sizes.faces);
}

TEST(Work, OfLunesHasFourToRRowsAnEye) {
  const Counted c = count("cornell", "lunes");
  EXPECT_LE(c.work[kRow], 16 * c.work[kEye]);
  EXPECT_GE(c.work[kRow], 4 * c.work[kEye]);
}

TEST(Work, PassesEveryElementAtEveryShot) {
  const Counted c = count("cornell", "lunes");
  EXPECT_EQ(c.work[kElement], std::uint64_t{c.result.shots} * c.result.plan.sizes.elements);
  EXPECT_GT(c.work[kShare], 0u);
  EXPECT_LE(c.work[kShare] + c.work[kFaceShare], c.work[kElement] * c.result.plan.sizes.channels);
}

TEST(Work, AsksEveryElementForItsUnshotFluxTwiceAPass) {
  const Counted c = count("cornell", "lunes");
  EXPECT_GE(c.work[kUnshot], 2 * std::uint64_t{c.result.plan.sizes.elements} * c.result.plan.sizes.channels);
  // In a search for the brightest, every shot would ask every element.
  EXPECT_LT(c.work[kUnshot], c.work[kElement] * c.result.plan.sizes.channels);
}

TEST(Work, OfAHemicubeHasThreeTimesRRowsAnEye) {
  const Counted c = count("cornell", "rows");
  EXPECT_EQ(c.work[kRow], 3 * 16 * c.work[kEye]);
}

TEST(Work, OfPixelsFillsThreeTimesRSquaredPixelsAnEye) {
  const Counted c = count("cornell", "pixels");
  EXPECT_EQ(c.work[kPixel], 3 * 16 * 16 * c.work[kEye]);
  // From inside a closed room every pixel is covered at least once, but for what rounds off along borders.
  EXPECT_GE(static_cast<double>(c.work[kPixelTest]), 0.9 * static_cast<double>(c.work[kPixel]));
}

TEST(Work, InAClosedRoomEveryRowShowsASpanAndEverySpanAPiece) {
  const Counted c = count("closed_box", "lunes");
  EXPECT_GE(c.work[kSpan], c.work[kRow]);
  EXPECT_GE(c.work[kPiece], c.work[kSpan]);
  EXPECT_GE(c.work[kInterval], c.work[kSpan]);  // a box is convex: nothing hides anything
}

TEST(Work, IsTheSameHoweverManyThreadsCount) {
  EXPECT_EQ(count("cornell", "lunes").work, count("cornell", "lunes").work);
}

TEST(Work, HasANameForEveryUnit) {
  EXPECT_THAT(kWorkNames, ::testing::Each(::testing::NotNull()));
  EXPECT_STREQ(kWorkNames[kUnshot], "unshot");
}

TEST(Work, OfAnUnknownEngineIsNotGuessed) {
  const Counted c = count("closed_box", "lunes");
  BakeOptions options;
  options.engine = "an engine to come";
  EXPECT_FALSE(count_work(c.result, options, WorkRecorder(State{})).has_value());
}

TEST(CostModel, HasNoCostForAnEngineThatWasNotMeasured) {
  CostModel model = {};
  model.engines = {"lunes"};
  SweepPoint point;
  point.work = Work{};
  point.options.engine = "lunes";
  EXPECT_TRUE(cost_on(model, point).has_value());
  point.options.engine = "pixels";
  EXPECT_FALSE(cost_on(model, point).has_value());
}

TEST(CostModel, AddsUpWhatStepsCost) {
  CostModel model = {};
  model.weights[kEye] = 100;
  model.weights[kRow] = 2.5;
  Work work = {};
  work[kEye] = 3;
  work[kRow] = 4;
  EXPECT_DOUBLE_EQ(cost(model, work), 310);
}

TEST(CostModel, IsThereForEveryMeasuredTargetAndStaysWithinTenPerCent) {
  for (const char* target :
       {"cortex-m0", "cortex-m3", "cortex-m4f", "cortex-m7", "rv32imc", "atmega2560", "esp8266"}) {
    const CostModel* model = find_cost_model(target);
    ASSERT_NE(model, nullptr) << target;
    EXPECT_LE(model->residual, 0.1) << target;
    EXPECT_GE(model->measurements, 5) << target;
    EXPECT_TRUE(model->knows("lunes")) << target;
    for (const double weight : model->weights) {
      EXPECT_GE(weight, 0) << target;
    }
  }
  EXPECT_EQ(find_cost_model("abacus"), nullptr);
}

}  // namespace
}  // namespace fixrad::host::testing
