// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/report/text.h"
#include "host_sim/sweep/sweep.h"

namespace fixrad::host {
namespace {

std::string column_of(const CostModel& model) {
  std::string name = model.target + "_" + model.unit;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

void append_field(std::string& row, double value) {
  row += ",";
  append_number(row, value);
}

// Per cent to four decimals: what is behind them is below the truth's standard error.
double percent(double part) {
  return std::round(part * 1e6) / 1e4;
}

void append_field(std::string& row, std::uint64_t value) {
  row += "," + std::to_string(value);
}

std::string row_of(const SweepPoint& point, const std::string& command_start) {
  std::string row = point.options.profile + "," + point.options.engine;
  row += point.resolution > 0 ? "," + std::to_string(point.resolution) : ",";
  append_field(row, point.flux_per_row);
  append_field(row, point.flux_per_eye);
  append_field(row, point.options.unshot);
  for (const std::uint64_t count :
       {std::uint64_t{point.elements}, std::uint64_t{point.patches}, std::uint64_t{point.shots},
        std::uint64_t{point.eyes}, std::uint64_t{point.ram_bytes}, std::uint64_t{point.rom_bytes}}) {
    append_field(row, count);
  }
  append_field(row, percent(point.mean_error));
  append_field(row, percent(point.worst_error));
  append_field(row, point.host_seconds);
  for (const CostModel& model : cost_models()) {
    const std::optional<double> cost = cost_on(model, point);
    row += cost ? "," + std::to_string(static_cast<std::uint64_t>(*cost)) : ",";
  }
  char digest[20];
  std::snprintf(digest, sizeof digest, "%016llx", static_cast<unsigned long long>(point.digest));
  return row + "," + digest + "," + csv_field(command_start + " " + point.command) + "\n";
}

}  // namespace

std::string sweep_csv(const std::vector<SweepPoint>& points, const std::string& command_start) {
  std::string text =
      "profile,engine,resolution,flux_per_row,flux_per_eye,unshot,elements,patches,shots,eyes,ram_bytes,rom_"
      "bytes,"
      "mean_error_percent,worst_error_percent,host_seconds";
  for (const CostModel& model : cost_models()) {
    text += "," + column_of(model);
  }
  text += ",digest,command\n";
  for (const SweepPoint& point : points) {
    text += row_of(point, command_start);
  }
  return text;
}

}  // namespace fixrad::host
