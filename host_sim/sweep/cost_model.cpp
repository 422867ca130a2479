// SPDX-License-Identifier: MIT
#include "host_sim/sweep/cost_model.h"

#include <algorithm>

namespace fixrad::host {

bool CostModel::knows(const std::string& engine) const {
  return std::find(engines.begin(), engines.end(), engine) != engines.end();
}

const CostModel* find_cost_model(const std::string& target) {
  for (const CostModel& model : cost_models()) {
    if (model.target == target) {
      return &model;
    }
  }
  return nullptr;
}

double cost(const CostModel& model, const Work& work) {
  double sum = 0;
  for (unsigned i = 0; i < kWorkUnits; ++i) {
    sum += model.weights[i] * static_cast<double>(work[i]);
  }
  return sum;
}

}  // namespace fixrad::host
