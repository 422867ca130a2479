// SPDX-License-Identifier: MIT
#include "tests/fuzz/byte_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace fixrad::fuzz {
namespace {

constexpr int kMostShots = 2;
constexpr int kMostSoundFaces = 8;  // of which six are walls

template <class T>
std::vector<T> wild_table(FuzzedDataProvider& in, std::size_t most) {
  std::vector<T> table(in.ConsumeIntegralInRange<std::size_t>(0, most));
  std::vector<std::uint8_t> bytes = in.ConsumeBytes<std::uint8_t>(table.size() * sizeof(T));
  if (!bytes.empty()) {
    std::memcpy(static_cast<void*>(table.data()), bytes.data(), bytes.size());
  }
  return table;
}

template <class T>
void damage_table(FuzzedDataProvider& in, std::vector<T>& table) {
  if (!table.empty()) {
    const auto at = in.ConsumeIntegralInRange<std::size_t>(0, table.size() * sizeof(T) - 1);
    reinterpret_cast<std::uint8_t*>(table.data())[at] = in.ConsumeIntegral<std::uint8_t>();
  }
}

struct Point {
  double x, y, z;
};

Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Point operator*(double s, Point a) {
  return {s * a.x, s * a.y, s * a.z};
}
Point cross(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
double length(Point a) {
  return std::sqrt(dot(a, a));
}

template <class T>
void store(T (&out)[3], Point p, double scale) {
  out[0] = static_cast<T>(std::lround(scale * p.x));
  out[1] = static_cast<T>(std::lround(scale * p.y));
  out[2] = static_cast<T>(std::lround(scale * p.z));
}

class Builder {
 public:
  explicit Builder(FuzzedDataProvider& in) : in_(in) {}

  ByteScene build() {
    scene_.channels = in_.ConsumeBool() ? 3 : 1;
    has_cuts_ = in_.ConsumeIntegralInRange(0, 3) == 0;
    add_materials();
    add_walls();
    while (scene_.faces.size() < kMostSoundFaces && in_.remaining_bytes() > 0) {
      add_face(any_point(), any_point() - middle(), any_point() - middle());
    }
    if (in_.ConsumeBool()) {
      for (std::size_t e = 0; e < scene_.elements.size(); ++e) {
        scene_.sights.push_back(static_cast<Sight>(in_.ConsumeIntegralInRange(0, 3)));
      }
    }
    fit_units();
    shrink();
    return std::move(scene_);
  }

 private:
  static Point middle() { return {8192, 8192, 8192}; }

  // Coarse coordinates often, so that faces meet, lie in one plane and share vertices.
  double coordinate() {
    const auto bits = in_.ConsumeIntegral<std::uint8_t>();
    return bits < 160 ? (bits % 16) * 1024.0 + 512 : in_.ConsumeIntegralInRange(0, kGridMax);
  }

  Point any_point() {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

  void add_materials() {
    const int count = in_.ConsumeIntegralInRange(1, 3);
    for (int i = 0; i < count; ++i) {
      Material material = {};
      for (int c = 0; c < kMaxChannels; ++c) {
        const std::uint32_t reflectance = in_.ConsumeIntegral<std::uint8_t>();
        material.reflectance[c] =
            reflectance == 255 ? in_.ConsumeIntegral<std::uint32_t>() : reflectance << 24;
        material.emission[c] = i == 0 || in_.ConsumeBool() ? in_.ConsumeIntegral<std::uint32_t>() : 0;
      }
      scene_.materials.push_back(material);
    }
  }

  void add_walls() {
    const int walls = in_.ConsumeIntegral<std::uint8_t>();  // a bit a wall; most often all
    const std::int32_t side = in_.ConsumeIntegralInRange(1, 15);
    const double low = 512, size = side * 1024.0;
    const Point o = {low, low, low}, x = {size, 0, 0}, y = {0, size, 0}, z = {0, 0, size};
    const Point wall[6][3] = {{o, y, z}, {o + x, z, y}, {o, z, x}, {o + y, x, z}, {o, x, y}, {o + z, y, x}};
    for (int i = 0; i < 6; ++i) {
      if (walls >= 64 || (walls >> i & 1) != 0) {
        add_parallelogram(wall[i][0], wall[i][1], wall[i][2]);
      }
    }
  }

  void add_face(Point o, Point a, Point b) {
    if (in_.ConsumeBool()) {
      add_parallelogram(o, a, b);
    } else {
      add_triangle(o, a, b);
    }
  }

  static bool is_on_grid(Point p) {
    const double low = std::min({p.x, p.y, p.z}), high = std::max({p.x, p.y, p.z});
    return low >= 8 && high <= kGridMax - 8;
  }

  bool can_add(const std::vector<Point>& corners, Point a, Point b) const {
    return std::all_of(corners.begin(), corners.end(), is_on_grid) && length(cross(a, b)) >= 64 &&
           scene_.vertices.size() + corners.size() <= kVertices && scene_.faces.size() < kMostSoundFaces;
  }

  void add_parallelogram(Point o, Point a, Point b) {
    const int grid = in_.ConsumeIntegralInRange(0, 7);  // most often one cell
    const int nu = grid < 6 ? 1 : 2, nv = grid < 7 ? 1 : 2;
    const std::vector<Point> corners = {o, o + a, o + a + b, o + b};
    if (!can_add(corners, a, b) ||
        scene_.elements.size() + 2 * static_cast<std::size_t>(nu * nv) > kElements) {
      return;
    }
    begin_face(corners, o, a, b, nu, nv);
    for (int v = 0; v < nv; ++v) {
      scene_.cell_rows.push_back({static_cast<uint16_t>(cells()), 0, static_cast<uint8_t>(nu - 1)});
      for (int u = 0; u < nu; ++u) {
        add_cell(o + ((u + 0.5) / nu) * a + ((v + 0.5) / nv) * b, scene_.faces.back().cell_area);
      }
    }
    end_face();
  }

  void add_triangle(Point o, Point a, Point b) {
    if (!can_add({o, o + a, o + b}, a, b) || scene_.elements.size() + 2 > kElements) {
      return;
    }
    begin_face({o, o + a, o + b}, o, a, b, 1, 1);
    scene_.cell_rows.push_back({static_cast<uint16_t>(cells()), 0, 0});
    add_cell(o + (1.0 / 3) * (a + b), std::max(scene_.faces.back().cell_area / 2, 1u));
    end_face();
  }

  std::size_t cells() const { return has_cuts_ ? scene_.roots.size() : scene_.elements.size(); }

  std::uint16_t vertex(Point p) {
    const Vertex v = {static_cast<int16_t>(p.x), static_cast<int16_t>(p.y), static_cast<int16_t>(p.z)};
    for (std::size_t i = 0; i < scene_.vertices.size(); ++i) {
      const Vertex& w = scene_.vertices[i];
      if (v.x == w.x && v.y == w.y && v.z == w.z) {
        return static_cast<uint16_t>(i);
      }
    }
    scene_.vertices.push_back(v);
    return static_cast<uint16_t>(scene_.vertices.size() - 1);
  }

  void begin_face(const std::vector<Point>& corners, Point o, Point a, Point b, int nu, int nv) {
    Face face = {};
    face.first_corner = static_cast<uint16_t>(scene_.corners.size());
    face.corner_count = static_cast<uint8_t>(corners.size());
    face.material =
        in_.ConsumeIntegralInRange<uint16_t>(0, static_cast<uint16_t>(scene_.materials.size() - 1));
    face.first_cell_row = static_cast<uint16_t>(scene_.cell_rows.size());
    face.cells_u = static_cast<uint8_t>(nu);
    face.cells_v = static_cast<uint8_t>(nv);
    const Point n = cross(a, b);
    normal_ = (1 / length(n)) * n;
    corner_ = o;
    store(face.normal, normal_, kUnit);
    store(face.tangent, (1 / length(a)) * a, kUnit);
    store(face.origin, o, 1);
    store(face.axis_u, a, 1);
    store(face.axis_v, b, 1);
    face.cell_area = static_cast<uint32_t>(std::max(1.0, 8 * length(n) / (nu * nv)));
    face.is_sealed = in_.ConsumeBool() ? 1 : 0;
    for (const Point& p : corners) {
      scene_.corners.push_back(vertex(p));
    }
    scene_.faces.push_back(face);
    first_element_ = scene_.elements.size();
  }

  void add_cell(Point centre, std::uint32_t area) {
    const bool is_cut = has_cuts_ && area >= 2 && in_.ConsumeBool();
    const auto leaf = static_cast<uint16_t>(kLeaf | scene_.elements.size());
    if (has_cuts_) {
      scene_.roots.push_back(is_cut ? static_cast<uint16_t>(scene_.cuts.size()) : leaf);
    }
    if (is_cut) {
      scene_.cuts.push_back(
          {in_.ConsumeIntegralInRange<int16_t>(-512, 512), in_.ConsumeIntegralInRange<int16_t>(-512, 512),
           in_.ConsumeIntegralInRange<int16_t>(-2047, 2047), leaf, static_cast<uint16_t>(leaf + 1)});
      add_element(centre, area / 2);
      area -= area / 2;
    }
    add_element(centre, area);
  }

  // Lifted until the core sees it on the lit side.
  void add_element(Point centre, std::uint32_t area) {
    Element element = {};
    element.area = area;
    element.face = static_cast<uint16_t>(scene_.faces.size() - 1);
    element.material = scene_.faces.back().material;
    for (double lift = 2; lift < 20; ++lift) {
      const Point eye = 4.0 * centre + lift * normal_;
      store(element.eye, eye, 1);
      const Point seen = {element.eye[0] - 4.0 * corner_.x, element.eye[1] - 4.0 * corner_.y,
                          element.eye[2] - 4.0 * corner_.z};
      if (dot(seen, normal_) >= 1) {
        break;
      }
    }
    scene_.elements.push_back(element);
  }

  void end_face() {
    const std::size_t step = in_.ConsumeIntegralInRange<std::size_t>(1, 4);
    for (std::size_t e = first_element_; e < scene_.elements.size(); e += step) {
      const std::size_t end = std::min(e + step, scene_.elements.size());
      scene_.patches.push_back({static_cast<uint16_t>(scene_.faces.size() - 1),
                                static_cast<uint16_t>(scene_.patch_elements.size()),
                                static_cast<uint16_t>(end - e)});
      for (std::size_t i = e; i < end; ++i) {
        scene_.elements[i].patch = static_cast<uint16_t>(scene_.patches.size() - 1);
        scene_.patch_elements.push_back(static_cast<uint16_t>(i));
      }
    }
  }

  // The smallest shift from the wanted one on that leaves load() the headroom it asks for.
  void fit_units() {
    scene_.radiosity_shift = in_.ConsumeIntegralInRange<std::uint8_t>(0, 32);
    scene_.emission_shift = in_.ConsumeIntegralInRange<std::uint8_t>(0, 63);
    while (scene_.emission_shift < 63 && !has_headroom()) {
      ++scene_.emission_shift;
    }
  }

  bool has_headroom() const {
    for (int c = 0; c < scene_.channels; ++c) {
      std::uint64_t emitted = 0, highest = 0;
      for (const Element& e : scene_.elements) {
        const Material& material = scene_.materials[e.material];
        emitted += (std::uint64_t{material.emission[c]} * e.area) >> scene_.emission_shift >> 6;
        highest = std::max(highest, std::uint64_t{material.reflectance[c]});
      }
      if ((emitted + scene_.elements.size()) << 6 >= ((std::uint64_t{1} << 32) - highest) >> 2) {
        return false;
      }
    }
    return true;
  }

  void shrink() {
    scene_.vertices.shrink_to_fit();
    scene_.corners.shrink_to_fit();
    scene_.faces.shrink_to_fit();
    scene_.cell_rows.shrink_to_fit();
    scene_.roots.shrink_to_fit();
    scene_.cuts.shrink_to_fit();
    scene_.elements.shrink_to_fit();
    scene_.patches.shrink_to_fit();
    scene_.patch_elements.shrink_to_fit();
    scene_.materials.shrink_to_fit();
    scene_.sights.shrink_to_fit();
  }

  FuzzedDataProvider& in_;
  ByteScene scene_;
  bool has_cuts_ = false;
  Point normal_ = {}, corner_ = {};
  std::size_t first_element_ = 0;
};

}  // namespace

Scene ByteScene::view() const {
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
  scene.sights = sights.size() < elements.size() ? nullptr : sights.data();
  scene.vertex_count = static_cast<uint16_t>(vertices.size());
  scene.corner_count = static_cast<uint16_t>(corners.size());
  scene.face_count = static_cast<uint16_t>(faces.size());
  scene.cell_row_count = static_cast<uint16_t>(cell_rows.size());
  scene.root_count = static_cast<uint16_t>(roots.size());
  scene.cut_count = static_cast<uint16_t>(cuts.size());
  // The list of patches' elements has no count of its own.
  scene.element_count = static_cast<uint16_t>(std::min(elements.size(), patch_elements.size()));
  scene.patch_count = static_cast<uint16_t>(patches.size());
  scene.material_count = static_cast<uint16_t>(materials.size());
  scene.channels = channels;
  scene.emission_shift = emission_shift;
  scene.radiosity_shift = radiosity_shift;
  return scene;
}

ByteScene wild_scene(FuzzedDataProvider& in) {
  ByteScene scene;
  scene.channels = in.ConsumeIntegral<std::uint8_t>();
  scene.emission_shift = in.ConsumeIntegral<std::uint8_t>();
  scene.radiosity_shift = in.ConsumeIntegral<std::uint8_t>();
  scene.vertices = wild_table<Vertex>(in, 6);
  scene.corners = wild_table<uint16_t>(in, 12);
  scene.faces = wild_table<Face>(in, 3);
  scene.cell_rows = wild_table<CellRow>(in, 4);
  scene.roots = wild_table<uint16_t>(in, 4);
  scene.cuts = wild_table<Cut>(in, 4);
  scene.elements = wild_table<Element>(in, 6);
  scene.patches = wild_table<Patch>(in, 3);
  scene.patch_elements = wild_table<uint16_t>(in, 6);
  scene.materials = wild_table<Material>(in, 2);
  return scene;
}

ByteScene sound_scene(FuzzedDataProvider& in) {
  return Builder(in).build();
}

void damage(FuzzedDataProvider& in, ByteScene& scene) {
  for (int count = in.ConsumeIntegralInRange(0, 4); count > 0; --count) {
    switch (in.ConsumeIntegralInRange(0, 12)) {
      case 0:
        damage_table(in, scene.vertices);
        break;
      case 1:
        damage_table(in, scene.corners);
        break;
      case 2:
        damage_table(in, scene.cell_rows);
        break;
      case 3:
        damage_table(in, scene.roots);
        break;
      case 4:
        damage_table(in, scene.cuts);
        break;
      case 5:
        damage_table(in, scene.elements);
        break;
      case 6:
        damage_table(in, scene.patches);
        break;
      case 7:
        damage_table(in, scene.patch_elements);
        break;
      case 8:
        damage_table(in, scene.materials);
        break;
      case 9:
        damage_table(in, scene.sights);
        break;
      case 10:
        scene.channels = in.ConsumeIntegral<std::uint8_t>();
        break;
      default:
        damage_table(in, scene.faces);
        break;
    }
  }
}

Settings any_settings(FuzzedDataProvider& in, bool of_pairs) {
  Settings settings;
  const int size = in.ConsumeIntegralInRange(0, 63);
  settings.tables = settings.probe = size < 56 ? &kLunes[0] : (size < 63 ? &kLunes[1] : &kLunes[3]);
  settings.table_count = static_cast<uint8_t>(in.ConsumeIntegralInRange(1, size < 56 ? 2 : 1));
  const int engine = in.ConsumeIntegralInRange(0, 7);
  if (of_pairs) {
    settings.engine = engine < 4 ? contour_row : ray_row;
    settings.near_field = engine % 4 == 3 ? correct_near_field : nullptr;
  } else if (engine >= 5) {
    settings.engine = engine < 7 ? hemicube_rows : hemicube_pixels;
    settings.tables = settings.probe = &kDelta8;
    settings.table_count = 1;
  }
  settings.stop = Fraction::from_raw(in.ConsumeIntegral<uint32_t>() >> in.ConsumeIntegralInRange(0, 31));
  settings.flux_per_row = Fraction::from_raw(in.ConsumeIntegral<uint32_t>());
  settings.flux_per_eye = Fraction::from_raw(in.ConsumeIntegral<uint32_t>());
  settings.overshoot = in.ConsumeBool();
  return settings;
}

void load_and_shoot(const std::uint8_t* data, std::size_t size, bool of_pairs) {
  static Solver<FuzzLimits> solver;
  FuzzedDataProvider in(data, size);
  const Settings settings = any_settings(in, of_pairs);
  const bool is_wild = in.ConsumeIntegralInRange(0, 7) == 0;
  ByteScene scene = is_wild ? wild_scene(in) : sound_scene(in);
  if (!is_wild) {
    damage(in, scene);
  }
  if (solver.load(scene.view(), settings) != Status::ok) {
    return;
  }
  require_ledger(solver.state());
  for (int i = 0; i < kMostShots && solver.step() == Status::ok; ++i) {
    require_ledger(solver.state());
  }
}

void require_ledger(const State& state) {
  for (int c = 0; c < state.scene.channels; ++c) {
    if (ledger(state, c).imbalance() != 0) {
      __builtin_trap();
    }
  }
}

}  // namespace fixrad::fuzz
