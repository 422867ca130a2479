// SPDX-License-Identifier: MIT
#include "tests/reference/twin_room.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace fixrad::host {
namespace {

glm::dvec3 to_double(Vec3 v) {
  return {v.x, v.y, v.z};
}

template <class T>
void store(const glm::dvec3& v, T (&out)[3]) {
  for (glm::length_t i = 0; i < 3; ++i) {
    out[i] = static_cast<T>(std::lround(v[i]));
  }
}

Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

constexpr double kLift = 0.5;  // grid units

// The point of cell coordinates (u, v), lifted, in quarters of a grid unit.
template <class T>
void store_eye(const Face& face, double u, double v, T (&out)[3]) {
  const glm::dvec3 at = to_double(vec(face.origin)) + to_double(vec(face.axis_u)) * (u / face.cells_u) +
                        to_double(vec(face.axis_v)) * (v / face.cells_v);
  store((at + to_double(vec(face.normal)) * (kLift / kUnit)) * static_cast<double>(kEyeScale), out);
}

}  // namespace

std::uint16_t TwinRoom::add_material(std::array<double, 3> reflectance, std::array<double, 3> emission) {
  Material material = {};
  for (std::size_t c = 0; c < 3; ++c) {
    material.reflectance[c] = static_cast<std::uint32_t>(reflectance[c] * 4294967296.0);
    material.emission[c] = static_cast<std::uint32_t>(emission[c] * (1 << 28));
  }
  materials_.push_back(material);
  return static_cast<std::uint16_t>(materials_.size() - 1);
}

std::uint16_t TwinRoom::vertex_at(Vec3 p) {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (vertices_[i].x == p.x && vertices_[i].y == p.y && vertices_[i].z == p.z) {
      return static_cast<std::uint16_t>(i);
    }
  }
  vertices_.push_back(
      {static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y), static_cast<std::int16_t>(p.z)});
  return static_cast<std::uint16_t>(vertices_.size() - 1);
}

void TwinRoom::add_quad(Vec3 origin, Vec3 u, Vec3 v, unsigned n, std::uint16_t material) {
  Face face = {};
  face.first_corner = static_cast<std::uint16_t>(corners_.size());
  face.material = material;
  face.first_cell_row = static_cast<std::uint16_t>(cell_rows_.size());
  face.corner_count = 4;
  face.cells_u = face.cells_v = static_cast<std::uint8_t>(n);
  for (const Vec3& corner : {origin, origin + u, origin + u + v, origin + v}) {
    corners_.push_back(vertex_at(corner));
  }
  const glm::dvec3 area = glm::cross(to_double(u), to_double(v));
  store(glm::normalize(area) * static_cast<double>(kUnit), face.normal);
  store(glm::normalize(to_double(u)) * static_cast<double>(kUnit), face.tangent);
  store(to_double(origin), face.origin);
  store(to_double(u), face.axis_u);
  store(to_double(v), face.axis_v);
  face.cell_area = static_cast<std::uint32_t>(glm::length(area) * 8 / (n * n));
  faces_.push_back(face);
  add_elements(face, static_cast<std::uint16_t>(faces_.size() - 1), n);
}

void TwinRoom::add_elements(const Face& face, std::uint16_t face_index, unsigned n) {
  const unsigned block = n % 2 == 0 ? 2 : 1;
  const std::size_t first = elements_.size();
  for (unsigned v = 0; v < n; ++v) {
    cell_rows_.push_back({static_cast<std::uint16_t>(elements_.size()), 0, static_cast<std::uint8_t>(n - 1)});
    for (unsigned u = 0; u < n; ++u) {
      Element element = {};
      element.area = face.cell_area;
      element.face = face_index;
      element.material = face.material;
      element.patch = static_cast<std::uint16_t>(patches_.size() + v / block * (n / block) + u / block);
      store_eye(face, u + 0.5, v + 0.5, element.eye);
      elements_.push_back(element);
    }
  }
  for (unsigned v = 0; v < n; v += block) {
    for (unsigned u = 0; u < n; u += block) {
      Patch patch = {};
      patch.face = face_index;
      patch.first_element = static_cast<std::uint16_t>(patch_elements_.size());
      patch.element_count = static_cast<std::uint16_t>(block * block);
      patches_.push_back(patch);
      for (unsigned i = 0; i < block * block; ++i) {
        patch_elements_.push_back(static_cast<std::uint16_t>(first + (v + i / block) * n + u + i % block));
      }
    }
  }
}

void TwinRoom::add_box(Vec3 origin, Vec3 u, Vec3 v, Vec3 w, bool is_room, unsigned n,
                       std::uint16_t material) {
  const auto add = [&](Vec3 at, Vec3 a, Vec3 b) {
    add_quad(at, is_room ? b : a, is_room ? a : b, n, material);
  };
  add(origin, v, u);
  add(origin + w, u, v);
  add(origin, u, w);
  add(origin + v, w, u);
  add(origin, w, v);
  add(origin + u, v, w);
}

Scene TwinRoom::scene(unsigned channels) {
  constexpr double kMostFlux = 1 << 27;
  double flux = 0;
  for (const Element& element : elements_) {
    double brightest = 0;
    for (const std::uint32_t emission : materials_[faces_[element.face].material].emission) {
      brightest = emission > brightest ? emission : brightest;
    }
    flux += brightest * element.area;
  }
  int shift = 0;
  while (std::ldexp(flux, -shift) >= kMostFlux) {
    ++shift;
  }
  const auto count = [](const auto& table) { return static_cast<std::uint16_t>(table.size()); };
  return {vertices_.data(),
          corners_.data(),
          faces_.data(),
          cell_rows_.data(),
          nullptr,
          nullptr,
          elements_.data(),
          patches_.data(),
          patch_elements_.data(),
          materials_.data(),
          nullptr,
          count(vertices_),
          count(corners_),
          count(faces_),
          count(cell_rows_),
          0,
          0,
          count(elements_),
          count(patches_),
          count(materials_),
          static_cast<std::uint8_t>(channels),
          static_cast<std::uint8_t>(shift),
          static_cast<std::uint8_t>(shift - 4)};
}

}  // namespace fixrad::host
