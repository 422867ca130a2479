// SPDX-License-Identifier: MIT
// Cells cut by lines: what the core makes of them, on rows from random eyes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

#include "host_sim/meshing/cell_cuts.h"
#include "lib/form_factor/cell_polygon.h"
#include "tests/lib/scenes.h"
#include "tests/lib/solution.h"

namespace fixrad::host {
namespace {

struct Meshed {
  Model model;
  PreparedScene prepared;
  Meshing meshing;
  DeviceScene device;

  Meshed(const Model& scene, std::uint32_t elements) : model(scene), prepared(prepare(model)) {
    meshing = make_uniform(prepared, elements, elements / 4);
  }
  Meshed(const Meshed&) = delete;  // `prepared` points at `model`
  Meshed& operator=(const Meshed&) = delete;

  void make() {
    meshing.element_count = 0;
    for (const FaceElements& face : meshing.faces) {
      meshing.element_count += static_cast<std::uint32_t>(face.elements.size());
    }
    device = make_device_scene(prepared, meshing);
  }
  Sizes sizes() const { return sizes_for(device, 0, Settings{}); }
};

std::vector<std::uint32_t> row_from(const DeviceScene& device, const Sizes& sizes, const EyePoint& eye,
                                    Engine engine, const DeltaTable& table) {
  SimulatedDevice solver(sizes);
  EXPECT_EQ(solver.load(device.view(), Settings{}), Status::ok);
  State& state = solver.state();
  clear(state.row);
  EXPECT_EQ(engine(state.scene, table, {eye, kRowOne, true}, state.work, state.row), Status::ok);
  std::vector<std::uint32_t> row(state.row.share, state.row.share + state.row.count);
  row.push_back(state.row.escaped);
  row.push_back(state.row.back);
  return row;
}

// Lines in random directions through every element until `wanted` are there.
void cut_at_random(Meshed& scene, Random& random, std::size_t wanted) {
  for (int tries = 0; tries < 3000 && scene.meshing.element_count < wanted; ++tries) {
    const auto f =
        static_cast<std::size_t>(random.between(0, static_cast<int>(scene.meshing.faces.size()) - 1));
    FaceElements& face = scene.meshing.faces[f];
    const auto e = static_cast<std::size_t>(random.between(0, static_cast<int>(face.elements.size()) - 1));
    const glm::dvec2 middle = centroid(face.elements[e].outline);
    const double angle = random.real(0.0, 3.14159);
    const Line2d line = line_through(middle, middle + glm::dvec2(std::cos(angle), std::sin(angle)));
    scene.meshing.element_count += cut_element(scene.prepared.frames[f], face, e, line) ? 1u : 0u;
  }
}

// The element of the uncut mesh that each element of the cut one is a part of.
std::vector<std::size_t> cell_of_parts(const Meshing& whole, const Meshing& cut) {
  std::vector<std::size_t> cell;
  std::size_t first = 0;
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    for (const CellElement& part : cut.faces[f].elements) {
      const std::vector<CellElement>& cells = whole.faces[f].elements;
      const auto found = std::find_if(cells.begin(), cells.end(),
                                      [&](const CellElement& c) { return c.u == part.u && c.v == part.v; });
      cell.push_back(first + static_cast<std::size_t>(found - cells.begin()));
    }
    first += whole.faces[f].elements.size();
  }
  return cell;
}

TEST(CutCells, ShareAmongThemExactlyWhatTheirCellGets) {
  for (const Engine engine : {lune_rows, hemicube_rows}) {
    Random random(11);
    Meshed whole(random_closed_room(5), 160);
    whole.make();
    Meshed cut(random_closed_room(5), 160);
    cut_at_random(cut, random, 400);
    cut.make();
    ASSERT_GE(cut.device.elements.size(), 390u);
    ASSERT_GT(cut.device.cuts.size(), 200u);
    const std::vector<std::size_t> cell = cell_of_parts(whole.meshing, cut.meshing);
    for (std::size_t e = 0; e < whole.device.elements.size(); e += 7) {
      const EyePoint eye = {vec(whole.device.elements[e].eye), whole.device.elements[e].face,
                            static_cast<std::uint8_t>(e % 16)};
      const DeltaTable& table = engine == lune_rows ? kLunes[3] : kDelta16;
      const auto expected = row_from(whole.device, whole.sizes(), eye, engine, table);
      const auto parts = row_from(cut.device, cut.sizes(), eye, engine, table);
      std::vector<std::uint32_t> sums(whole.device.elements.size(), 0);
      for (std::size_t part = 0; part < cell.size(); ++part) {
        sums[cell[part]] += parts[part];
      }
      sums.insert(sums.end(), parts.end() - 2, parts.end());
      ASSERT_EQ(sums, expected) << "eye of element " << e;
    }
  }
}

// A 2 x 2 grid on each wall of a cube, and one cell cut twice: the same elements, so nearly the same row.
TEST(CutCells, SeeWhatAFinerGridSees) {
  Meshed fine(cube(0.5, {0, 0, 0, 1, 0, 0}), 24);
  fine.make();
  ASSERT_EQ(fine.device.elements.size(), 24u);
  Meshed cut(cube(0.5, {0, 0, 0, 1, 0, 0}), 6);
  for (std::size_t f = 0; f < 6; ++f) {
    const FaceElements whole = cut_face(cut.prepared.frames[f], 1, 1);
    cut.meshing.faces[f] = whole;
    ASSERT_TRUE(cut_element(cut.prepared.frames[f], cut.meshing.faces[f], 0, {{0, 1}, 0.5}));
    ASSERT_TRUE(cut_element(cut.prepared.frames[f], cut.meshing.faces[f], 0, {{1, 0}, 0.5}));
    ASSERT_TRUE(cut_element(cut.prepared.frames[f], cut.meshing.faces[f], 1, {{1, 0}, 0.5}));
  }
  cut.make();
  ASSERT_EQ(cut.device.elements.size(), 24u);
  // Parts are numbered upper right, lower right, upper left, lower left.
  constexpr std::size_t kCellOfPart[4] = {3, 1, 2, 0};
  for (std::size_t e = 0; e < 24; e += 5) {
    const EyePoint eye = {vec(fine.device.elements[e].eye), fine.device.elements[e].face, 3};
    const auto expected = row_from(fine.device, fine.sizes(), eye, lune_rows, kLunes[5]);
    const auto found = row_from(cut.device, cut.sizes(), eye, lune_rows, kLunes[5]);
    for (std::size_t part = 0; part < 24; ++part) {
      const double share = expected[part / 4 * 4 + kCellOfPart[part % 4]];
      EXPECT_NEAR(found[part], share, 0.01 * share + 100) << "eye " << e << ", part " << part;
    }
  }
}

TEST(CutCells, LoseNoLight) {
  Random random(3);
  Meshed cut(random_closed_room(9), 150);
  cut_at_random(cut, random, 350);
  cut.make();
  Settings settings = lune_settings(32, fraction(1, 1000));
  settings.overshoot = true;
  SimulatedDevice solver(cut.sizes());
  ASSERT_EQ(solver.load(cut.device.view(), settings), Status::ok);
  Status status = Status::ok;
  while (status == Status::ok) {
    status = shoot(solver.state());
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(ledger(solver.state(), c).imbalance(), 0);
    }
  }
  EXPECT_EQ(status, Status::converged);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(ledger(solver.state(), c).escaped, 0);
  }
}

// Square grid units.
double area_of(const Polygon& polygon) {
  glm::dvec3 sum(0.0);
  const auto at = [&](int k) {
    return glm::dvec3(polygon.corner[k].x, polygon.corner[k].y, polygon.corner[k].z) /
           static_cast<double>(kFineScale);
  };
  for (int k = 1; k + 1 < polygon.count; ++k) {
    sum += glm::cross(at(k) - at(0), at(k + 1) - at(0)) / 2.0;
  }
  return glm::length(sum);
}

TEST(CutCells, HaveThePolygonsThatTheHostCut) {
  Random random(8);
  Meshed cut(random_closed_room(7), 120);
  cut_at_random(cut, random, 320);
  cut.make();
  const Scene scene = cut.device.view();
  std::vector<int> seen(cut.device.elements.size(), 0);
  for (std::uint16_t f = 0; f < scene.face_count; ++f) {
    const fixrad::Face face = scene.faces[f];
    for (ElementCellWalk walk(scene, face); walk.next();) {
      const std::uint16_t e = walk.cells().element;
      ++seen[e];
      Polygon polygon;
      element_polygon(scene, face, walk.cells(), polygon);
      const double expected = cut.device.elements[e].area / 8.0;
      EXPECT_NEAR(area_of(polygon), expected, 0.002 * expected + 4) << "element " << e;
      EXPECT_EQ(cells_of(scene, face, e).way, walk.cells().way);
      EXPECT_EQ(cells_at(scene, face, fine_point(vec(cut.device.elements[e].eye))).element, e);
    }
  }
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1)) << "each element once";
}

DeviceScene scene_with_a_cut() {
  Meshed cut(cube(0.5, {0, 0, 0, 1, 0, 0}), 54);
  EXPECT_TRUE(cut_element(cut.prepared.frames[0], cut.meshing.faces[0], 0, {{1, 1}, 0.25}));
  cut.make();
  return cut.device;
}

TEST(CutCells, AreCheckedBeforeTheyAreUsed) {
  const Capacity roomy = {100, 100, 1000, 3};
  DeviceScene scene = scene_with_a_cut();
  ASSERT_EQ(check_scene(scene.view(), roomy), Status::ok);
  const auto status_with = [&](auto mutate) {
    DeviceScene changed = scene;
    mutate(changed);
    return check_scene(changed.view(), roomy);
  };
  EXPECT_EQ(status_with([](DeviceScene& s) { s.cuts[0].left = 1; }), Status::bad_index) << "no such cut";
  EXPECT_EQ(status_with([](DeviceScene& s) { s.cuts[0].left = 0; }), Status::bad_grid)
      << "a tree without end";
  EXPECT_EQ(status_with([](DeviceScene& s) { s.cuts[0].right = 0xffff; }), Status::bad_index)
      << "no such element";
  EXPECT_EQ(status_with([](DeviceScene& s) { s.cuts[0].right = kLeaf | 50; }), Status::bad_grid)
      << "an element of another face";
  EXPECT_EQ(status_with([](DeviceScene& s) { s.cuts[0].a = 513; }), Status::bad_grid);
  EXPECT_EQ(status_with([](DeviceScene& s) { s.cuts[0].c = -2048; }), Status::bad_grid);
  EXPECT_EQ(status_with([](DeviceScene& s) { s.roots.pop_back(); }), Status::bad_index);
}

}  // namespace
}  // namespace fixrad::host
