// SPDX-License-Identifier: MIT
#include "tests/stability/random_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "host_sim/reference/counter_random.h"
#include "tests/stability/hard_scenes.h"

namespace fixrad::host {
namespace {

using Body = RandomScene::Body;
using Kind = RandomScene::Kind;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed, 0, 0) {}

  /// low .. high, both included.
  int between(int low, int high) { return low + static_cast<int>((high - low + 1) * random_.next()); }
  bool chance(int per_cent) { return between(1, 100) <= per_cent; }

 private:
  CounterRandom random_;
};

glm::ivec3 colour(Dice& dice, int low, int high, bool is_grey) {
  glm::ivec3 c;
  c.x = dice.between(low, high);
  c.y = is_grey ? c.x : dice.between(low, high);
  c.z = is_grey ? c.x : dice.between(low, high);
  return c;
}

// Bodies keep to the inside of the room: a twentieth of it from the walls, the floor excepted. They may run
// through each other.
Body random_body(Dice& dice, const RandomScene& scene) {
  const int kinds = scene.is_closed ? 1 : 3;
  Body body = {static_cast<Kind>(dice.between(0, kinds)),
               {},
               {},
               dice.chance(50) ? 0 : dice.between(1, 89),
               static_cast<std::uint32_t>(dice.between(0, static_cast<int>(scene.paints.size()) - 1))};
  for (int k = 0; k < 3; ++k) {
    const int margin = scene.room[k] / 20;
    body.size[k] = dice.between(margin, scene.room[k] * 2 / 5);
    body.low[k] = dice.between(margin, scene.room[k] - margin - body.size[k]);
  }
  if (body.kind == Kind::box && dice.chance(30)) {
    body.low.y = 0;
  }
  // A turned box needs room for its diagonal.
  const int longest = std::max(body.size.x, body.size.z);
  for (const int k : {0, 2}) {
    const int reach = longest / 4 + 1;
    body.low[k] = std::clamp(body.low[k], reach, std::max(reach, scene.room[k] - body.size[k] - reach));
  }
  return body;
}

void choose_paints(Dice& dice, RandomScene& scene) {
  const bool is_grey = dice.chance(50);
  const int lamps = dice.between(1, 2);
  const int count = dice.between(2, 4);
  for (int i = 0; i < count; ++i) {
    scene.paints.push_back(
        {colour(dice, 0, 95, is_grey), i < lamps ? colour(dice, 10, 900, is_grey) : glm::ivec3(0)});
  }
}

void choose_solution(Dice& dice, RandomScene& scene) {
  const int hemisphere = dice.between(0, 9);
  scene.hemisphere = hemisphere == 0   ? RandomScene::Hemisphere::pixels
                     : hemisphere <= 2 ? RandomScene::Hemisphere::hemicube
                                       : RandomScene::Hemisphere::lunes;
  scene.rows = 8 << dice.between(0, scene.hemisphere == RandomScene::Hemisphere::lunes ? 2 : 1);
  scene.elements = static_cast<std::uint32_t>(dice.between(1, 60));
  scene.overshoot = dice.chance(50);
  scene.knows_sights = dice.chance(50);
}

glm::dvec3 rounded(glm::dvec3 p) {
  return glm::round(p);
}

// A model's corners on whole units: what its maker means by a grid.
void round_corners(Model& model) {
  for (glm::dvec3& p : model.positions) {
    p = rounded(p);
  }
}

void add_body(ModelBuilder& builder, const Body& body) {
  const glm::dvec3 low(body.low), size(body.size), high = low + size;
  const double angle = glm::radians(static_cast<double>(body.degrees));
  if (body.kind == Kind::box) {
    builder.box(low, high, angle, body.material);
  } else if (body.kind == Kind::octahedron) {
    const double radius = std::min({size.x, size.y, size.z}) / 2;
    builder.octahedron(low + size / 2.0, radius, angle, body.material);
  } else {
    std::vector<glm::dvec3> corners = {low, {high.x, low.y, low.z}, high, {low.x, high.y, high.z}};
    if (body.kind == Kind::triangle) {
      corners.pop_back();
    }
    builder.polygon(corners, body.material);
  }
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) {
  Dice dice(seed);
  RandomScene scene;
  scene.seed = seed;
  scene.is_closed = dice.chance(50);
  scene.room = glm::ivec3(dice.between(6000, 16000), dice.between(6000, 16000), dice.between(6000, 16000));
  scene.room[dice.between(0, 2)] = static_cast<int>(kGridRoom);
  choose_paints(dice, scene);
  const auto last = static_cast<int>(scene.paints.size()) - 1;
  bool is_lit = false;
  for (std::size_t f = 0; f < 6; ++f) {
    scene.walls[f] = scene.is_closed || f == 2 || dice.chance(60);
    scene.wall_paint[f] = static_cast<std::uint32_t>(dice.between(1, last));
    is_lit = is_lit || (scene.walls[f] && scene.paints[scene.wall_paint[f]].emission != glm::ivec3(0));
  }
  const int bodies = dice.between(0, 4);
  for (int i = 0; i < bodies; ++i) {
    scene.bodies.push_back(random_body(dice, scene));
    is_lit = is_lit || scene.paints[scene.bodies.back().material].emission != glm::ivec3(0);
  }
  if (!is_lit) {
    scene.wall_paint[2] = 0;
  }
  choose_solution(dice, scene);
  return scene;
}

Model model_of(const RandomScene& scene) {
  ModelBuilder whole, builder;
  whole.room(glm::dvec3(0.0), glm::dvec3(scene.room), {0, 0, 0, 0, 0, 0});
  for (const RandomScene::Paint& paint : scene.paints) {
    builder.material(glm::dvec3(paint.reflectance) / 100.0, glm::dvec3(paint.emission) / 100.0);
  }
  for (std::size_t f = 0; f < 6; ++f) {
    if (scene.walls[f]) {
      std::vector<glm::dvec3> corners;
      for (const std::uint32_t v : whole.model().faces[f].corners) {
        corners.push_back(whole.model().positions[v]);
      }
      builder.polygon(corners, scene.wall_paint[f]);
    }
  }
  for (const Body& body : scene.bodies) {
    add_body(builder, body);
  }
  Model model = builder.model();
  model.path = "seed " + std::to_string(scene.seed);
  round_corners(model);
  return model;
}

std::string describe(const RandomScene& scene) {
  constexpr const char* kNames[] = {"lunes", "hemicube", "pixels"};
  return "seed " + std::to_string(scene.seed) + (scene.is_closed ? ", closed" : ", open") + ", " +
         std::to_string(scene.bodies.size()) + " bodies, at most " + std::to_string(scene.elements) +
         " elements, " + kNames[static_cast<int>(scene.hemisphere)] + " R = " + std::to_string(scene.rows) +
         (scene.overshoot ? ", overshooting" : "") + (scene.knows_sights ? ", sights known" : "");
}

}  // namespace fixrad::host
