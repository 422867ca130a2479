// SPDX-License-Identifier: MIT
#include "lib/refine/refined_scene.h"

#if !defined(__AVR__)

namespace fixrad {
namespace {

uint16_t cells_of_scene(const Scene& scene) {
  return scene.roots != nullptr ? scene.root_count : scene.element_count;
}

// A side of a cut, or a root, after an element behind `parent` has been put in.
uint16_t moved(uint16_t side, uint16_t parent) {
  return side >= kLeaf && (side & (kLeaf - 1u)) > parent ? static_cast<uint16_t>(side + 1) : side;
}

void move_sides(Scene& scene, RefinedScene& tables, uint16_t parent) {
  for (uint16_t i = 0; i < scene.root_count; ++i) {
    tables.roots[i] = moved(tables.roots[i], parent);
  }
  for (uint16_t i = 0; i < scene.cut_count; ++i) {
    tables.cuts[i].left = moved(tables.cuts[i].left, parent);
    tables.cuts[i].right = moved(tables.cuts[i].right, parent);
  }
}

void link(Scene& scene, RefinedScene& tables, uint16_t parent) {
  const uint16_t leaf = static_cast<uint16_t>(kLeaf | parent);
  const uint16_t cut = scene.cut_count;
  for (uint16_t i = 0; i < scene.root_count; ++i) {
    tables.roots[i] = tables.roots[i] == leaf ? cut : tables.roots[i];
  }
  for (uint16_t i = 0; i < scene.cut_count; ++i) {
    tables.cuts[i].left = tables.cuts[i].left == leaf ? cut : tables.cuts[i].left;
    tables.cuts[i].right = tables.cuts[i].right == leaf ? cut : tables.cuts[i].right;
  }
}

// The new element goes behind its parent in the patch's list too.
void enter_patch(Scene& scene, RefinedScene& tables, uint16_t parent) {
  const uint16_t patch = tables.elements[parent].patch;
  uint16_t at = 0;
  for (uint16_t i = 0; i < scene.element_count; ++i) {
    uint16_t& e = tables.patch_elements[i];
    at = e == parent ? static_cast<uint16_t>(i + 1) : at;
    e = e > parent ? static_cast<uint16_t>(e + 1) : e;
  }
  for (uint16_t i = scene.element_count; i > at; --i) {
    tables.patch_elements[i] = tables.patch_elements[i - 1];
  }
  tables.patch_elements[at] = static_cast<uint16_t>(parent + 1);
  ++tables.patches[patch].element_count;
  for (uint16_t p = static_cast<uint16_t>(patch + 1); p < scene.patch_count; ++p) {
    ++tables.patches[p].first_element;
  }
}

void set_part(Element& element, uint32_t area, const uint16_t (&eye)[3]) {
  element.area = area;
  for (int k = 0; k < 3; ++k) {
    element.eye[k] = eye[k];
  }
}

}  // namespace

Status make_refinable(Scene& scene, RefinedScene& tables) {
  const uint16_t cells = cells_of_scene(scene);
  if (scene.element_count > tables.element_capacity || scene.patch_count > tables.patch_capacity ||
      cells > tables.cell_capacity || scene.cut_count > tables.cut_capacity ||
      tables.element_capacity > kLeaf) {
    return Status::too_many_elements;
  }
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    tables.elements[e] = flash_read(scene.elements, e);
    tables.patch_elements[e] = flash_read(scene.patch_elements, e);
    tables.sights[e] = sight_of(scene, e);
    tables.errors[e] = 0;
  }
  for (uint16_t p = 0; p < scene.patch_count; ++p) {
    tables.patches[p] = flash_read(scene.patches, p);
  }
  for (uint16_t cell = 0; cell < cells; ++cell) {
    tables.roots[cell] =
        scene.roots != nullptr ? flash_read(scene.roots, cell) : static_cast<uint16_t>(kLeaf | cell);
  }
  for (uint16_t i = 0; i < scene.cut_count; ++i) {
    tables.cuts[i] = flash_read(scene.cuts, i);
  }
  scene.elements = tables.elements;
  scene.patch_elements = tables.patch_elements;
  scene.sights = tables.sights;
  scene.patches = tables.patches;
  scene.roots = tables.roots;
  scene.cuts = tables.cuts;
  scene.root_count = cells;
  return Status::ok;
}

bool has_room(const Scene& scene, const RefinedScene& tables, uint16_t parent) {
  const Patch& patch = tables.patches[tables.elements[parent].patch];
  return scene.element_count < tables.element_capacity && scene.cut_count < tables.cut_capacity &&
         patch.element_count < kMaxPatchElements;
}

void enter_split(Scene& scene, RefinedScene& tables, const Split& split) {
  const uint16_t parent = split.parent;
  link(scene, tables, parent);
  move_sides(scene, tables, parent);
  Cut& cut = tables.cuts[scene.cut_count++];
  cut = split.cut;
  cut.left = static_cast<uint16_t>(kLeaf | parent);
  cut.right = static_cast<uint16_t>(kLeaf | (parent + 1));
  enter_patch(scene, tables, parent);
  for (uint16_t e = scene.element_count; e > parent; --e) {
    tables.elements[e] = tables.elements[e - 1];
    tables.sights[e] = tables.sights[e - 1];
    tables.errors[e] = tables.errors[e - 1];
  }
  set_part(tables.elements[parent], split.left_area, split.left_eye);
  set_part(tables.elements[parent + 1], split.right_area, split.right_eye);
  tables.sights[parent] = tables.sights[parent + 1] = Sight::unknown;
  ++scene.element_count;
}

}  // namespace fixrad

#endif
