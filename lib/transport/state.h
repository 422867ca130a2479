// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/elements/eye_points.h"
#include "lib/form_factor/engine.h"
#include "lib/form_factor/near_field.h"
#include "lib/scene/load.h"
#include "lib/scene/shape.h"

namespace fixrad {

/// Fractions of the emitted flux: UQ0.32.
using Fraction = Q<uint32_t, 32>;

/// The fraction n/d, rounded down; n < d.
constexpr Fraction fraction(uint32_t n, uint32_t d) {
  return Fraction::from_raw(static_cast<uint32_t>((static_cast<uint64_t>(n) << 32) / d));
}

/// One shot: what a source is about to send.
struct Shot {
  EyeSource source;
  bool is_emission;           ///< what the (single) element emits, else what it has received and not sent on
  Flux unshot[kMaxChannels];  ///< of the source before the shot; emission: as amount
  Flux amount[kMaxChannels];  ///< more than `unshot` when overshooting
};

/// Sees what the solver does; for the host's twin, progress and tests. The functions may be null.
struct Observer {
  void* context;
  /// An eye point of the coming shot has been sampled with `table`.
  void (*on_eye)(void* context, const DeltaTable& table, const EyeSample& sample);
  void (*on_shot)(void* context, const Shot& shot);
  /// The eyes sampled since the last shot are withdrawn.
  void (*on_withdraw)(void* context);
};

struct Settings {
  Engine engine = lune_rows;
  const FIXRAD_FLASH DeltaTable* tables = kLunes;  ///< [table_count], each of twice the R of the one before
  uint8_t table_count = 4;                         ///< a shot takes the finer the more it sends
  const FIXRAD_FLASH DeltaTable* probe = kLunes;   ///< for the question whether an eye is buried
  Fraction stop = fraction(1, 1000);  ///< done when the sum of unshot flux is at most this, in every channel
  /// A shot is sampled with one row for each such part of the emitted flux: accuracy against time.
  Fraction flux_per_row = fraction(1, 10000);
  Fraction flux_per_eye = fraction(1, 10);  ///< an element gets an eye point for each such part
  bool overshoot = false;  ///< also shoot what the ambient estimate promises (Feda & Purgathofer 1992)
  NearField near_field = nullptr;  ///< corrects the rows of elements; null: they stay as sampled
  Observer observer = {nullptr, nullptr, nullptr, nullptr};
};

/// Who shoots next, and when: sources of one kind in order, each that has at least `threshold` to send, which
/// is within a factor of the most that any had when the pass began.
struct Sweep {
  SourceKind kind;
  uint16_t cursor;  ///< next element (also of a face: its first) or patch
  bool has_shot;    ///< in this pass
  bool grows;       ///< the pass has just turned to larger sources and is still to start
  uint64_t threshold;
  Radiosity ambient[kMaxChannels];  ///< lent in this pass; 0 without overshooting
};

/// What the sampling of a shot does next. The order of the first three is that of a patch or face, of the
/// others that of an element.
enum class SamplingStage : uint8_t {
  none,           ///< no shot is under way
  add_up,         ///< weights of a group's elements
  draw,           ///< the element of a group's next eye
  look_drawn,     ///< from its centroid
  try_centroid,   ///< is an element's centroid clear?
  look_centroid,  ///< from there alone
  choose,         ///< the clear eyes of an element's subdivision
  look_chosen,    ///< from them
  look_buried,    ///< from the centroid though it is buried
  complete,       ///< the row is
  corrected       ///< and its near field too
};

/// The eyes of an element that sends from several.
struct Subdivision {
  uint16_t element;
  uint16_t chosen;  ///< bit i: eye i of level x level is clear
};

/// How far the shot under way has come. What it has changed outside of row, work and this record is nothing
/// before it is complete. The view under way is in Workspace::at.
struct Sampling {
  SamplingStage stage;
  uint8_t turn;        ///< State::turn once the shot is complete
  uint8_t level;       ///< of the element's subdivision
  uint8_t eyes;        ///< that have been sampled
  uint16_t index;      ///< of the group's element, or of the candidate eye, that comes next
  uint16_t rows;       ///< that the shot is worth, all eyes; saturated
  uint16_t withdrawn;  ///< eyes found to be buried
  uint32_t total;      ///< of the group's weights
  union {
    uint32_t running;  ///< of the group's weights, up to index
    Subdivision parts;
  };
};

/// Everything a solver knows. The arrays belong to the storage.
struct State {
  Scene scene;
  /// All zeros until load(), so that a static solver takes no initial values from flash.
  Settings settings = {nullptr, nullptr, 0,     nullptr, {0},
                       {0},     {0},     false, nullptr, {nullptr, nullptr, nullptr, nullptr}};
  Workspace work;
  FormFactorRow row;
  int32_t* received;                      ///< [element][channel], flux received in all
  int32_t* accounts;                      ///< [channel][account_words()], see unshot.h
  uint64_t absorbing_area[kMaxChannels];  ///< sum of (1 - reflectance) area over the elements, UQ.3
  int32_t emitted[kMaxChannels];
  int32_t escaped[kMaxChannels];
  int32_t back[kMaxChannels];
  uint32_t shots;
  uint32_t eyes;
  uint32_t withdrawn;  ///< eye points thrown away because they were buried
  uint32_t a_row;   ///< settings.flux_per_row of what is emitted, all channels, in 4 flux units; at least 1
  uint32_t an_eye;  ///< flux_per_eye, likewise
  Sweep sweep;
  Sampling sampling;
  uint16_t next_emitter;  ///< elements before it have sent what they emit
  uint8_t turn;           ///< next angle of the fixed sequence
  bool is_closed;         ///< back faces are never the nearest
  bool is_enclosed;       ///< and no light can escape
};

/// A sum of flux over the carried channels as it decides who shoots and how. The channel of a grey scene
/// stands for three equal ones, so that both make the same decisions, to the bit.
inline uint64_t flux_meant(uint64_t sum, uint8_t carried) {
  return carried == 1 ? sum + 2 * sum : sum;
}

/// Puts `scene` into `state`: nothing received, every emitter's flux unshot. The caller has checked the
/// scene.
void reset(State& state, const Scene& scene, const Settings& settings);

/// The ledger, in flux units: emitted = absorbed + unshot + escaped + back, exactly, after every shot.
struct Ledger {
  int64_t emitted, absorbed, unshot, escaped, back;

  int64_t imbalance() const { return emitted - absorbed - unshot - escaped - back; }
};

/// Adds up channel `c` from what elements and their accounts hold. Cost: linear.
Ledger ledger(const State& state, int c);

/// Flux that element `e` has reflected in all, channel `c`; while light is lent it may be negative.
Flux reflected_flux(const State& state, uint16_t e, int c);

/// Flux that element `e` has emitted and reflected in all, channel `c`; never negative.
Flux exitent_flux(const State& state, uint16_t e, int c);

/// Ambient radiosity of what is still unshot, channel `c`, in flux a 2^-shift area unit with shift =
/// Scene::radiosity_shift (Cohen et al. 1988, "A Progressive Refinement Approach", equations 9-12): mean
/// unshot radiosity over 1 - mean reflectance. An estimate for display: it never enters the ledger.
Radiosity ambient_radiosity(const State& state, int c);

/// The same for a known sum of unshot flux.
Radiosity ambient_of(const State& state, int c, int64_t unshot);

/// Radiosity of element `e`, channel `c`: (emitted + reflected) / area, plus reflectance x `ambient`.
/// Saturates.
Radiosity element_radiosity(const State& state, uint16_t e, int c, Radiosity ambient);

}  // namespace fixrad
