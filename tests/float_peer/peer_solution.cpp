// SPDX-License-Identifier: MIT
#include "tests/float_peer/peer_solution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fixrad::host {

Settings peer_settings(Fraction stop) {
  Settings settings;
  settings.engine = lune_rows;
  settings.tables = kLunes;
  settings.table_count = 4;
  settings.probe = kLunes;
  settings.stop = stop;
  settings.flux_per_row = fraction(1, 40000);  // near ties of who shoots first then matter little
  return settings;
}

PeerSolution::PeerSolution(const Solution& core) : PeerSolution(core.device(), core.state().settings) {}

PeerSolution::PeerSolution(const DeviceScene& device, const Settings& settings)
    : device_(device), peer_(std::make_unique<Peer>()) {
  const Status status = peer_->load(device_.view(), settings);
  EXPECT_EQ(status, Status::ok) << describe(status);
}

Status PeerSolution::run() {
  Status status = Status::ok;
  while (status == Status::ok) {
    status = step();
  }
  return status;
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

// Once faces shoot, their accounts say it; until then it is what elements reflect less what they have sent.
// What they have not emitted yet comes on top.
double PeerSolution::unshot(std::size_t channel) const {
  const peer::State& s = peer_->state();
  const bool by_face = s.sweep.kind == SourceKind::face;
  double sum = 0;
  for (std::uint16_t e = s.next_emitter; e < s.scene.element_count; ++e) {
    sum += static_cast<double>(peer::emitted_flux(s, e, static_cast<std::uint8_t>(channel)));
  }
  for (std::size_t i = 0; i < (by_face ? s.scene.face_count : s.scene.element_count); ++i) {
    const double account = static_cast<double>(s.accounts[i * s.scene.channels + channel]);
    sum += by_face ? account : reflected(i, channel) - account;
  }
  return sum;
}

double PeerSolution::reflected(std::size_t element, std::size_t channel) const {
  const fixrad::Material& material = device_.materials[device_.elements[element].material];
  return std::ldexp(material.reflectance[channel], -32) * received(element, channel);
}

double PeerSolution::received(std::size_t element, std::size_t channel) const {
  const peer::State& s = peer_->state();
  return static_cast<double>(s.received[element * s.scene.channels + channel]);
}

double PeerSolution::imbalance() const {
  const peer::State& s = peer_->state();
  double worst = 0;
  for (std::size_t c = 0; c < s.scene.channels; ++c) {
    double sum = static_cast<double>(s.emitted.c[c]) - static_cast<double>(s.escaped.c[c]) -
                 static_cast<double>(s.back.c[c]) - unshot(c);
    for (std::size_t e = 0; e < s.scene.element_count; ++e) {
      sum -= received(e, c) - reflected(e, c);
    }
    worst = std::max(worst, std::abs(sum) / static_cast<double>(s.emitted.c[c]));
  }
  return worst;
}

}  // namespace fixrad::host
