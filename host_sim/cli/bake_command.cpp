// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host_sim/cli/frames.h"
#include "host_sim/cli/pictures.h"
#include "host_sim/cli/session.h"
#include "host_sim/io/atomic_file.h"
#include "host_sim/report/encode.h"
#include "host_sim/report/text.h"
#include "host_sim/report/writers.h"

namespace fixrad::host {
namespace {

nlohmann::ordered_json measured(const LoadedScene& scene, const CommonOptions& options,
                                const BakeResult& result) {
  nlohmann::ordered_json ledger = {{"unit_watts", result.device.unit_watts}};
  const std::pair<const char*, std::int64_t Ledger::*> columns[] = {{"emitted", &Ledger::emitted},
                                                                    {"absorbed", &Ledger::absorbed},
                                                                    {"unshot", &Ledger::unshot},
                                                                    {"escaped", &Ledger::escaped},
                                                                    {"back", &Ledger::back}};
  for (const auto& [name, member] : columns) {
    ledger[name] = nlohmann::ordered_json::array();
    for (const Ledger& l : result.ledger) {
      ledger[name].push_back(l.*member);
    }
  }
  return {{"scene", scene.model.path},
          {"profile", options.bake.profile},
          {"engine", options.bake.engine},
          {"solver", options.bake.solver},
          {"resolution", result.plan.resolution},
          {"overshoot", result.plan.overshoot},
          {"input_faces", scene.model.file_faces},
          {"faces", result.plan.sizes.faces},
          {"elements", result.plan.sizes.elements},
          {"patches", result.plan.meshing.patch_count},
          {"vertices", result.surface.positions.size()},
          {"triangles", result.surface.triangles.size()},
          {"channels", result.plan.sizes.channels},
          {"closed", result.is_closed},
          {"shots", result.shots},
          {"eyes", result.eyes},
          {"eyes_withdrawn", result.withdrawn},
          {"seconds", result.seconds},
          {"interrupted", result.interrupted},
          {"ram_bytes", result.plan.ram()},
          {"rom_bytes", result.device.rom_bytes()},
          {"span_pool", result.plan.sizes.spans},
          {"spans_used", result.spans_used},
          {"gaps_closed", result.gaps_closed},
          {"quantisation_error", scene.prepared.vertices.largest_error},
          {"unshot_fraction", result.unshot_fraction},
          {"digest", hex(result.digest)},
          {"display", result.display},
          {"display_seconds", result.display_seconds},
          {"display_digest", hex(result.display_digest)},
          {"ledger", ledger}};
}

using Write = std::function<void(const std::filesystem::path&)>;

Write writer_for(const std::filesystem::path& path, const BakedMesh& mesh, const Display& display,
                 const std::string& json, const Write& write_picture) {
  const std::string suffix = path.extension().string();
  const std::map<std::string, Write> writers = {
      {".hpp", [&](const std::filesystem::path& p) { write_hpp(p, mesh, display); }},
      {".glb", [&](const std::filesystem::path& p) { write_glb(p, mesh, display); }},
      {".ply", [&](const std::filesystem::path& p) { write_ply(p, mesh, display); }},
      {".png", write_picture},
      {".csv", [&](const std::filesystem::path& p) { write_csv(p, mesh, display); }},
      {".json", [&](const std::filesystem::path& p) { write_text(p, json); }},
  };
  return writers.at(suffix);
}

std::string faces_csv(const Model& model, const std::vector<glm::dvec3>& means) {
  const std::vector<double> areas = face_areas(model);
  std::string text = "face,material,area,B_r,B_g,B_b\n";
  for (std::size_t f = 0; f < means.size(); ++f) {
    text += std::to_string(f) + "," + csv_field(model.materials[model.faces[f].material].name);
    for (const double value : {areas[f], means[f].x, means[f].y, means[f].z}) {
      text += ",";
      append_number(text, value);
    }
    text += "\n";
  }
  return text;
}

std::string summary(const BakeResult& result) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << result.plan.sizes.elements << " elements, "
       << result.plan.meshing.patch_count << " patches, " << result.shots
       << (result.plan.matrix_bytes > 0 ? " sweeps, " : " shots, ") << 100 * result.unshot_fraction
       << " % unshot, " << result.seconds << " s, " << result.plan.ram() << " bytes of RAM, digest "
       << hex(result.digest) << "; " << result.surface.positions.size() << " vertices, ";
  if (result.display == "gather") {
    text << "each gathered, in " << result.display_seconds << " s";
  } else {
    text << "each the mean round it";
  }
  return text.str();
}

// What is not shown need not be gathered, unless it was asked for.
bool is_to_gather(const CommonOptions& options) {
  const bool is_shown =
      std::any_of(options.outputs.begin(), options.outputs.end(), [](const std::string& output) {
        const std::string suffix = std::filesystem::path(output).extension().string();
        return suffix != ".csv" && suffix != ".json";
      });
  return options.gathers_display.value_or(is_shown);
}

}  // namespace

int run_bake(const CommonOptions& options) {
  const StateOptions& state = options.bake.state;
  if (options.bake.solver == "gathering" && (!state.save.empty() || !state.resume.empty() || state.shots)) {
    throw InputError(
        "fixrad: error: only shooting can be saved, resumed and ended after some shots; leave out "
        "--solver gathering");
  }
  check_folder(state.save);
  for (const std::string& output : options.outputs) {
    check_folder(output);
  }
  check_folder(options.faces_csv);
  check_frames(options);
  const auto scene = load_scene(options);
  BakeResult result;
  FrameRecorder frames;
  {
    ProgressBar bar(options);
    const auto progress = [&](std::uint32_t shots, double unshot, double seconds) {
      return bar.update(shots, unshot, seconds);
    };
    result = bake(scene->prepared, options.bake, progress, frames.observer(options));
    if (is_to_gather(options) && !result.interrupted) {
      result.interrupted = !gather_display(result, options.display_mesh, progress);
    }
  }
  for (const std::string& line : explain(scene->prepared, result)) {
    say(options, line);
  }
  say(options, summary(result));
  if (!state.save.empty()) {
    say(options, "saved " + state.save);
  }
  if (result.interrupted && !options.keep_partial) {
    say(options, state.save.empty()
                     ? "interrupted: nothing written; --keep-partial keeps the solution so far"
                     : "interrupted: nothing else written; --resume " + state.save + " goes on from here");
    return kInterrupted;
  }
  const BakedMesh mesh = make_baked_mesh(*scene, result);
  const std::string json = measured(*scene, options, result).dump(2) + "\n";
  for (const std::string& output : options.outputs) {
    const auto write_picture = [&](const std::filesystem::path& p) {
      write_text(p, encode_png(make_picture(options, *scene, result, mesh)));
    };
    writer_for(output, mesh, options.display, json, write_picture)(output);
    say(options, "wrote " + output);
  }
  if (!options.faces_csv.empty()) {
    write_text(options.faces_csv,
               faces_csv(scene->model,
                         file_face_means(scene->model, result.device.overlaps, result.element_radiosity)));
    say(options, "wrote " + options.faces_csv);
  }
  if (!options.picture.frames.empty() && !frames.write(options, *scene, result, mesh)) {
    say(options, "interrupted: the frames so far are written");
    return kInterrupted;
  }
  if (result.interrupted) {
    say(options, "interrupted: this is the solution so far");
    return kInterrupted;
  }
  return kDone;
}

}  // namespace fixrad::host
