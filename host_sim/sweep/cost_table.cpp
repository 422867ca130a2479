// SPDX-License-Identifier: MIT
// Made by scripts/fit_costs.py from firmware/measurements.json and calibration.json; do not edit.
// clang-format off
#include "host_sim/sweep/cost_model.h"

namespace fixrad::host {

const std::vector<CostModel>& cost_models() {
  static const std::vector<CostModel> models = {
      {"cortex-m0", "instructions",
       {1196, 0, 96.26, 1335, 120.4, 252.6, 246.4, 601.7, 41.17, 6.48, 315.1, 34.18, 37.55, 117.9, 176.9, 23.5, 33.08},
       0.0514, 13, 4, {"lunes", "rows", "pixels"}},
      {"cortex-m3", "instructions",
       {733, 50.43, 56.21, 956.3, 61.91, 147.6, 187.8, 282, 16.24, 90.87, 151.8, 21.8, 37.37, 63.5, 95.25, 9.964, 16.76},
       0.0493, 18, 4, {"lunes", "rows", "pixels"}},
      {"cortex-m4f", "instructions",
       {730.6, 53.62, 56.47, 941.9, 60.88, 146.8, 194.7, 287.7, 16.75, 108, 149.6, 19.41, 41.19, 60.93, 91.39, 9.255, 17.33},
       0.0451, 18, 4, {"lunes", "rows", "pixels"}},
      {"cortex-m7", "instructions",
       {733.6, 48.91, 56.79, 937.4, 61.47, 148, 193.7, 290.4, 17.58, 127, 148.1, 18.68, 41.86, 60.79, 91.19, 9.821, 17.37},
       0.0461, 18, 4, {"lunes", "rows", "pixels"}},
      {"rv32imc", "instructions",
       {816.7, 36.89, 63.99, 1254, 50.24, 157.2, 224.7, 331.7, 14.52, 85.6, 178.8, 11.28, 46.59, 57.84, 86.76, 8.942, 18.06},
       0.0518, 18, 4, {"lunes", "rows", "pixels"}},
      {"atmega2560", "cycles",
       {1.19e+04, 302.9, 859.9, 1.726e+04, 1280, 1089, 818.6, 3357, 587.8, 525.4, 2783, 452, 546.7, 943.5, 1415, 200.1, 322},
       0.0486, 10, 2, {"lunes", "rows", "pixels"}},
      {"esp8266", "instructions",
       {1004, 0.0408, 74.84, 1394, 62.81, 172.9, 241, 427.7, 18.8, 101, 198.8, 20.86, 45.17, 91.83, 137.7, 15.44, 26.44},
       0.0493, 18, 4, {"lunes", "rows", "pixels"}},
  };
  return models;
}

}  // namespace fixrad::host
