// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/apps/compare_expected.h"

// What solve and bench print: one "key value..." a line, for people and for scripts.

namespace fixrad {
namespace report {

/// The solution: status, counts, digest, and for every channel "ledger CHANNEL emitted absorbed unshot
/// escaped back" and "imbalance CHANNEL n", which is 0; bytes of the solver.
void write_solution(const State& state, Status status, uint64_t digest, uint32_t solver_bytes);

/// High-water mark and size of the stack; false if it may have run over.
bool write_stack();

/// One line that says whether the solution is the expected one, else where it first differs.
void write_difference(const Difference& difference);

}  // namespace report
}  // namespace fixrad
