// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host_sim/bake/state_file.h"
#include "host_sim/cli/session.h"
#include "host_sim/report/text.h"

namespace fixrad::host {
namespace {

constexpr std::array<const char*, 3> kShooters = {"elements", "patches", "faces"};

// The ledger's unshot flux: the rest of it, which is exact in a state that the tool resumes.
std::int64_t unshot_balance(const SavedChannel& c) {
  return std::int64_t{c.emitted} - c.absorbed - c.escaped - c.back;
}

double unshot_fraction(const SavedHeader& header) {
  double worst = 0;
  for (int c = 0; c < header.channels; ++c) {
    const SavedChannel& channel = header.channel[c];
    if (channel.emitted > 0) {
      worst = std::max(worst, static_cast<double>(channel.unshot) / channel.emitted);
    }
  }
  return worst;
}

std::string page(const std::string& file, const SavedHeader& h) {
  std::ostringstream text;
  text << file << ": saved state of format " << h.version << ", " << h.length << " bytes, checksum right\n"
       << "  scene      " << hex(h.scene) << ": " << h.elements << " elements on " << h.faces << " faces, "
       << int{h.channels} << (h.channels == 1 ? " channel\n" : " channels\n") << "  settings   "
       << hex(h.settings) << "\n"
       << "  sequence   " << h.sequence << "\n"
       << "  shots      " << h.shots << " from " << h.eyes << " eye points, " << h.withdrawn
       << " withdrawn; now " << kShooters[h.kind] << " shoot\n"
       << "  unshot     " << std::fixed << std::setprecision(3) << 100 * unshot_fraction(h) << " %\n"
       << "  ledger, flux units, a line a channel:\n"
       << "     emitted =   absorbed +     unshot +    escaped +       back\n";
  for (int c = 0; c < h.channels; ++c) {
    const SavedChannel& channel = h.channel[c];
    text << std::setw(12) << channel.emitted << std::setw(13) << channel.absorbed << std::setw(13)
         << unshot_balance(channel) << std::setw(13) << channel.escaped << std::setw(13) << channel.back
         << "\n";
  }
  return text.str();
}

nlohmann::ordered_json json_of(const std::string& file, const SavedHeader& h) {
  nlohmann::ordered_json ledger;
  for (int c = 0; c < h.channels; ++c) {
    const SavedChannel& channel = h.channel[c];
    ledger["emitted"].push_back(channel.emitted);
    ledger["absorbed"].push_back(channel.absorbed);
    ledger["unshot"].push_back(unshot_balance(channel));
    ledger["escaped"].push_back(channel.escaped);
    ledger["back"].push_back(channel.back);
  }
  return {{"file", file},
          {"format", h.version},
          {"bytes", h.length},
          {"scene", hex(h.scene)},
          {"settings", hex(h.settings)},
          {"elements", h.elements},
          {"faces", h.faces},
          {"channels", h.channels},
          {"sequence", h.sequence},
          {"shots", h.shots},
          {"eyes", h.eyes},
          {"eyes_withdrawn", h.withdrawn},
          {"gaps_closed", h.gaps_closed},
          {"spans_used", h.spans_used},
          {"shooting", kShooters[h.kind]},
          {"unshot_fraction", unshot_fraction(h)},
          {"ledger", ledger}};
}

}  // namespace

int run_state(const CommonOptions& options) {
  check_folder(options.json);
  const SavedHeader header = StateFile(options.state).header();
  if (!options.quiet) {
    std::fputs(page(options.state, header).c_str(), stdout);
  }
  if (!options.json.empty()) {
    write_text(options.json, json_of(options.state, header).dump(2) + "\n");
  }
  return kDone;
}

}  // namespace fixrad::host
