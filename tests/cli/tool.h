// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/report/scratch_folder.h"

namespace fixrad::host::testing {

/// What a finished run of the tool left behind.
struct Outcome {
  int exit_code = -1;  ///< 128 + signal if a signal ended it
  std::string out, err;
};

/// The tool running as a child process, its output going to files: no terminal.
class Tool {
 public:
  explicit Tool(const std::vector<std::string>& arguments);
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;
  /// Ends the child if it still runs.
  ~Tool();

  /// Returns once the child catches SIGINT; false if it ended or did not within ten seconds.
  bool wait_until_interruptible() const;
  void interrupt() const;
  /// Waits for the end.
  Outcome finish();

 private:
  ScratchFolder folder_;
  pid_t pid_ = -1;
};

/// Runs the tool to its end.
Outcome run_tool(const std::vector<std::string>& arguments);

/// Path of scenes/NAME.obj.
std::string sample_scene(const std::string& name);

std::vector<std::string> lines_of(const std::string& text);

/// Names of all that is in a folder, hidden files too, sorted.
std::vector<std::string> names_in(const std::string& folder);

/// `fixrad bake SCENE -o FILE.json OPTIONS...`, which must succeed; what the file says.
nlohmann::json baked_json(const std::string& scene, const std::vector<std::string>& options = {});

/// One line of --faces-csv.
struct FaceRow {
  int face = -1;
  std::string material;
  double area = 0, b[3] = {};
};

/// `fixrad bake SCENE --faces-csv FILE OPTIONS...`, which must succeed; its lines, with the header checked.
std::vector<FaceRow> baked_faces(const std::string& scene, const std::vector<std::string>& options = {});

}  // namespace fixrad::host::testing
