// SPDX-License-Identifier: MIT
#include "host_sim/meshing/device_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <tuple>

namespace fixrad::host {
namespace {

constexpr double kAreaScale = 8;  // UQ29.3
constexpr double kLift = 2;       // quarters of a grid unit

bool is_grey(glm::dvec3 a) {
  return a.x == a.y && a.y == a.z;
}

void store(std::int16_t (&out)[3], glm::dvec3 v) {
  for (int k = 0; k < 3; ++k) {
    out[k] = static_cast<std::int16_t>(std::lround(v[k]));
  }
}

// On the lit side of the face's first corner.
glm::dvec3 lifted(glm::dvec3 point, const FaceFrame& frame, glm::dvec3 corner) {
  // The core's normal, rounded: at the far end of a large face it stands a grid unit off the exact one.
  const glm::dvec3 seen = glm::round(frame.normal * static_cast<double>(kUnit)) / static_cast<double>(kUnit);
  glm::dvec3 q(0.0);
  for (double lift = kLift; lift < 40; lift += 1) {
    q = glm::round(point * static_cast<double>(kEyeScale) + lift * frame.normal);
    if (glm::dot(q - corner * static_cast<double>(kEyeScale), seen) >= 1) {
      break;
    }
  }
  return glm::clamp(q, 0.0, 65535.0);
}

template <class Faces>
bool has_lamp(const Model& model, const Faces& faces) {
  return std::any_of(faces.begin(), faces.end(), [&](const auto& face) {
    return model.materials[face.material].emission != glm::dvec3(0.0);
  });
}

class Builder {
 public:
  Builder(const PreparedScene& scene, const Meshing& meshing) : scene_(scene), meshing_(meshing) {}

  DeviceScene build() {
    device_.grid = scene_.vertices.grid;
    device_.channels = scene_.channels;
    for (const glm::ivec3& p : scene_.vertices.positions) {
      device_.vertices.push_back(
          {static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y), static_cast<std::int16_t>(p.z)});
    }
    for (std::size_t f = 0; f < scene_.faces.size(); ++f) {
      add_face(f);
      add_roots(f);
      add_elements(f);
    }
    if (device_.cuts.empty()) {
      device_.roots.clear();  // every cell is the element of its own number
    }
    add_patches();
    add_blockers();
    set_units();
    return std::move(device_);
  }

 private:
  void add_face(std::size_t f) {
    const ConvexFace& face = scene_.faces[f];
    const FaceFrame& frame = scene_.frames[f];
    const FaceElements& cut = meshing_.faces[f];
    fixrad::Face record = {};
    record.first_corner = static_cast<std::uint16_t>(device_.corners.size());
    record.corner_count = static_cast<std::uint8_t>(face.corners.size());
    record.material = static_cast<std::uint16_t>(face.material);
    record.first_cell_row = static_cast<std::uint16_t>(device_.cell_rows.size());
    record.cells_u = static_cast<std::uint8_t>(cut.cells_u);
    record.cells_v = static_cast<std::uint8_t>(cut.cells_v);
    const glm::dvec3 u = glm::normalize(glm::dvec3(frame.axis_u));
    store(record.normal, frame.normal * static_cast<double>(kUnit));
    store(record.tangent,
          glm::normalize(u - frame.normal * glm::dot(u, frame.normal)) * static_cast<double>(kUnit));
    store(record.origin, frame.origin);
    store(record.axis_u, frame.axis_u);
    store(record.axis_v, frame.axis_v);
    record.cell_area = static_cast<std::uint32_t>(
        std::lround(std::max(1.0, kAreaScale * frame.unit_area() / (cut.cells_u * cut.cells_v))));
    for (const std::uint32_t v : face.corners) {
      device_.corners.push_back(static_cast<std::uint16_t>(v));
    }
    for (int v = 0; v < cut.cells_v; ++v) {
      const auto row = static_cast<std::size_t>(v);
      const auto first = device_.roots.size() + static_cast<std::size_t>(cut.row_first[row]);
      device_.cell_rows.push_back({static_cast<std::uint16_t>(first),
                                   static_cast<std::uint8_t>(cut.rows[row].first),
                                   static_cast<std::uint8_t>(cut.rows[row].second)});
    }
    device_.faces.push_back(record);
  }

  void add_roots(std::size_t f) {
    const FaceElements& face = meshing_.faces[f];
    const auto first_element = static_cast<int>(device_.elements.size());
    const auto first_cut = static_cast<int>(device_.cuts.size());
    const auto side = [&](int s) {
      return static_cast<std::uint16_t>(s >= 0 ? kLeaf | (first_element + s) : first_cut - 1 - s);
    };
    for (std::size_t cell = 0; cell < face.cell_count(); ++cell) {
      device_.roots.push_back(side(face.roots.empty() ? static_cast<int>(cell) : face.roots[cell]));
    }
    for (const CellCut& cut : face.cuts) {
      device_.cuts.push_back({static_cast<std::int16_t>(cut.a), static_cast<std::int16_t>(cut.b),
                              static_cast<std::int16_t>(cut.c), side(cut.left), side(cut.right)});
    }
  }

  void add_elements(std::size_t f) {
    const FaceFrame& frame = scene_.frames[f];
    const glm::dvec3 corner(scene_.vertices.positions[scene_.faces[f].corners[0]]);
    for (const CellElement& cell : meshing_.faces[f].elements) {
      const glm::dvec3 centre = frame.to_grid(centroid(cell.outline));
      const double grid_area = area(cell.outline) * frame.unit_area();
      Element record = {};
      record.area = static_cast<std::uint32_t>(std::max(1L, std::lround(kAreaScale * grid_area)));
      record.face = static_cast<std::uint16_t>(f);
      record.material = static_cast<std::uint16_t>(scene_.faces[f].material);
      record.patch = patch_of(f, cell.u / meshing_.block_u, cell.v / meshing_.block_v);
      const glm::dvec3 eye = lifted(centre, frame, corner);
      for (int k = 0; k < 3; ++k) {
        record.eye[k] = static_cast<std::uint16_t>(eye[k]);
      }
      device_.elements.push_back(record);
      add_mesh_element(f, cell, centre, grid_area);
    }
  }

  std::uint16_t patch_of(std::size_t f, int block_u, int block_v) {
    const auto [it, is_new] = patch_index_.try_emplace({f, block_v, block_u}, patch_members_.size());
    if (is_new || patch_members_[it->second].size() == kMaxPatchElements) {
      it->second = patch_members_.size();
      patch_members_.emplace_back();
    }
    patch_members_[it->second].push_back(static_cast<std::uint16_t>(device_.elements.size()));
    return static_cast<std::uint16_t>(it->second);
  }

  void add_mesh_element(std::size_t f, const CellElement& cell, glm::dvec3 centre, double grid_area) {
    const ConvexFace& face = scene_.faces[f];
    const FaceFrame& frame = scene_.frames[f];
    const Grid& grid = scene_.vertices.grid;
    MeshElement element;
    for (const glm::dvec2 st : cell.outline) {
      element.polygon.push_back(grid.to_scene(frame.to_grid(st)));
    }
    element.centroid = grid.to_scene(centre);
    element.normal = frame.normal;
    element.area = grid_area / (grid.scale * grid.scale);
    element.reflectance = scene_.model->materials[face.material].reflectance;
    element.emission = scene_.model->materials[face.material].emission;
    element.input_face = face.parts.front().input_face;
    element.plane = static_cast<std::uint32_t>(f);
    const auto index = static_cast<std::uint32_t>(device_.mesh.elements.size());
    for (const FacePart& part : face.parts) {
      double part_area = element.area;
      if (face.parts.size() > 1) {
        Polygon2d outline;
        for (const std::uint32_t v : part.corners) {
          outline.push_back(frame.to_frame(glm::dvec3(scene_.vertices.positions[v])));
        }
        part_area = area(intersect(cell.outline, outline)) * frame.unit_area() / (grid.scale * grid.scale);
      }
      if (part_area > 0) {
        device_.overlaps.push_back({index, part.input_face, part_area});
      }
    }
    device_.mesh.elements.push_back(std::move(element));
  }

  void add_patches() {
    for (const std::vector<std::uint16_t>& members : patch_members_) {
      Patch record = {};
      device_.patch_elements.insert(device_.patch_elements.end(), members.begin(), members.end());
      record.face = device_.elements[members.front()].face;
      record.first_element = static_cast<std::uint16_t>(device_.patch_elements.size() - members.size());
      record.element_count = static_cast<std::uint16_t>(members.size());
      device_.patches.push_back(record);
    }
  }

  void add_blockers() {
    for (const glm::ivec3& p : scene_.vertices.positions) {
      device_.mesh.blocker_positions.push_back(device_.grid.to_scene(p));
    }
    for (const ConvexFace& face : scene_.faces) {
      for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
        for (const std::size_t k : {std::size_t{0}, i, i + 1}) {
          device_.mesh.blocker_triangles.push_back(face.corners[k]);
        }
      }
    }
  }

  // One flux unit is chosen so that the channel with the least headroom just passes the core's check.
  void set_units() {
    const std::vector<io_material>& materials = scene_.model->materials;
    double units_a_watt = std::numeric_limits<double>::infinity();
    double brightest = 0;
    for (int c = 0; c < device_.channels; ++c) {
      double emitted = 0, reflectance = 0;
      for (const MeshElement& e : device_.mesh.elements) {
        emitted += e.emission[c] * e.area;
        reflectance = std::max(reflectance, e.reflectance[c]);
        brightest = std::max(brightest, e.emission[c]);
      }
      if (emitted > 0) {
        units_a_watt = std::min(units_a_watt, 0.99 * std::ldexp(1.0 - reflectance, 30) / emitted);
      }
    }
    if (!std::isfinite(units_a_watt)) {
      units_a_watt = 1;  // nothing emits: any unit will do
    }
    device_.unit_watts = 1 / units_a_watt;
    const double area_unit = 1 / (kAreaScale * device_.grid.scale * device_.grid.scale);
    const double flux_a_unit =
        std::max(brightest * area_unit * units_a_watt, std::numeric_limits<double>::min());
    device_.emission_shift = std::clamp(31 - std::ilogb(flux_a_unit), 0, 63);
    device_.radiosity_shift = std::clamp(27 - std::ilogb(flux_a_unit), 0, 32);
    device_.unit_radiosity = device_.unit_watts / area_unit / std::ldexp(1.0, device_.radiosity_shift);
    for (const io_material& m : materials) {
      fixrad::Material record = {};
      for (int c = 0; c < 3; ++c) {
        record.reflectance[c] =
            static_cast<std::uint32_t>(std::min(4294967295.0, std::round(std::ldexp(m.reflectance[c], 32))));
        record.emission[c] = static_cast<std::uint32_t>(std::min(
            4294967295.0,
            std::round(std::ldexp(m.emission[c] * area_unit * units_a_watt, device_.emission_shift))));
      }
      device_.materials.push_back(record);
    }
  }

  using io_material = fixrad::host::Material;
  const PreparedScene& scene_;
  const Meshing& meshing_;
  DeviceScene device_;
  std::map<std::tuple<std::size_t, int, int>, std::size_t> patch_index_;
  std::vector<std::vector<std::uint16_t>> patch_members_;
};

}  // namespace

PreparedScene prepare(const Model& model) {
  PreparedScene scene;
  scene.model = &model;
  scene.vertices = quantise(model);
  ConvexFaces convex = make_convex(model, scene.vertices);
  merge_coplanar(scene.vertices, convex);
  scene.faces = std::move(convex.faces);
  scene.warnings = std::move(convex.warnings);
  std::size_t corners = 0;
  bool grey = true;
  for (const ConvexFace& face : scene.faces) {
    scene.frames.push_back(make_frame(scene.vertices, face));
    corners += face.corners.size();
    const Material& material = model.materials[face.material];
    grey = grey && is_grey(material.reflectance) && is_grey(material.emission);
  }
  scene.channels = grey ? 1 : 3;
  if (scene.faces.empty()) {
    throw InputError(
        model.path +
        ": error: no face has an area on the device's grid; check the scene's unit and outliers");
  }
  if (has_lamp(model, model.faces) && !has_lamp(model, scene.faces)) {
    throw InputError(model.path +
                     ": error: no face that emits light has an area on the device's grid; enlarge the lamp");
  }
  if (corners > 65535 || scene.vertices.positions.size() > 65535 || model.materials.size() > 65535) {
    throw InputError(model.path + ": error: more than 65535 vertices or corners; simplify the scene");
  }
  return scene;
}

DeviceScene make_device_scene(const PreparedScene& scene, const Meshing& meshing) {
  return Builder(scene, meshing).build();
}

Vec3 lifted_eye(const PreparedScene& scene, std::size_t face, glm::dvec3 point) {
  const glm::dvec3 corner(scene.vertices.positions[scene.faces[face].corners[0]]);
  const glm::dvec3 eye = lifted(point, scene.frames[face], corner);
  return {static_cast<std::int32_t>(eye.x), static_cast<std::int32_t>(eye.y),
          static_cast<std::int32_t>(eye.z)};
}

Scene DeviceScene::view() const {
  Scene scene = {};
  scene.vertices = vertices.data();
  scene.corners = corners.data();
  scene.faces = faces.data();
  scene.cell_rows = cell_rows.data();
  scene.roots = roots.empty() ? nullptr : roots.data();
  scene.cuts = cuts.data();
  scene.elements = elements.data();
  scene.patches = patches.data();
  scene.patch_elements = patch_elements.data();
  scene.materials = materials.data();
  scene.sights = sights.empty() ? nullptr : sights.data();
  scene.vertex_count = static_cast<std::uint16_t>(vertices.size());
  scene.corner_count = static_cast<std::uint16_t>(corners.size());
  scene.face_count = static_cast<std::uint16_t>(faces.size());
  scene.cell_row_count = static_cast<std::uint16_t>(cell_rows.size());
  scene.root_count = static_cast<std::uint16_t>(roots.size());
  scene.cut_count = static_cast<std::uint16_t>(cuts.size());
  scene.element_count = static_cast<std::uint16_t>(elements.size());
  scene.patch_count = static_cast<std::uint16_t>(patches.size());
  scene.material_count = static_cast<std::uint16_t>(materials.size());
  scene.channels = static_cast<std::uint8_t>(channels);
  scene.emission_shift = static_cast<std::uint8_t>(emission_shift);
  scene.radiosity_shift = static_cast<std::uint8_t>(radiosity_shift);
  return scene;
}

std::size_t DeviceScene::rom_bytes() const {
  return vertices.size() * sizeof(Vertex) + corners.size() * 2 + faces.size() * sizeof(fixrad::Face) +
         cell_rows.size() * sizeof(CellRow) + roots.size() * 2 + cuts.size() * sizeof(Cut) +
         elements.size() * sizeof(Element) + patches.size() * sizeof(Patch) + patch_elements.size() * 2 +
         sights.size() * sizeof(Sight) + materials.size() * sizeof(fixrad::Material);
}

}  // namespace fixrad::host
