// SPDX-License-Identifier: MIT
#include "tests/lib/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host_sim/io/obj_reader.h"

namespace fixrad::host {
namespace {

constexpr int kFaceOfBox[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                  {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};  // seen from inside

glm::dvec3 box_corner(glm::dvec3 low, glm::dvec3 high, int bits) {
  return {(bits & 1) != 0 ? high.x : low.x, (bits & 2) != 0 ? high.y : low.y,
          (bits & 4) != 0 ? high.z : low.z};
}

glm::dvec3 turned(glm::dvec3 p, glm::dvec3 about, double angle) {
  const glm::dvec3 d = p - about;
  const double c = std::cos(angle), s = std::sin(angle);
  return about + glm::dvec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
}

glm::dvec3 random_colour(Random& random, double low, double high) {
  const double r = random.real(low, high), g = random.real(low, high), b = random.real(low, high);
  return {r, g, b};
}

// A lamp floats: a lit bottom that lies in the floor would shine into nothing.
void random_body(Random& random, ModelBuilder& builder, glm::dvec3 middle, double radius,
                 std::uint32_t material, bool is_lamp) {
  const double angle = random.real(0.0, 1.5);
  if (random.between(0, 2) == 0) {
    builder.octahedron({middle.x, radius + random.real(0.05, 0.5), middle.z}, radius, angle, material);
    return;
  }
  const double bottom = !is_lamp && random.between(0, 1) == 0 ? 0.0 : random.real(0.05, 0.6);
  const double x = radius * random.real(0.2, 0.7), z = radius * random.real(0.2, 0.7);
  const double height = random.real(0.1, 1.2);
  builder.box({middle.x - x, bottom, middle.z - z}, {middle.x + x, bottom + height, middle.z + z}, angle,
              material);
}

}  // namespace

std::uint32_t ModelBuilder::material(glm::dvec3 reflectance, glm::dvec3 emission) {
  model_.materials.push_back({"m" + std::to_string(model_.materials.size()), reflectance, emission});
  return static_cast<std::uint32_t>(model_.materials.size() - 1);
}

std::uint32_t ModelBuilder::vertex(glm::dvec3 p) {
  const auto it = std::find(model_.positions.begin(), model_.positions.end(), p);
  if (it != model_.positions.end()) {
    return static_cast<std::uint32_t>(it - model_.positions.begin());
  }
  model_.positions.push_back(p);
  return static_cast<std::uint32_t>(model_.positions.size() - 1);
}

void ModelBuilder::polygon(const std::vector<glm::dvec3>& corners, std::uint32_t material) {
  Face face;
  for (const glm::dvec3& p : corners) {
    face.corners.push_back(vertex(p));
  }
  face.material = material;
  face.line = static_cast<int>(model_.faces.size()) + 1;
  model_.faces.push_back(face);
  model_.file_faces = model_.faces.size();
}

void ModelBuilder::room(glm::dvec3 low, glm::dvec3 high, const std::array<std::uint32_t, 6>& materials) {
  for (std::size_t f = 0; f < 6; ++f) {
    std::vector<glm::dvec3> corners;
    for (const int bits : kFaceOfBox[f]) {
      corners.push_back(box_corner(low, high, bits));
    }
    polygon(corners, materials[f]);
  }
}

void ModelBuilder::box(glm::dvec3 low, glm::dvec3 high, double angle, std::uint32_t material,
                       bool has_bottom) {
  const glm::dvec3 middle = (low + high) / 2.0;
  for (std::size_t f = 0; f < 6; ++f) {
    if (f == 2 && !has_bottom) {
      continue;
    }
    std::vector<glm::dvec3> corners;
    for (const int bits : kFaceOfBox[f]) {
      corners.push_back(turned(box_corner(low, high, bits), middle, angle));
    }
    std::reverse(corners.begin(), corners.end());
    polygon(corners, material);
  }
}

void ModelBuilder::octahedron(glm::dvec3 middle, double radius, double angle, std::uint32_t material) {
  const double c = std::cos(angle) * radius, s = std::sin(angle) * radius, t = 0.6 * s, u = 0.8 * s;
  // A rotation's columns: about y by `angle` with the axis tilted by (0.6, 0.8).
  const glm::dvec3 x(c, t, u), z = {-s, 0.6 * c, 0.8 * c}, y(0.0, 0.8 * radius, -0.6 * radius);
  for (int bits = 0; bits < 8; ++bits) {
    const glm::dvec3 a = middle + ((bits & 1) != 0 ? x : -x);
    const glm::dvec3 b = middle + ((bits & 2) != 0 ? y : -y);
    const glm::dvec3 d = middle + ((bits & 4) != 0 ? z : -z);
    const bool is_mirrored = ((bits & 1) + ((bits >> 1) & 1) + ((bits >> 2) & 1)) % 2 == 0;
    polygon(is_mirrored ? std::vector{a, d, b} : std::vector{a, b, d}, material);
  }
}

Model cube(double reflectance, const std::array<double, 6>& emission) {
  ModelBuilder builder;
  std::array<std::uint32_t, 6> materials{};
  for (std::size_t f = 0; f < 6; ++f) {
    materials[f] = builder.material(glm::dvec3(reflectance), glm::dvec3(emission[f]));
  }
  builder.room(glm::dvec3(0.0), glm::dvec3(1.0), materials);
  return builder.model();
}

Model random_closed_room(std::uint32_t seed) {
  Random random(seed);
  ModelBuilder builder;
  const glm::dvec3 size(random.real(3.0, 6.0), random.real(2.4, 3.0), random.real(3.0, 6.0));
  std::array<std::uint32_t, 6> walls{};
  const bool has_lit_wall = random.between(0, 1) == 0;
  for (std::size_t f = 0; f < 6; ++f) {
    const bool is_lamp = has_lit_wall && f == seed % 6;
    walls[f] = builder.material(random_colour(random, 0.0, 0.95),
                                is_lamp ? random_colour(random, 0.1, 9.0) : glm::dvec3(0.0));
  }
  builder.room(glm::dvec3(0.0), size, walls);
  const int bodies = random.between(1, 4);
  for (int i = 0; i < bodies; ++i) {
    const glm::dvec3 middle(size.x * (i % 2 == 0 ? 0.25 : 0.75), 0.0, size.z * (i < 2 ? 0.25 : 0.75));
    const bool is_lamp = !has_lit_wall && i == 0;
    const std::uint32_t material = builder.material(
        random_colour(random, 0.0, 0.9), is_lamp ? random_colour(random, 0.1, 9.0) : glm::dvec3(0.0));
    random_body(random, builder, middle, 0.7, material, is_lamp);
  }
  return builder.model();
}

Model random_open_room(std::uint32_t seed) {
  Random random(seed);
  ModelBuilder whole;
  const std::uint32_t wall = whole.material(random_colour(random, 0.0, 0.95));
  whole.room(glm::dvec3(0.0), {4.0, 3.0, 5.0}, {wall, wall, wall, wall, wall, wall});
  ModelBuilder builder;
  builder.material(whole.model().materials[0].reflectance);
  const std::uint32_t lamp =
      builder.material(random_colour(random, 0.0, 0.5), random_colour(random, 1.0, 20.0));
  for (std::size_t f = 0; f < 6; ++f) {
    if (f == 2 || random.between(0, 2) != 0) {
      std::vector<glm::dvec3> corners;
      for (const std::uint32_t v : whole.model().faces[f].corners) {
        corners.push_back(whole.model().positions[v]);
      }
      builder.polygon(corners, 0);
    }
  }
  builder.polygon({{1.5, 2.9, 2.0}, {2.5, 2.9, 2.0}, {2.5, 2.9, 3.0}, {1.5, 2.9, 3.0}}, lamp);
  const int boxes = random.between(1, 4);
  for (int i = 0; i < boxes; ++i) {
    const glm::dvec3 low(random.real(0.5, 2.5), random.between(0, 1) == 0 ? 0.0 : random.real(0.1, 1.0),
                         random.real(0.5, 3.5));
    const glm::dvec3 size(random.real(0.2, 1.0), random.real(0.2, 1.5), random.real(0.2, 1.0));
    const std::uint32_t material = builder.material(random_colour(random, 0.0, 0.95));
    builder.box(low, low + size, random.real(0.0, 1.5), material, random.between(0, 1) == 0);
  }
  return builder.model();
}

Model room_with_box(Stand stand, double angle) {
  ModelBuilder builder;
  const std::uint32_t wall = builder.material(glm::dvec3(0.5));
  const std::uint32_t lamp = builder.material(glm::dvec3(0.5), glm::dvec3(1.0));
  builder.room(glm::dvec3(0.0), glm::dvec3(4.0), {wall, wall, wall, lamp, wall, wall});
  const double bottom = stand == Stand::floating ? 0.5 : 0.0;
  builder.box({1.5, bottom, 1.5}, {2.5, bottom + 1.0, 2.5}, angle, wall, stand != Stand::without_bottom);
  return builder.model();
}

Model parallel_squares(double reflectance0, double emission0, double reflectance1) {
  ModelBuilder builder;
  builder.material(glm::dvec3(reflectance0), glm::dvec3(emission0));
  builder.material(glm::dvec3(reflectance1));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0);
  builder.polygon({{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}, 1);
  return builder.model();
}

Model perpendicular_squares(double reflectance0, double emission0, double reflectance1) {
  ModelBuilder builder;
  builder.material(glm::dvec3(reflectance0), glm::dvec3(emission0));
  builder.material(glm::dvec3(reflectance1));
  builder.polygon({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, 0);
  builder.polygon({{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, 1);
  return builder.model();
}

std::uint32_t seed_count(std::uint32_t usual) {
  const char* wanted = std::getenv("FIXRAD_SCENES");
  return wanted == nullptr ? usual : static_cast<std::uint32_t>(std::strtoul(wanted, nullptr, 10));
}

Model cornell() {
  return read_obj(FIXRAD_SOURCE_DIR "/scenes/cornell.obj");
}

}  // namespace fixrad::host
