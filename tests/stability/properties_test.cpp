// SPDX-License-Identifier: MIT
// Properties of random scenes. More of them: build/host/tests/stability/check_scenes --count 100000
#include "tests/stability/properties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "host_sim/io/obj_reader.h"
#include "tests/report/scratch_folder.h"
#include "tests/stability/bench.h"
#include "tests/stability/obj_text.h"

namespace fixrad::host {
namespace {

// So many scenes of each property take some seconds.
std::uint64_t scenes_of(const std::string& name) {
  static const std::map<std::string, std::uint64_t> counts = {{"KeepsItsBooks", 2000},
                                                              {"ExchangeIsReciprocal", 30}};
  const auto found = counts.find(name);
  return found != counts.end() ? found->second : 150;
}

[[maybe_unused]] void PrintTo(const Property& property, std::ostream* out) {
  *out << property.name;
}

class RandomScenes : public ::testing::TestWithParam<Property> {};

TEST_P(RandomScenes, Keep) {
  const Property& property = GetParam();
  for (const Failure& failure : check_scenes(property, 0, scenes_of(property.name), 3)) {
    ADD_FAILURE() << report(failure, property);
  }
}

INSTANTIATE_TEST_SUITE_P(Property, RandomScenes, ::testing::ValuesIn(properties()),
                         [](const auto& p) { return p.param.name; });

TEST(RandomScene, DependsOnItsSeedAlone) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_EQ(obj_text(model_of(random_scene(seed)), "m"), obj_text(model_of(random_scene(seed)), "m"));
    EXPECT_NE(obj_text(model_of(random_scene(seed)), "m"), obj_text(model_of(random_scene(seed + 1)), "m"));
  }
}

// What is never made tests nothing.
TEST(RandomScene, IsClosedOrOpenGreyOrColouredWithOneLampOrMoreAndOfEveryKind) {
  std::map<std::string, int> seen;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const RandomScene scene = random_scene(seed);
    const Bench bench(model_of(scene), scene, settings_of(scene));
    ++seen[scene.is_closed ? "closed" : "open"];
    ++seen[bench.device().channels == 1 ? "grey" : "coloured"];
    ++seen["hemisphere " + std::to_string(static_cast<int>(scene.hemisphere))];
    ++seen[scene.overshoot ? "overshooting" : "plain"];
    ++seen[scene.bodies.empty() ? "empty" : "furnished"];
    for (const RandomScene::Body& body : scene.bodies) {
      ++seen["body " + std::to_string(static_cast<int>(body.kind))];
      ++seen[scene.paints[body.material].emission == glm::ivec3(0) ? "dark body" : "lit body"];
    }
  }
  EXPECT_EQ(seen.size(), 17u);
  for (const auto& [what, count] : seen) {
    EXPECT_GE(count, 10) << what;
  }
}

// A property that fails, to see what shrinking makes of it.
const Property kNoOctahedron = {"NoOctahedron", "", [](const RandomScene& scene) {
                                  const bool has = std::any_of(
                                      scene.bodies.begin(), scene.bodies.end(), [](const auto& body) {
                                        return body.kind == RandomScene::Kind::octahedron;
                                      });
                                  return has ? std::string("an octahedron") : std::string();
                                }};

TEST(Shrinking, LeavesOfAFailingSceneWhatMakesItFail) {
  const std::vector<Failure> failures = check_scenes(kNoOctahedron, 0, 50, 5);
  ASSERT_EQ(failures.size(), 5u);
  for (const Failure& failure : failures) {
    EXPECT_EQ(failure.reason, "an octahedron");
    EXPECT_GT(failure.steps, 0u);
    ASSERT_EQ(failure.scene.bodies.size(), 1u);
    EXPECT_EQ(failure.scene.bodies[0].kind, RandomScene::Kind::octahedron);
    EXPECT_EQ(failure.scene.bodies[0].degrees, 0);
    EXPECT_EQ(failure.scene.bodies[0].low % 1000, glm::ivec3(0));
    EXPECT_EQ(failure.scene.elements, 1u);
    EXPECT_FALSE(failure.scene.overshoot);
    for (std::size_t f = 0; f < 6 && !failure.scene.is_closed; ++f) {
      // A wall is left only if it is the lamp: without light there is no scene.
      EXPECT_TRUE(!failure.scene.walls[f] ||
                  failure.scene.paints[failure.scene.wall_paint[f]].emission.x > 0);
    }
  }
}

// The same of a property that only a solution can tell.
const Property kAbsorbsLittle = {"AbsorbsLittle", "", [](const RandomScene& scene) {
                                   Bench bench(model_of(scene), scene, settings_of(scene));
                                   const bool fails = bench.status() == Status::ok && bench.run() &&
                                                      ledger(bench.state(), 0).absorbed * 2 >
                                                          ledger(bench.state(), 0).emitted;
                                   return fails ? std::string("absorbs more than half") : std::string();
                                 }};

TEST(Shrinking, KeepsASceneFailingAtEveryStep) {
  const std::vector<Failure> failures = check_scenes(kAbsorbsLittle, 0, 50, 3);
  ASSERT_EQ(failures.size(), 3u);
  for (const Failure& failure : failures) {
    EXPECT_EQ(kAbsorbsLittle.check(failure.scene), failure.reason);
    EXPECT_LE(model_of(failure.scene).faces.size(), model_of(random_scene(failure.scene.seed)).faces.size());
    for (const RandomScene& next : simpler(failure.scene)) {
      const bool is_lit = next.paints[0].emission != glm::ivec3(0);
      EXPECT_TRUE(!is_lit || kAbsorbsLittle.check(next).empty()) << "could be simpler still";
    }
  }
}

TEST(Shrinking, PrintsASceneThatTheReaderReads) {
  const std::vector<Failure> failures = check_scenes(kNoOctahedron, 0, 50, 1);
  ASSERT_EQ(failures.size(), 1u);
  const std::string text = report(failures[0], kNoOctahedron);
  const Model model = model_of(failures[0].scene);
  EXPECT_NE(text.find(obj_text(model, "scene.mtl")), std::string::npos);
  EXPECT_NE(text.find("--first-seed " + std::to_string(failures[0].scene.seed)), std::string::npos);
  const testing::ScratchFolder folder;
  const Model read = read_obj(write_obj(model, (folder / "").string(), "scene"));
  ASSERT_EQ(read.faces.size(), model.faces.size());
  for (std::size_t f = 0; f < read.faces.size(); ++f) {
    EXPECT_EQ(read.faces[f].corners, model.faces[f].corners);
    EXPECT_EQ(read.materials[read.faces[f].material].reflectance,
              model.materials[model.faces[f].material].reflectance);
  }
}

}  // namespace
}  // namespace fixrad::host
