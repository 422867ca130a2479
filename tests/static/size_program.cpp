// SPDX-License-Identifier: MIT
// The least program that solves a scene in flash with `rows` at R = 16: what of it is the core is measured.
#include "firmware/scenes/closed_box_tiny.h"

namespace {

closed_box_tiny::Solver solver;

}  // namespace

int main() {
  fixrad::Settings settings;
  settings.engine = fixrad::hemicube_rows;
  settings.tables = settings.probe = &fixrad::kDelta16;
  settings.table_count = 1;
  fixrad::Status status = solver.load(closed_box_tiny::scene(), settings);
  while (status == fixrad::Status::ok) {
    status = solver.step();
  }
  return status == fixrad::Status::converged ? 0 : 1;
}
