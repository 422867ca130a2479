// SPDX-License-Identifier: MIT
#pragma once

#include "lib/transport/state.h"

namespace fixrad {

/// The full matrix of form factors between elements, for scenes small enough to hold it. Owned by the
/// storage.
struct FormFactorMatrix {
  uint16_t* share;  ///< [element_count][element_count], row = shooter, UQ0.16
  uint16_t* back;   ///< [element_count], UQ0.16, what each element loses to back faces; the rest of 1 escapes
  int32_t* exitent;  ///< [element_count][channels], flux that leaves each element
};

/// Fills one row of the matrix, that of element `e`; `e` runs from 0 to element_count - 1. Emitters get the
/// finest eye set. Returns ok or span_pool_full.
Status sample_matrix_row(State& state, FormFactorMatrix& matrix, uint16_t e);

/// One Gauss-Seidel sweep of (I - rho F) B = E in flux form: for each element in turn, gather what all others
/// send to it, received_j = sum_i exitent_i F_ij, and renew what it sends. Returns true once the changes of a
/// sweep sum to no more than settings.stop of the emitted flux times the gap to the solution that they leave.
/// Cost: element_count^2 64-bit products a channel.
bool gather_sweep(State& state, FormFactorMatrix& matrix);

/// Books what the final exitent flux does: received, escaped and back from running sums, unshot = what
/// elements would reflect now less what they sent. The ledger balances exactly.
void book_gathering(State& state, const FormFactorMatrix& matrix);

}  // namespace fixrad
