// SPDX-License-Identifier: MIT
#include "host_sim/cli/frames.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "host_sim/cli/pictures.h"
#include "host_sim/report/encode.h"
#include "host_sim/report/frame_page.h"
#include "host_sim/report/text.h"
#include "lib/transport/unshot.h"

namespace fixrad::host {
namespace {

std::string file_name(std::uint32_t shots, bool with_ambient) {
  char name[32];
  std::snprintf(name, sizeof name, "%04u%s.png", shots, with_ambient ? "_ambient" : "");
  return name;
}

double as_double(Fraction fraction) {
  return std::ldexp(static_cast<double>(fraction.raw), -32);
}

// `mesh` with the vertex colours of an earlier state. Its elements stay those of the finished solution, so
// that the exposure does.
BakedMesh mesh_of(const State& state, bool with_ambient, const BakeResult& result, const BakedMesh& mesh) {
  BakedMesh frame = mesh;
  const VertexMap map = result.surface.map();
  for (int c = 0; c < 3; ++c) {
    const int channel = state.scene.channels == 1 ? 0 : c;
    const Radiosity ambient = with_ambient ? ambient_radiosity(state, channel) : Radiosity::from_raw(0);
    for (std::uint32_t v = 0; v < map.vertex_count; ++v) {
      frame.radiosity[v][c] =
          result.device.unit_radiosity * vertex_radiosity(state, map, v, channel, ambient).raw;
    }
  }
  return frame;
}

// Makes and writes the frames of one sequence.
class FrameWriter {
 public:
  FrameWriter(const CommonOptions& options, const BakeResult& result)
      : options_(options), result_(result), folder_(options.picture.frames) {}

  void write(std::uint32_t shots, double unshot_fraction, bool with_ambient, const BakedMesh& mesh) {
    const Image image = draw_vertices(options_, result_, mesh, options_.display);
    const std::string name = file_name(shots, with_ambient);
    write_text(folder_ / name, encode_png(image));
    frames_.push_back({name, shots, unshot_fraction, with_ambient, thumbnail(image)});
  }

  void write_page(const std::string& scene) const {
    write_text(folder_ / "index.html", frame_page(scene, frames_));
    say(options_,
        "wrote " + std::to_string(frames_.size()) + " frames and " + (folder_ / "index.html").string());
  }

 private:
  const CommonOptions& options_;
  const BakeResult& result_;
  std::filesystem::path folder_;
  std::vector<Frame> frames_;
};

}  // namespace

void check_frames(const CommonOptions& options) {
  const std::string& folder = options.picture.frames;
  if (folder.empty()) {
    return;
  }
  if (options.bake.solver == "gathering") {
    throw InputError("fixrad: error: --frames shows shots; leave out --solver gathering");
  }
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw InputError(folder + ": error: cannot make the folder of the frames: " +
                     (error ? error.message() : "a file has this name") + "; create it or name another one");
  }
}

std::function<Observer(const State&)> FrameRecorder::observer(const CommonOptions& options) {
  if (options.picture.frames.empty()) {
    return {};
  }
  return [this](const State& state) {
    watched_ = &state;
    Observer observer = {};
    observer.context = this;
    observer.on_shot = [](void* context, const Shot&) { static_cast<FrameRecorder*>(context)->keep(); };
    return observer;
  };
}

// Called before the next shot is booked.
void FrameRecorder::keep() {
  const State& state = *watched_;
  const std::uint32_t shots = state.shots;
  if (shots == 0 || (shots & (shots - 1)) != 0) {
    return;
  }
  const std::size_t elements = state.scene.element_count, channels = state.scene.channels;
  const std::size_t words = channels * account_words(state.scene.element_count, state.scene.face_count);
  moments_.push_back({state,
                      {state.received, state.received + elements * channels},
                      {state.accounts, state.accounts + words},
                      as_double(unshot_fraction(state))});
}

bool FrameRecorder::write(const CommonOptions& options, const LoadedScene& scene, const BakeResult& result,
                          const BakedMesh& mesh) const {
  FrameWriter writer(options, result);
  for (const Moment& moment : moments_) {
    State state = moment.state;
    std::vector<std::int32_t> received = moment.received, accounts = moment.accounts;
    state.scene = result.device.view();
    state.received = received.data();
    state.accounts = accounts.data();
    for (const bool with_ambient : {false, true}) {
      if (is_interrupted()) {
        return false;
      }
      writer.write(state.shots, moment.unshot_fraction, with_ambient,
                   mesh_of(state, with_ambient, result, mesh));
    }
  }
  writer.write(result.shots, result.unshot_fraction, false, mesh);
  writer.write_page(std::filesystem::path(scene.model.path).stem().string());
  return true;
}

}  // namespace fixrad::host
