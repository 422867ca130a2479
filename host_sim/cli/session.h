// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/cli/options.h"

namespace fixrad::host {

/// A scene that has been read and prepared. PreparedScene points at the model, so it does not move.
struct LoadedScene {
  Model model;
  PreparedScene prepared;
};

/// Reads the scene and says its warnings on stderr.
std::unique_ptr<LoadedScene> load_scene(const CommonOptions& options);

/// A line on stderr, unless --quiet.
void say(const CommonOptions& options, const std::string& line);

/// Makes Ctrl-C set a flag instead of ending the program.
void catch_interrupt();
bool is_interrupted();

/// Makes Ctrl-C end the program at once with kInterrupted, for work that cannot be asked to stop and has no
/// file open. catch_interrupt() takes it back.
void exit_on_interrupt();

/// Throws InputError unless the folder of `file` exists; an empty name is no file. Asked before any work:
/// nobody wants to wait for a result that has nowhere to go, or find half of the files.
void check_folder(const std::string& file);

/// Progress of a solution: a bar with shots, unshot fraction and time left on a terminal, nothing in a log.
class ProgressBar {
 public:
  explicit ProgressBar(const CommonOptions& options);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// False once the user has interrupted.
  bool update(std::uint32_t shots, double unshot_fraction, double seconds);

 private:
  double stop_;
  bool visible_;
  bool drawn_ = false;
};

/// The result as renderers and writers want it.
BakedMesh make_baked_mesh(const LoadedScene& scene, const BakeResult& result);

/// Radiosity of each input face of the file, W/m^2. With --two-sided, of its brighter side.
std::vector<glm::dvec3> file_face_means(const Model& model, const std::vector<Overlap>& overlaps,
                                        const std::vector<glm::dvec3>& element_radiosity);

}  // namespace fixrad::host
