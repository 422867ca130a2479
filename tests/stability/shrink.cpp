// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/stability/obj_text.h"
#include "tests/stability/properties.h"

namespace fixrad::host {
namespace {

bool is_lit(const Model& model) {
  return std::any_of(model.faces.begin(), model.faces.end(), [&](const Face& face) {
    return model.materials[face.material].emission != glm::dvec3(0.0);
  });
}

// A scene without light, or one that cannot be put on the grid, is no scene.
std::string checked(const RandomScene& scene, const Property& property) {
  try {
    return is_lit(model_of(scene)) ? property.check(scene) : std::string();
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

Failure shrink(const RandomScene& failing, const Property& property) {
  Failure failure = {failing, checked(failing, property), 0};
  for (bool has_shrunk = true; has_shrunk;) {
    has_shrunk = false;
    for (const RandomScene& next : simpler(failure.scene)) {
      const std::string reason = checked(next, property);
      if (!reason.empty()) {
        failure = {next, reason, failure.steps + 1};
        has_shrunk = true;
        break;
      }
    }
  }
  return failure;
}

std::string report(const Failure& failure, const Property& property) {
  const Model model = model_of(failure.scene);
  return property.name + ": " + failure.reason + "\n  " + describe(failure.scene) + ", made simpler in " +
         std::to_string(failure.steps) + " steps\n  check_scenes --property " + property.name +
         " --first-seed " + std::to_string(failure.scene.seed) + " --count 1\n# scene.obj\n" +
         obj_text(model, "scene.mtl") + "# scene.mtl\n" + mtl_text(model);
}

std::vector<Failure> check_scenes(const Property& property, std::uint64_t first, std::uint64_t count,
                                  std::size_t most, const std::function<void(std::uint64_t)>& progress) {
  std::vector<Failure> failures;
  for (std::uint64_t i = 0; i < count && failures.size() < most; ++i) {
    const RandomScene scene = random_scene(first + i);
    if (!checked(scene, property).empty()) {
      failures.push_back(shrink(scene, property));
    }
    if (progress) {
      progress(i + 1);
    }
  }
  return failures;
}

}  // namespace fixrad::host
