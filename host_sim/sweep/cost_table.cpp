// SPDX-License-Identifier: MIT
// Made by scripts/fit_costs.py from firmware/measurements.json and calibration.json; do not edit.
// clang-format off
#include "host_sim/sweep/cost_model.h"

namespace fixrad::host {

const std::vector<CostModel>& cost_models() {
  static const std::vector<CostModel> models = {
      {"cortex-m0", "instructions",
       {983.2, 2.752, 97.05, 1747, 146.7, 163.6, 117.2, 510.6, 57.91, 87.8, 310.2, 30.93, 54.81, 38.34, 256.7, 19.44, 119.1},
       0.0433, 14, 4, {"lunes", "pixels", "rows"}},
      {"cortex-m3", "instructions",
       {603, 57.08, 52.5, 836.2, 65.8, 127.1, 135.7, 263.9, 29.29, 115.8, 152.3, 26.19, 37.19, 20.13, 139.2, 10.2, 55.34},
       0.0336, 19, 4, {"lunes", "pixels", "rows"}},
      {"cortex-m4f", "instructions",
       {583, 62.7, 53.05, 830.7, 63.24, 124.8, 133.5, 264.3, 29.73, 116, 155, 26.61, 36.92, 19.42, 142.1, 9.591, 55.45},
       0.0328, 19, 4, {"lunes", "pixels", "rows"}},
      {"cortex-m7", "instructions",
       {590.8, 62.27, 52.46, 806.7, 59.84, 126.8, 143.4, 266, 29.5, 134.7, 152.2, 26.89, 36.71, 19.36, 140.3, 9.364, 55.19},
       0.0330, 19, 4, {"lunes", "pixels", "rows"}},
      {"rv32imc", "instructions",
       {702.3, 38.67, 58.98, 1081, 57.72, 147.4, 168.7, 309.2, 31.52, 113.9, 178.6, 29.19, 36.36, 17.44, 155.5, 12.14, 58.58},
       0.0391, 19, 4, {"lunes", "pixels", "rows"}},
      {"atmega2560", "cycles",
       {9511, 600.1, 917.4, 1.931e+04, 1727, 1300, 445.2, 2930, 467.6, 1631, 2315, 491, 629.5, 325.6, 1642, 238.7, 873.5},
       0.0381, 10, 2, {"lunes", "pixels", "rows"}},
      {"esp8266", "instructions",
       {768.3, 14.66, 67.72, 1207, 73.17, 141.1, 154.1, 407, 35.5, 132.6, 197.4, 29.81, 42.68, 24.56, 172.6, 12.61, 79.38},
       0.0314, 19, 4, {"lunes", "pixels", "rows"}},
  };
  return models;
}

}  // namespace fixrad::host
