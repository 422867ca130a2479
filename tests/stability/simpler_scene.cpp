// SPDX-License-Identifier: MIT
// Steps towards a small scene that still fails.
#include <algorithm>
#include <cmath>

#include "tests/stability/random_scene.h"

namespace fixrad::host {
namespace {

using Steps = std::vector<RandomScene>;

// Adds `scene` changed by `change`, if that changes anything.
template <class Change, class Same>
void add_step(const RandomScene& scene, Steps& steps, Change change, Same is_same) {
  RandomScene next = scene;
  change(next);
  if (!is_same(next)) {
    steps.push_back(std::move(next));
  }
}

void remove_parts(const RandomScene& scene, Steps& steps) {
  if (scene.bodies.size() > 1) {
    RandomScene none = scene;
    none.bodies.clear();
    steps.push_back(none);
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    RandomScene next = scene;
    next.bodies.erase(next.bodies.begin() + static_cast<std::ptrdiff_t>(i));
    steps.push_back(next);
  }
  for (std::size_t f = 0; f < 6 && !scene.is_closed; ++f) {
    add_step(
        scene, steps, [f](RandomScene& s) { s.walls[f] = false; },
        [&](const RandomScene& s) { return s.walls == scene.walls; });
  }
}

void simplify_paints(const RandomScene& scene, Steps& steps) {
  for (std::size_t i = 0; i < scene.paints.size(); ++i) {
    const auto grey = [i](RandomScene& s) {
      RandomScene::Paint& paint = s.paints[i];
      paint.reflectance = glm::ivec3(paint.reflectance.x);
      paint.emission = glm::ivec3(paint.emission.x);
    };
    const auto round = [i](RandomScene& s) {
      RandomScene::Paint& paint = s.paints[i];
      paint.reflectance = glm::ivec3(50);
      paint.emission = glm::ivec3(paint.emission == glm::ivec3(0) ? 0 : 100);
    };
    const auto is_same = [&scene, i](const RandomScene& s) {
      return s.paints[i].reflectance == scene.paints[i].reflectance &&
             s.paints[i].emission == scene.paints[i].emission;
    };
    add_step(scene, steps, round, is_same);
    add_step(scene, steps, grey, is_same);
  }
  const auto one_paint = [](RandomScene& s) { s.wall_paint.fill(0); };
  add_step(scene, steps, one_paint, [&](const RandomScene& s) { return s.wall_paint == scene.wall_paint; });
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    add_step(
        scene, steps, [i](RandomScene& s) { s.bodies[i].material = 0; },
        [&scene, i](const RandomScene& s) { return s.bodies[i].material == scene.bodies[i].material; });
  }
}

void coarsen(const RandomScene& scene, Steps& steps) {
  add_step(
      scene, steps, [](RandomScene& s) { s.elements = 1; },
      [&](const RandomScene& s) { return s.elements == scene.elements; });
  add_step(
      scene, steps, [](RandomScene& s) { s.elements = std::max(1u, s.elements / 2); },
      [&](const RandomScene& s) { return s.elements == scene.elements; });
  add_step(
      scene, steps, [](RandomScene& s) { s.rows = 8; },
      [&](const RandomScene& s) { return s.rows == scene.rows; });
  add_step(
      scene, steps, [](RandomScene& s) { s.overshoot = false; },
      [&](const RandomScene& s) { return s.overshoot == scene.overshoot; });
  add_step(
      scene, steps, [](RandomScene& s) { s.knows_sights = false; },
      [&](const RandomScene& s) { return s.knows_sights == scene.knows_sights; });
}

glm::ivec3 rounded(glm::ivec3 v, int step) {
  return (v + step / 2) / step * step;
}

void round_numbers(const RandomScene& scene, Steps& steps) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto is_same = [&scene, i](const RandomScene& s) {
      const RandomScene::Body &a = s.bodies[i], &b = scene.bodies[i];
      return a.low == b.low && a.size == b.size && a.degrees == b.degrees && a.kind == b.kind;
    };
    add_step(
        scene, steps, [i](RandomScene& s) { s.bodies[i].kind = RandomScene::Kind::box; }, is_same);
    add_step(
        scene, steps, [i](RandomScene& s) { s.bodies[i].degrees = 0; }, is_same);
    for (const int step : {1000, 100, 10}) {
      const auto round = [i, step](RandomScene& s) {
        s.bodies[i].low = rounded(s.bodies[i].low, step);
        s.bodies[i].size = glm::ivec3(std::max(step, rounded(s.bodies[i].size, step).x),
                                      std::max(step, rounded(s.bodies[i].size, step).y),
                                      std::max(step, rounded(s.bodies[i].size, step).z));
      };
      add_step(scene, steps, round, is_same);
    }
  }
}

}  // namespace

std::vector<RandomScene> simpler(const RandomScene& scene) {
  Steps steps;
  remove_parts(scene, steps);
  coarsen(scene, steps);
  simplify_paints(scene, steps);
  round_numbers(scene, steps);
  return steps;
}

}  // namespace fixrad::host
