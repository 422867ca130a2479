// SPDX-License-Identifier: MIT
#include "host_sim/cli/session.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>
#include <map>

namespace fixrad::host {
namespace {

std::atomic<bool> interrupted{false};

void on_interrupt(int) {
  interrupted = true;
}

void exit_now(int) {
  constexpr char kLine[] = "interrupted: nothing written\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kLine, sizeof kLine - 1);
  _exit(kInterrupted);
}

// How far a point of its plane lies outside a convex element; negative inside.
double distance_outside(const MeshElement& element, const glm::dvec3& point) {
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < element.polygon.size(); ++k) {
    const glm::dvec3 a = element.polygon[k], b = element.polygon[(k + 1) % element.polygon.size()];
    const glm::dvec3 outwards = glm::cross(b - a, element.normal);
    const double length = glm::length(outwards);
    most = length > 0 ? std::max(most, glm::dot(outwards, point - a) / length) : most;
  }
  return std::max(most, std::abs(glm::dot(element.normal, point - element.centroid)));
}

// The element that a displayed triangle is part of: of those that meet at its corners, the one that
// its middle lies in.
std::uint32_t element_of(const BakeResult& result, const std::array<std::uint32_t, 3>& triangle) {
  const glm::dvec3 middle = (result.surface.positions[triangle[0]] + result.surface.positions[triangle[1]] +
                             result.surface.positions[triangle[2]]) /
                            3.0;
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t corner : triangle) {
    const MeshVertex& vertex = result.surface.vertices[corner];
    for (std::uint32_t i = vertex.first; i < vertex.first + vertex.count; ++i) {
      const std::uint32_t e = result.surface.elements[i];
      const double outside = distance_outside(result.device.mesh.elements[e], middle);
      if (outside < least) {
        least = outside;
        best = e;
      }
    }
  }
  return best;
}

// One point light for each element that emits; where these are many, for each patch, or face.
std::vector<BakedLamp> lamps_of(const BakeResult& result) {
  constexpr std::size_t kMany = 64;
  const auto group = [&](std::uint32_t e, int coarseness) {
    const Element& element = result.device.elements[e];
    return coarseness == 0 ? e : std::uint32_t{coarseness == 1 ? element.patch : element.face};
  };
  std::map<std::uint32_t, BakedLamp> lamps;
  for (int coarseness = 0; coarseness == 0 || (lamps.size() > kMany && coarseness < 3); ++coarseness) {
    lamps.clear();
    for (std::uint32_t e = 0; e < result.device.mesh.elements.size(); ++e) {
      const MeshElement& element = result.device.mesh.elements[e];
      if (element.emission != glm::dvec3(0.0)) {
        BakedLamp& lamp = lamps[group(e, coarseness)];
        const double area = lamp.area + element.area;
        lamp.position += (element.centroid - lamp.position) * (element.area / area);
        lamp = {lamp.position, element.normal, area, element.emission};
      }
    }
  }
  std::vector<BakedLamp> list;
  list.reserve(lamps.size());
  for (const auto& [key, lamp] : lamps) {
    list.push_back(lamp);
  }
  return list;
}

void add_appearances(const LoadedScene& scene, const BakeResult& result, BakedMesh& mesh) {
  for (const Material& material : scene.model.materials) {
    mesh.appearances.push_back({material.specular, material.exponent, material.is_mirror});
  }
  for (const auto& triangle : mesh.triangles) {
    const std::uint32_t face = result.device.mesh.elements[element_of(result, triangle)].input_face;
    mesh.triangle_appearance.push_back(scene.model.faces[face].material);
  }
  mesh.lamps = lamps_of(result);
}

bool shows_more_than_diffuse_light(const Model& model) {
  return std::any_of(model.materials.begin(), model.materials.end(),
                     [](const Material& m) { return m.is_mirror || m.exponent > 0.0; });
}

}  // namespace

void catch_interrupt() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool is_interrupted() {
  return interrupted;
}

void exit_on_interrupt() {
  if (interrupted) {
    exit_now(SIGINT);
  }
  std::signal(SIGINT, exit_now);
  std::signal(SIGTERM, exit_now);
}

void check_folder(const std::string& file) {
  const std::filesystem::path path = file;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code unreadable;
  if (!std::filesystem::is_directory(folder, unreadable)) {
    throw InputError(file + ": error: cannot write the file: the folder " + folder.string() +
                     " does not exist; create it or name another file");
  }
}

void say(const CommonOptions& options, const std::string& line) {
  if (!options.quiet) {
    std::cerr << line << '\n';
  }
}

std::unique_ptr<LoadedScene> load_scene(const CommonOptions& options) {
  auto scene = std::make_unique<LoadedScene>();
  scene->model = read_obj(options.scene, options.read);
  for (const std::string& warning : scene->model.warnings) {
    say(options, warning);
  }
  scene->prepared = prepare(scene->model);
  for (const std::string& warning : scene->prepared.warnings) {
    say(options, warning);
  }
  return scene;
}

ProgressBar::ProgressBar(const CommonOptions& options)
    : stop_(options.bake.unshot), visible_(!options.quiet && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
  }
}

// The unshot flux falls roughly like a geometric series, so its logarithm tells how much of the way is done.
bool ProgressBar::update(std::uint32_t shots, double unshot_fraction, double seconds) {
  if (visible_) {
    const double done =
        unshot_fraction > 0 ? std::clamp(std::log(unshot_fraction) / std::log(stop_), 0.0, 1.0) : 1.0;
    const double left = done > 0.02 ? seconds * (1 - done) / done : 0;
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(done * kWidth);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "\r[%s] %u shots, %.3f %% unshot, %.0f s left \033[K", bar.c_str(), shots,
                 100 * unshot_fraction, left);
    drawn_ = true;
  }
  return !interrupted;
}

BakedMesh make_baked_mesh(const LoadedScene& scene, const BakeResult& result) {
  BakedMesh mesh;
  mesh.name = std::filesystem::path(scene.model.path).stem().string();
  mesh.positions = result.surface.positions;
  mesh.normals = result.surface.normals;
  mesh.radiosity = result.vertex_radiosity;
  mesh.triangles = result.surface.triangles;
  for (std::uint32_t e = 0; e < result.device.mesh.elements.size(); ++e) {
    const MeshElement& element = result.device.mesh.elements[e];
    BakedElement baked;
    baked.index = e;
    baked.input_face = element.input_face % static_cast<std::uint32_t>(scene.model.file_faces);
    baked.material = scene.model.materials[scene.model.faces[element.input_face].material].name;
    baked.centroid = element.centroid;
    baked.area = element.area;
    baked.radiosity = result.element_radiosity[e];
    baked.lamp = element.emission != glm::dvec3(0.0);
    mesh.elements.push_back(baked);
  }
  if (shows_more_than_diffuse_light(scene.model)) {
    add_appearances(scene, result, mesh);
  }
  return mesh;
}

std::vector<glm::dvec3> file_face_means(const Model& model, const std::vector<Overlap>& overlaps,
                                        const std::vector<glm::dvec3>& element_radiosity) {
  std::vector<glm::dvec3> means = face_means(model, overlaps, element_radiosity);
  for (std::size_t f = model.file_faces; f < means.size(); ++f) {
    glm::dvec3& front = means[f - model.file_faces];
    front = channel_sum(means[f]) > channel_sum(front) ? means[f] : front;
  }
  means.resize(model.file_faces);
  return means;
}

}  // namespace fixrad::host
