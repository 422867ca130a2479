// SPDX-License-Identifier: MIT
#include "lib/save/identity.h"

#include "lib/fixed/fnv1a.h"
#include "lib/transport/shooting.h"

namespace fixrad {
namespace {

constexpr uint8_t kIdentityEyes = 4;

class Mixer {
 public:
  // Not inlined: it stands wherever a number is.
  __attribute__((noinline)) void add(uint32_t number) { hash_ = fnv1a(hash_, number); }

  void add_signed(int32_t number) { add(static_cast<uint32_t>(number)); }

  void add_vector(const Vec3& v) {
    add_signed(v.x);
    add_signed(v.y);
    add_signed(v.z);
  }

  uint64_t hash() const { return hash_; }

 private:
  uint64_t hash_ = kFnvOfNothing;
};

void mix_counts(const Scene& scene, Mixer& mixer) {
  const uint16_t counts[] = {scene.vertex_count,   scene.corner_count,   scene.face_count,
                             scene.cell_row_count, scene.root_count,     scene.cut_count,
                             scene.element_count,  scene.patch_count,    scene.material_count,
                             scene.channels,       scene.emission_shift, scene.radiosity_shift};
  for (const uint16_t count : counts) {
    mixer.add(count);
  }
}

void mix_face(const Face& face, Mixer& mixer) {
  const uint16_t numbers[] = {face.first_corner, face.material, face.first_cell_row, face.corner_count,
                              face.cells_u,      face.cells_v,  face.is_sealed};
  for (const uint16_t number : numbers) {
    mixer.add(number);
  }
  mixer.add(face.cell_area);
  mixer.add_vector(vec(face.normal));
  mixer.add_vector(vec(face.tangent));
  mixer.add_vector(vec(face.origin));
  mixer.add_vector(vec(face.axis_u));
  mixer.add_vector(vec(face.axis_v));
}

void mix_faces(const Scene& scene, Mixer& mixer) {
  for (uint16_t i = 0; i < scene.vertex_count; ++i) {
    mixer.add_vector(vec(flash_read(scene.vertices, i)));
  }
  for (uint16_t i = 0; i < scene.corner_count; ++i) {
    mixer.add(flash_read(scene.corners, i));
  }
  for (uint16_t i = 0; i < scene.face_count; ++i) {
    mix_face(flash_read(scene.faces, i), mixer);
  }
  for (uint16_t i = 0; i < scene.material_count; ++i) {
    const Material material = flash_read(scene.materials, i);
    for (int c = 0; c < scene.channels; ++c) {
      mixer.add(material.reflectance[c]);
      mixer.add(material.emission[c]);
    }
  }
}

void mix_cells(const Scene& scene, Mixer& mixer) {
  for (uint16_t i = 0; i < scene.cell_row_count; ++i) {
    const CellRow row = flash_read(scene.cell_rows, i);
    mixer.add(row.first_element);
    mixer.add(row.first_cell);
    mixer.add(row.last_cell);
  }
  if (scene.roots == nullptr) {
    return;
  }
  for (uint16_t i = 0; i < scene.root_count; ++i) {
    mixer.add(flash_read(scene.roots, i));
  }
  for (uint16_t i = 0; i < scene.cut_count; ++i) {
    const Cut cut = flash_read(scene.cuts, i);
    mixer.add_vector({cut.a, cut.b, cut.c});
    mixer.add(cut.left);
    mixer.add(cut.right);
  }
}

void mix_elements(const Scene& scene, Mixer& mixer) {
  for (uint16_t e = 0; e < scene.element_count; ++e) {
    const Element element = flash_read(scene.elements, e);
    mixer.add(element.area);
    mixer.add_vector(vec(element.eye));
    mixer.add(element.patch);
    mixer.add(element.face);
    mixer.add(element.material);
    mixer.add(flash_read(scene.patch_elements, e));
    mixer.add(static_cast<uint32_t>(sight_of(scene, e)));
  }
  for (uint16_t p = 0; p < scene.patch_count; ++p) {
    const Patch patch = flash_read(scene.patches, p);
    mixer.add(patch.face);
    mixer.add(patch.first_element);
    mixer.add(patch.element_count);
  }
}

void mix_table(const DeltaTable& table, Mixer& mixer) {
  mixer.add(table.resolution_log2);
  mixer.add(table.cosine != nullptr ? 1 : 0);
}

// Not inlined, so that what is called through a pointer has one caller that the check of the stack knows.
__attribute__((noinline)) void mix_view(State& state, uint16_t e, const DeltaTable& table, uint8_t turn,
                                        Mixer& mixer) {
  const Settings& settings = state.settings;
  const Element element = flash_read(state.scene.elements, e);
  const EyeSample sample = {{vec(element.eye), element.face, turn}, kRowOne, !state.is_closed, false};
  clear(state.row);
  const Status status = settings.engine(state.scene, table, sample, state.work, state.row);
  if (status == Status::ok && settings.near_field != nullptr) {
    settings.near_field(state.scene, e, state.work, state.row);
  }
  mixer.add(static_cast<uint32_t>(status));
  for (uint16_t j = 0; status == Status::ok && j < state.row.count; ++j) {
    mixer.add(state.row.share[j]);
  }
  clear(state.row);
}

void mix_engine(State& state, Mixer& mixer) {
  for (uint8_t i = 0; i < kIdentityEyes; ++i) {
    const uint32_t e = static_cast<uint32_t>(state.scene.element_count) * i / kIdentityEyes;
    const DeltaTable table = flash_read(state.settings.tables, i % state.settings.table_count);
    mix_view(state, static_cast<uint16_t>(e), table, static_cast<uint8_t>(i * kTurns / kIdentityEyes), mixer);
  }
}

void mix_probe(State& state, Mixer& mixer) {
  const DeltaTable table = flash_read(state.settings.probe, 0);
  const Element element = flash_read(state.scene.elements, 0);
  uint32_t share = 0;
  const Status status = hidden_share(state.scene, table, {vec(element.eye), element.face, 0},
                                     state.is_enclosed, state.work, share);
  mix_table(table, mixer);
  mixer.add(static_cast<uint32_t>(status));
  mixer.add(status == Status::ok ? share : 0);
}

uint64_t scene_digest(const Scene& scene) {
  Mixer mixer;
  mix_counts(scene, mixer);
  mix_faces(scene, mixer);
  mix_cells(scene, mixer);
  mix_elements(scene, mixer);
  return mixer.hash();
}

uint64_t settings_digest(State& state) {
  const Settings& settings = state.settings;
  const uint32_t numbers[] = {kBitsRevision,
                              settings.stop.raw,
                              settings.flux_per_row.raw,
                              settings.flux_per_eye.raw,
                              settings.overshoot ? 1u : 0u,
                              settings.near_field != nullptr ? 1u : 0u,
                              settings.table_count};
  Mixer mixer;
  for (const uint32_t number : numbers) {
    mixer.add(number);
  }
  for (uint8_t i = 0; i < settings.table_count; ++i) {
    mix_table(flash_read(settings.tables, i), mixer);
  }
  const uint16_t spans = state.work.span_high_water;
  const uint32_t gaps = state.work.gaps_closed;
  mix_engine(state, mixer);
  mix_probe(state, mixer);
  state.work.span_high_water = spans;
  state.work.gaps_closed = gaps;
  return mixer.hash();
}

}  // namespace

Identity identify(State& state) {
  abandon_shot(state);
  const uint64_t scene = scene_digest(state.scene);
  return {scene, settings_digest(state), state.scene.element_count};
}

}  // namespace fixrad
