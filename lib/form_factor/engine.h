// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "lib/form_factor/delta_table.h"
#include "lib/form_factor/row.h"
#include "lib/form_factor/view.h"
#include "lib/scene/status.h"

namespace fixrad {

/// How one eye point is to be sampled.
struct EyeSample {
  EyePoint eye;
  uint32_t weight;        ///< the eye's part of kRowOne
  bool back_faces;        ///< back faces block; without, the scene must be closed
  bool is_clear = false;  ///< not buried: the backs of sealed faces are hidden by their bodies' fronts
};

inline Backs backs_in(const EyeSample& sample) {
  return !sample.back_faces ? Backs::none : (sample.is_clear ? Backs::unsealed : Backs::all);
}

/// An engine adds the form factors from one eye point to all elements to `row`, exactly `weight` in all.
/// Statuses: ok; in_progress (work.budget was used up: the next call, with the same arguments, goes on from
/// work.at, to the same bits as if nothing had been between); span_pool_full (`row` is then to be thrown
/// away). work.at is to be all zeros where a view begins, and is where one ends.
using Engine = Status (*)(const Scene& scene, const DeltaTable& table, const EyeSample& sample,
                          Workspace& work, FormFactorRow& row);

/// For engines: says that the view is complete, or cannot be.
inline Status end_view(Workspace& work, Status status) {
  forget_view(work);
  return status;
}

/// Hemicube rows: visibility between faces with sub-pixel ends, then each visible span split by its face's
/// element grid. Cost: grows with what is seen, not with the number of elements.
Status hemicube_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                     FormFactorRow& row);

/// Lune rows: the same on rows of equal weight round one axis, with a table of kLune*: one projection instead
/// of five, and a third of the rows (docs/lunes.md).
Status lune_rows(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                 FormFactorRow& row);

/// The classical hemicube (Cohen & Greenberg 1985): each element's polygon is scan-converted into an item
/// buffer of R x R pixels a side. The baseline. Status
/// item_buffer_too_small unless item_capacity >= R * R.
Status hemicube_pixels(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                       FormFactorRow& row);

/// Lambert's contour formula to every element: the closed form, for scenes where nothing stands between two
/// faces; what hides another is not noticed. Both then count, a row that passes 1 is cut, and elements late
/// in the tables vanish. The table is not read. Cost: a clip and 5 corners of contour_factor() an element.
Status contour_row(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
                   FormFactorRow& row);

/// Ray casting: to every element the closed form, times the part of 2^k rays (k = table.resolution_log2, 2 to
/// 5; nothing else of the table is read) that nothing blocks between points spread over the eye's element and
/// over the receiver. An eye that stands for its element alone takes the mean over four points of it to
/// elements nearer than twice the larger one's size. What reaches no front at all is measured on 16 lunes;
/// all entries share the rest in proportion, so that the noise of the rays makes no light and loses none.
/// Cost: the contours of contour_row(), 2^k rays an element where some face can stand between, and
/// hidden_share(). Status span_pool_full as hidden_share().
Status ray_row(const Scene& scene, const DeltaTable& table, const EyeSample& sample, Workspace& work,
               FormFactorRow& row);

/// An eye that has more than this part of what hidden_share() looks at hidden is buried.
constexpr uint32_t kBuriedShare = kRowOne / 2;

/// Fraction of a hemicube's top, or of all lunes, UQ12.20, that is hidden: the nearest face shows its back,
/// or, where `nothing_hides`, there is no face at all (from inside an enclosed scene: the eye lies behind a
/// wall). The top alone, since what buries an eye stands over it. Goes on from work.at and
/// stops at the end of work.budget as an engine does. Cost: R rows.
Status hidden_share(const Scene& scene, const DeltaTable& table, const EyePoint& eye, bool nothing_hides,
                    Workspace& work, uint32_t& share);

}  // namespace fixrad
