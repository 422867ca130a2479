// SPDX-License-Identifier: MIT
#include "tests/float_peer/peer_solution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fixrad::host {

Settings lune_settings(Fraction stop) {
  Settings settings;
  settings.engine = lune_rows;
  settings.table = &kLune32;
  settings.probe = &kLune4;
  settings.stop = stop;
  return settings;
}

PeerSolution::PeerSolution(const Solution& core) : device_(core.device()), peer_(std::make_unique<Peer>()) {
  Status status = peer_->load(device_.view(), core.state().settings);
  EXPECT_EQ(status, Status::ok) << describe(status);
  while (status == Status::ok) {
    status = peer_->step();
  }
  EXPECT_EQ(status, Status::converged) << describe(status);
}

std::vector<double> PeerSolution::radiosities(int channel) const {
  std::vector<double> all;
  for (std::size_t e = 0; e < device_.elements.size(); ++e) {
    const float b =
        peer_->element_radiosity(static_cast<std::uint16_t>(e), static_cast<std::uint8_t>(channel));
    all.push_back(static_cast<double>(b) * device_.unit_radiosity);
  }
  return all;
}

double PeerSolution::imbalance() const {
  const peer::State& s = peer_->state();
  double worst = 0;
  for (std::size_t c = 0; c < s.scene.channels; ++c) {
    double sum = static_cast<double>(s.emitted.c[c]) - static_cast<double>(s.escaped.c[c]) -
                 static_cast<double>(s.back.c[c]);
    for (std::size_t e = 0; e < s.scene.element_count; ++e) {
      const auto material = device_.materials[device_.elements[e].material];
      const double absorptance = 1 - std::ldexp(material.reflectance[c], -32);
      sum -= absorptance * static_cast<double>(s.received[e * s.scene.channels + c]);
    }
    for (std::size_t p = 0; p < s.scene.patch_count; ++p) {
      sum -= static_cast<double>(s.unshot[p * s.scene.channels + c]);
    }
    worst = std::max(worst, std::abs(sum) / static_cast<double>(s.emitted.c[c]));
  }
  return worst;
}

}  // namespace fixrad::host
