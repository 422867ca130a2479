// SPDX-License-Identifier: MIT
// Made by scripts/fit_costs.py from firmware/measurements.json and calibration.json; do not edit.
// clang-format off
#include "host_sim/sweep/cost_model.h"

namespace fixrad::host {

const std::vector<CostModel>& cost_models() {
  static const std::vector<CostModel> models = {
      {"cortex-m0", "instructions",
       {1178, 74.61, 85.2, 1029, 76.28, 181.2, 308.8, 517.8, 40.78, 282.4, 261.8, 93.98, 93.98, 48.55, 228.8, 13.34, 112.1},
       0.0273, 6, 4, {"lunes"}},
      {"cortex-m3", "instructions",
       {662.1, 60.12, 49.17, 662.1, 38.85, 95.66, 170.7, 225.5, 25.08, 225.6, 139, 52.47, 52.47, 23.34, 132.7, 8.3, 54.1},
       0.0288, 11, 4, {"lunes"}},
      {"cortex-m4f", "instructions",
       {641.1, 61.25, 49.37, 638.6, 36.07, 95.7, 170.1, 230.4, 25.01, 233.2, 140.6, 52.36, 52.36, 22.59, 133.3, 7.678, 54.37},
       0.0291, 11, 4, {"lunes"}},
      {"cortex-m7", "instructions",
       {647.6, 59.8, 49.55, 633.2, 34.34, 96.09, 173.7, 231.3, 25.33, 251.5, 139.3, 52.81, 52.81, 22.12, 134.5, 7.762, 54.32},
       0.0285, 11, 4, {"lunes"}},
      {"rv32imc", "instructions",
       {773.7, 56.57, 54.73, 806.2, 20.51, 105.9, 212.6, 255.7, 23.16, 272, 162.4, 59.46, 59.46, 22.17, 157.6, 8.408, 57.28},
       0.0345, 11, 4, {"lunes"}},
      {"atmega2560", "cycles",
       {9442, 1579, 840.2, 1.295e+04, 1522, 1714, 1595, 3956, 482.8, 1686, 2202, 817.1, 817.1, 394.2, 1775, 199.3, 823.3},
       0.0320, 5, 2, {"lunes"}},
      {"esp8266", "instructions",
       {887.3, 56.39, 62, 843.6, 33.94, 128.2, 245.6, 370.1, 27.56, 272.9, 177.3, 68.64, 68.64, 29.92, 181.2, 9.574, 77.05},
       0.0343, 11, 4, {"lunes"}},
  };
  return models;
}

}  // namespace fixrad::host
