// SPDX-License-Identifier: MIT
// Made by scripts/fit_costs.py from firmware/measurements.json and calibration.json; do not edit.
// clang-format off
#include "host_sim/sweep/cost_model.h"

namespace fixrad::host {

const std::vector<CostModel>& cost_models() {
  static const std::vector<CostModel> models = {
      {"cortex-m0", "instructions",
       {1024, 41.38, 87.07, 1339, 128, 203.6, 219.2, 553.6, 44.54, 108.4, 283, 35.34, 52.11, 42.86, 226.8, 15.23, 115.8},
       0.0326, 14, 4, {"lunes", "pixels", "rows"}},
      {"cortex-m3", "instructions",
       {621.2, 67.8, 48.89, 748.9, 59.28, 134.5, 167.2, 272.6, 24.12, 132.3, 145.8, 27.28, 36.66, 20.46, 138, 8.748, 55.26},
       0.0354, 19, 4, {"lunes", "pixels", "rows"}},
      {"cortex-m4f", "instructions",
       {605.2, 71.01, 49.45, 737, 58.87, 132.9, 166, 275.4, 24.59, 133.1, 147.7, 27.81, 36.28, 19.66, 142.1, 8.031, 55.72},
       0.0348, 19, 4, {"lunes", "pixels", "rows"}},
      {"cortex-m7", "instructions",
       {608.8, 67.27, 49.56, 738.3, 57.22, 132.9, 167.7, 275.4, 25.06, 151.4, 146.5, 27.86, 36.2, 19.2, 142.2, 8.13, 55.66},
       0.0350, 19, 4, {"lunes", "pixels", "rows"}},
      {"rv32imc", "instructions",
       {721.4, 56.99, 54.62, 971.2, 47.82, 152.5, 204.8, 312.6, 23.57, 134.1, 173.9, 29.86, 35.92, 18.26, 154.7, 9.77, 58.25},
       0.0401, 19, 4, {"lunes", "pixels", "rows"}},
      {"atmega2560", "cycles",
       {9063, 383.7, 928.8, 1.841e+04, 1817, 1131, 256.8, 3041, 576.4, 1188, 2530, 432.5, 620.2, 305.4, 1758, 242.1, 816},
       0.0387, 10, 2, {"lunes", "pixels", "rows"}},
      {"esp8266", "instructions",
       {793.8, 28.78, 62.83, 1068, 66.04, 152.7, 194.5, 420.4, 28.92, 149.5, 188.6, 31.19, 41.78, 25.51, 171.8, 10.59, 78.89},
       0.0338, 19, 4, {"lunes", "pixels", "rows"}},
  };
  return models;
}

}  // namespace fixrad::host
