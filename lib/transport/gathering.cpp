// SPDX-License-Identifier: MIT
#include "lib/transport/gathering.h"

#include "lib/fixed/cutter.h"
#include "lib/transport/sampling.h"
#include "lib/transport/shooting.h"
#include "lib/transport/unshot.h"

namespace fixrad {
namespace {

// The matrix keeps 16 bits an entry.
constexpr uint32_t kMatrixUnit = kRowOne >> 16;

// Rounds running sums, so that a row that loses nothing still does. UQ0.16 cannot hold the 1.0 of an element
// that fills the whole hemisphere; its last unit then goes to a neighbour.
void store_row(const FormFactorRow& row, FormFactorMatrix& matrix, uint16_t e) {
  uint16_t* entries = matrix.share + static_cast<uint32_t>(e) * row.count;
  uint32_t sum = 0;
  uint32_t stored = 0;
  for (uint16_t j = 0; j < row.count; ++j) {
    sum += row.share[j];
    uint32_t part = sum / kMatrixUnit - stored;
    count_cut(part > 0xffffu, Place::matrix_entry);
    if (part > 0xffffu) {
      part = 0xffffu;
      if (j > 0) {
        entries[j - 1] = static_cast<uint16_t>(entries[j - 1] + 1);
        ++stored;
      }
    }
    entries[j] = static_cast<uint16_t>(part);
    stored += part;
  }
  const uint32_t back = (sum + row.back) / kMatrixUnit - stored;
  matrix.back[e] = static_cast<uint16_t>(saturate(back, Place::matrix_entry, 0xffffu));
}

struct Light {
  Reflectance reflectance;
  Flux emitted;
};

Light light_of(const Scene& scene, uint16_t e, int c) {
  const Element element = flash_read(scene.elements, e);
  const Material material = flash_read(scene.materials, element.material);
  return {Reflectance::from_raw(material.reflectance[c]), emitted_flux(scene, material, element.area, c)};
}

Flux gather(const State& state, const FormFactorMatrix& matrix, uint16_t j, int c) {
  const uint32_t n = state.scene.element_count;
  const uint32_t channels = state.scene.channels;
  uint64_t sum = 0;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t exitent = static_cast<uint32_t>(matrix.exitent[i * channels + static_cast<uint32_t>(c)]);
    sum += static_cast<uint64_t>(exitent) * matrix.share[i * n + j];
  }
  return Flux::from_raw(static_cast<int32_t>(sum >> 16));
}

}  // namespace

Status sample_matrix_row(State& state, FormFactorMatrix& matrix, uint16_t e) {
  const Scene& scene = state.scene;
  bool emits = false;
  for (int c = 0; c < scene.channels; ++c) {
    const Light light = light_of(scene, e, c);
    matrix.exitent[static_cast<uint32_t>(e) * scene.channels + static_cast<uint32_t>(c)] = light.emitted.raw;
    emits = emits || light.emitted.raw > 0;
  }
  const Settings& settings = state.settings;
  const uint32_t rows = static_cast<uint32_t>(1)
                        << flash_read(settings.tables, settings.table_count - 1u).resolution_log2;
  const Status status = sample_element(state, e, emits ? 9 : 1, emits ? 9 * rows : rows);
  if (status != Status::ok) {
    return status;
  }
  if (state.settings.near_field != nullptr) {
    const Status corrected = state.settings.near_field(scene, e, state.work, state.row);
    if (corrected != Status::ok) {
      return corrected;
    }
  }
  store_row(state.row, matrix, e);
  return Status::ok;
}

bool gather_sweep(State& state, FormFactorMatrix& matrix) {
  const Scene& scene = state.scene;
  bool done = true;
  ++state.shots;
  for (int c = 0; c < scene.channels; ++c) {
    uint64_t change = 0;
    for (uint16_t j = 0; j < scene.element_count; ++j) {
      const Light light = light_of(scene, j, c);
      int32_t& exitent = matrix.exitent[static_cast<uint32_t>(j) * scene.channels + static_cast<uint32_t>(c)];
      const Flux renewed = light.emitted + reflect(light.reflectance, gather(state, matrix, j, c));
      change += magnitude(renewed.raw - exitent);
      exitent = renewed.raw;
    }
    const uint64_t limit =
        (static_cast<uint64_t>(state.settings.stop.raw) * static_cast<uint32_t>(state.emitted[c])) >> 32;
    done = done && change <= limit;
  }
  return done;
}

void book_gathering(State& state, const FormFactorMatrix& matrix) {
  const Scene& scene = state.scene;
  const uint32_t channels = scene.channels;
  for (uint32_t i = 0; i < scene.element_count * channels; ++i) {
    state.received[i] = 0;
  }
  start_face_accounts(state);
  for (uint32_t c = 0; c < channels; ++c) {
    state.escaped[c] = state.back[c] = 0;
    for (uint32_t i = 0; i < scene.element_count; ++i) {
      const Flux amount = Flux::from_raw(matrix.exitent[i * channels + c]);
      FluxCutter cutter(amount, 0);
      uint32_t left = kRowOne;
      for (uint32_t j = 0; j < scene.element_count; ++j) {
        const uint32_t part = matrix.share[i * scene.element_count + j] * kMatrixUnit;
        state.received[j * channels + c] += cutter.cut(part).raw;
        left -= part;
      }
      state.back[c] += cutter.cut(matrix.back[i] * kMatrixUnit).raw;
      state.escaped[c] += cutter.cut(left - matrix.back[i] * kMatrixUnit).raw;
    }
    for (uint16_t j = 0; j < scene.element_count; ++j) {
      const Light light = light_of(scene, j, static_cast<int>(c));
      const Flux reflected = reflect(light.reflectance, Flux::from_raw(state.received[j * channels + c]));
      account_unshot(state, flash_read(scene.elements, j).face, static_cast<int>(c),
                     light.emitted + reflected - Flux::from_raw(matrix.exitent[j * channels + c]));
    }
  }
}

}  // namespace fixrad
