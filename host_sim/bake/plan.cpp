// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/bake/bake.h"
#include "host_sim/bake/occlusion.h"
#include "host_sim/meshing/discontinuity.h"
#include "host_sim/simulate/adaptive_mesh.h"

namespace fixrad::host {
namespace {

constexpr const char* kUniform = "uniform";
constexpr std::uint32_t kMostElements = 60000;                      // the core numbers them in 16 bits
constexpr std::uint32_t kMostCutElements = kLeaf;                   // and those of cut cells in 15
constexpr std::uint64_t kMostMatrixBytes = std::uint64_t{1} << 31;  // more than any profile has
constexpr std::uint32_t kPiercing = 8;  // spans beyond twice the faces, for faces that pierce each other

// Elements that a profile's accuracy needs: its own number, and several a face where there are many faces.
std::uint32_t default_elements(const Profile& profile, std::uint32_t faces) {
  return std::min(kMostElements, std::max(profile.elements, faces * 10u));
}

// Elements shoot in patches of about so many once each has little left to send.
constexpr std::uint32_t kElementsOfPatch = 4;

constexpr int kRays = 16;  // a pair

bool is_hemicube(const std::string& engine) {
  return engine == "rows" || engine == "pixels";
}

int default_resolution(const std::string& engine, const Profile& profile) {
  return engine == "rays" ? kRays : (is_hemicube(engine) ? profile.hemicube : profile.lunes);
}

Engine engine_named(const std::string& name) {
  if (name == "rays") {
    return ray_row;
  }
  if (name == "contour") {
    return contour_row;
  }
  return name == "pixels" ? hemicube_pixels : (name == "rows" ? hemicube_rows : lune_rows);
}

Meshing make_mesh(const PreparedScene& scene, const std::string& kind, std::uint32_t wanted) {
  const std::uint32_t elements = kind == kUniform ? wanted : std::min(wanted, kMostCutElements);
  const std::uint32_t patches = elements / kElementsOfPatch;
  if (kind == "adaptive") {
    return make_adaptive(scene, elements, patches);
  }
  if (kind == "discontinuity") {
    return make_discontinuity(scene, elements, patches);
  }
  return kind == "contacts" ? make_contact_mesh(scene, elements, patches)
                            : make_uniform(scene, elements, patches);
}

// Everything but the mesh, for a mesh of `n` elements.
BakePlan plan_of_size(const PreparedScene& scene, const BakeOptions& options, const Profile& profile,
                      std::uint32_t n) {
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  BakePlan plan;
  plan.profile = profile;
  plan.resolution = options.resolution.value_or(default_resolution(options.engine, profile));
  const auto channels = static_cast<std::uint32_t>(scene.channels);
  plan.sizes = {static_cast<std::uint32_t>(scene.vertices.positions.size()),
                faces,
                n,
                std::min(65535u, 2 * faces + 1 + kPiercing),
                channels,
                options.engine == "pixels" ? static_cast<std::uint32_t>(plan.resolution) : 0u};
  if (options.solver == "gathering") {
    const std::uint64_t bytes = std::uint64_t{n} * n * 2 + std::uint64_t{n} * (2 + 4 * channels);
    plan.matrix_bytes = static_cast<std::uint32_t>(std::min(bytes, kMostMatrixBytes));
  }
  plan.overshoot = options.overshoot;
  return plan;
}

BakePlan plan_for(const PreparedScene& scene, const BakeOptions& options, const Profile& profile,
                  const std::string& mesh, std::uint32_t elements) {
  Meshing meshing = make_mesh(scene, mesh, elements);
  BakePlan plan = plan_of_size(scene, options, profile, meshing.element_count);
  plan.meshing = std::move(meshing);
  return plan;
}

std::string does_not_fit(const PreparedScene& scene, const BakePlan& plan) {
  return scene.model->path + ": error: the scene does not fit profile " + plan.profile.name +
         ": with one element on each of its " + std::to_string(plan.sizes.faces) + " faces it needs " +
         std::to_string(plan.ram()) + " bytes of " + std::to_string(plan.profile.ram_bytes) +
         "; use a larger --profile or a simpler scene";
}

std::string too_many_faces(const PreparedScene& scene) {
  return scene.model->path + ": error: the scene has more than " + std::to_string(kMostElements) +
         " faces; simplify it";
}

int line_of_face(const PreparedScene& scene, std::uint32_t face) {
  return scene.model->faces[scene.faces[face].parts.front().input_face].line;
}

void refuse_occlusion(const PreparedScene& scene) {
  if (const auto found = find_occlusion(scene)) {
    throw InputError(scene.model->path + ":" + std::to_string(line_of_face(scene, found->blocker)) +
                     ": error: this face may hide a part of the face of line " +
                     std::to_string(line_of_face(scene, found->from)) + " from that of line " +
                     std::to_string(line_of_face(scene, found->to)) +
                     ", which --engine contour does not notice; use --engine rays or lunes");
  }
}

}  // namespace

bool has_resolution(const std::string& engine, int resolution) {
  return engine == "rays" ? resolution >= 4 && resolution <= 32 : resolution >= 8;
}

BakePlan make_plan(const PreparedScene& scene, const BakeOptions& options) {
  if (options.engine == "contour") {
    refuse_occlusion(scene);
  }
  const Profile profile = find_profile(options.profile).value();
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  if (faces > kMostElements) {
    throw InputError(too_many_faces(scene));
  }
  const BakePlan least = plan_of_size(scene, options, profile, faces);
  if (least.ram() > profile.ram_bytes) {  // before meshes are made to find that out
    throw InputError(does_not_fit(scene, least));
  }
  std::uint32_t elements =
      std::min(kMostElements, options.elements.value_or(default_elements(profile, faces)));
  for (;;) {
    BakePlan plan = plan_for(scene, options, profile, kUniform, elements);
    if (options.elements && plan.sizes.elements > std::max(elements, faces)) {
      throw InputError(scene.model->path + ": error: more elements than faces are needed; raise --elements");
    }
    if (plan.sizes.elements > kMostElements) {
      throw InputError(too_many_faces(scene));
    }
    if (plan.ram() <= profile.ram_bytes && options.mesh != kUniform) {
      plan =
          plan_for(scene, options, profile, options.mesh, elements);  // takes long: once the memory is known
    }
    if (plan.ram() <= profile.ram_bytes) {
      return plan;
    }
    if (elements <= faces || plan.sizes.elements <= faces) {
      throw InputError(does_not_fit(scene, plan));
    }
    elements = std::max(faces, std::min(elements, plan.sizes.elements) * 9 / 10);
  }
}

Settings make_settings(const BakeOptions& options, const BakePlan& plan) {
  const auto to_fraction = [](double a) {
    return Fraction::from_raw(static_cast<std::uint32_t>(std::clamp(std::ldexp(a, 32), 0.0, 4294967295.0)));
  };
  Settings settings;
  settings.engine = engine_named(options.engine);
  settings.tables = is_hemicube(options.engine) ? delta_table(plan.resolution) : lune_table(plan.resolution);
  settings.table_count = 1;
  if (options.engine == "lunes") {
    settings.table_count = static_cast<std::uint8_t>(settings.tables - kLunes + 1);
    settings.tables = kLunes;
  }
  settings.stop = to_fraction(options.unshot);
  settings.flux_per_row =
      to_fraction(options.flux_per_row.value_or(plan.profile.flux_of_rows / plan.sizes.elements));
  settings.flux_per_eye = to_fraction(options.flux_per_eye.value_or(plan.profile.flux_per_eye));
  settings.overshoot = plan.overshoot;
  settings.near_field = options.near_field ? correct_near_field : nullptr;
  return settings;
}

}  // namespace fixrad::host
