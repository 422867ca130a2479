// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/float_peer/lune_table.h"
#include "firmware/float_peer/view.h"
#include "lib/scene/status.h"

namespace fixrad {
namespace peer {

/// A row of form factors: share[j] / whole of what a shooter sends arrives at element j.
struct FormFactorRow {
  float* share;  ///< [count]
  uint16_t count;
  float whole;    ///< all of the row: the number of lunes of all eyes
  float escaped;  ///< hits nothing
  float back;     ///< the nearest hit is a back face
};

/// Empties the row.
void clear(FormFactorRow& row);

/// Lune rows: adds the form factors from one eye point to all elements to `row`, R in all. Without
/// backs the scene must be closed. Returns ok, or span_pool_full (`row` is then to be thrown away).
Status lune_rows(const Scene& scene, const LuneTable& table, const EyePoint& eye, Backs backs,
                 Workspace& work, FormFactorRow& row);

/// Fraction of the hemisphere that is hidden: the nearest face shows its back or, where `nothing_hides`,
/// there is no face at all. Statuses as above.
Status hidden_share(const Scene& scene, const LuneTable& table, const EyePoint& eye, bool nothing_hides,
                    Workspace& work, float& share);

}  // namespace peer
}  // namespace fixrad
