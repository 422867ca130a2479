// SPDX-License-Identifier: MIT
#include "tests/cli/tool.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

namespace fixrad::host::testing {
namespace {

// Only calls that are safe between fork and exec.
[[noreturn]] void become_tool(char* const* arguments, const char* out, const char* err) {
  const int out_file = ::open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = ::open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

bool catches_interrupts(pid_t pid) {
  std::istringstream status(contents("/proc/" + std::to_string(pid) + "/status"));
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("SigCgt:", 0) == 0) {
      return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
    }
  }
  return false;
}

}  // namespace

Tool::Tool(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {FIXRAD_TOOL};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const std::string out = folder_ / "out", err = folder_ / "err";
  pid_ = ::fork();
  if (pid_ == 0) {
    become_tool(pointers.data(), out.c_str(), err.c_str());
  }
}

Tool::~Tool() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
}

bool Tool::wait_until_interruptible() const {
  for (int i = 0; i < 1000; ++i) {
    if (catches_interrupts(pid_)) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

void Tool::interrupt() const {
  ::kill(pid_, SIGINT);
}

Outcome Tool::finish() {
  int status = 0;
  Outcome run;
  if (pid_ > 0 && ::waitpid(pid_, &status, 0) == pid_) {
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = contents(folder_ / "out");
    run.err = contents(folder_ / "err");
  }
  pid_ = -1;
  return run;
}

Outcome run_tool(const std::vector<std::string>& arguments) {
  return Tool(arguments).finish();
}

std::string sample_scene(const std::string& name) {
  return std::string(FIXRAD_SOURCE_DIR) + "/scenes/" + name + ".obj";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

nlohmann::json baked_json(const std::string& scene, const std::vector<std::string>& options) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = {"bake", scene, "-o", folder / "baked.json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = run_tool(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return nlohmann::json::parse(contents(folder / "baked.json"), nullptr, false);
}

std::vector<FaceRow> baked_faces(const std::string& scene, const std::vector<std::string>& options) {
  const ScratchFolder folder;
  std::vector<std::string> arguments = {"bake", scene, "--faces-csv", folder / "faces.csv"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = run_tool(arguments);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::vector<std::string> lines = lines_of(contents(folder / "faces.csv"));
  std::vector<FaceRow> rows;
  if (lines.empty() || lines.front() != "face,material,area,B_r,B_g,B_b") {
    ADD_FAILURE() << "no header in --faces-csv";
    return rows;
  }
  lines.erase(lines.begin());
  for (std::string& line : lines) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    FaceRow row;
    fields >> row.face >> row.material >> row.area >> row.b[0] >> row.b[1] >> row.b[2];
    EXPECT_TRUE(fields && (fields >> std::ws).eof()) << line;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace fixrad::host::testing
