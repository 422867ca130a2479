// SPDX-License-Identifier: MIT
#include "host_sim/sweep/tune.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

namespace fixrad::host {
namespace {

constexpr double kMeshStep = 1.4;
constexpr std::uint32_t kMostElements = 2500;
constexpr double kTooDear = 3;  // times the guessed cost of the cheapest that was found
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

struct Candidate {
  BakeOptions options;
  std::uint32_t ram;
  double guess;  // grows roughly as the cost does
};

struct Stop {
  double unshot;
  bool ambient;
};

class Search {
 public:
  Search(const PreparedScene& scene, const Wish& wish, const BakeOptions& base, const Solve& solve)
      : scene_(scene), wish_(wish), base_(base), solve_(solve) {}

  Tuned run() {
    search_meshes(wish_.ram);
    refine();
    if (!result_.cheapest && !result_.interrupted) {
      find_enough();
    }
    return result_;
  }

 private:
  // Every profile's way to group elements, on every mesh that fits into `ram`; each plan once.
  std::vector<Candidate> candidates(std::uint32_t ram, const std::vector<int>& resolutions) const {
    std::vector<Candidate> all;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, int>> seen;
    const auto faces = static_cast<double>(scene_.faces.size());
    for (const char* profile : {"tiny", "small", "medium", "large"}) {
      for (double n = std::max(40.0, faces); n <= std::max<double>(kMostElements, faces); n *= kMeshStep) {
        for (const int resolution : resolutions) {
          BakeOptions options = base_;
          options.profile = profile;
          options.elements = static_cast<std::uint32_t>(n);
          options.resolution = resolution;
          const std::optional<Candidate> candidate = plan(options);
          if (candidate && candidate->ram <= ram &&
              seen.insert({planned_.sizes.elements, planned_.meshing.patch_count, planned_.sizes.patches,
                           resolution})
                  .second) {
            all.push_back(*candidate);
          }
        }
      }
    }
    return all;
  }

  std::optional<Candidate> plan(const BakeOptions& options) const {
    try {
      planned_ = make_plan(scene_, options);
    } catch (const InputError&) {  // does not fit
      return std::nullopt;
    }
    const double rows = 16 + planned_.resolution;
    return Candidate{options, ram_on(*wish_.model, planned_),
                     rows * planned_.meshing.patch_count * (200.0 + planned_.sizes.elements)};
  }

  void search_meshes(std::uint32_t ram) {
    std::vector<Candidate> all = candidates(ram, {8, 16, 32, 64});
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.guess < b.guess; });
    double dearest = kUnlimited;
    for (const Candidate& candidate : all) {
      if (candidate.guess > dearest || result_.interrupted) {
        break;
      }
      if (consider(candidate)) {
        dearest = std::min(dearest, kTooDear * candidate.guess);
      }
    }
  }

  // Eye points and stop fractions round what was found, or, where nothing was, finer ones round the closest.
  void refine() {
    const std::optional<SweepPoint>& start = result_.cheapest ? result_.cheapest : result_.closest;
    if (!start || result_.interrupted) {
      return;
    }
    const BakeOptions middle = start->options;
    const std::vector<Stop> stops = result_.cheapest
                                        ? std::vector<Stop>{{0.001, false}, {0.003, true}, {0.01, true}}
                                        : std::vector<Stop>{{0.001, false}, {0.0003, false}};
    const double factor = result_.cheapest ? 1 : 0.25;
    for (const double flux_per_eye : {0.003, 0.006, 0.012, 0.03, 0.08}) {
      for (const Stop& stop : stops) {
        BakeOptions options = middle;
        options.flux_per_eye = factor * flux_per_eye;
        options.unshot = stop.unshot;
        options.ambient = stop.ambient;
        const std::optional<Candidate> candidate = plan(options);
        if (candidate && !result_.interrupted) {
          consider(*candidate);
        }
      }
    }
  }

  // More memory than wished, by rising need, at a resolution that leaves the mesh as the limit.
  void find_enough() {
    const std::uint32_t most = find_profile("large")->ram_bytes;
    std::vector<Candidate> all = candidates(most, {64});
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.ram < b.ram; });
    for (const Candidate& candidate : all) {
      if (result_.enough || result_.interrupted) {
        return;
      }
      if (wish_.max_cost || candidate.ram > wish_.ram) {
        consider(candidate);
      }
    }
  }

  // Solves a candidate; true if it keeps to the wish.
  bool consider(const Candidate& candidate) {
    const SweepPoint point = solve_(candidate.options);
    if (point.interrupted) {
      result_.interrupted = true;
      return false;
    }
    ++result_.solved;
    const double cost = cost_on(*wish_.model, point).value_or(kUnlimited);
    const bool is_within = candidate.ram <= wish_.ram && cost <= wish_.max_cost.value_or(kUnlimited);
    const bool is_accurate = point.mean_error <= wish_.max_error;
    const auto cost_of = [&](const SweepPoint& p) { return cost_on(*wish_.model, p).value_or(kUnlimited); };
    if (is_within && is_accurate && (!result_.cheapest || cost < cost_of(*result_.cheapest))) {
      result_.cheapest = point;
    }
    if (is_within && (!result_.closest || point.mean_error < result_.closest->mean_error)) {
      result_.closest = point;
    }
    if (!is_within && is_accurate && (!result_.enough || cost < cost_of(*result_.enough))) {
      result_.enough = point;
    }
    return is_within && is_accurate;
  }

  const PreparedScene& scene_;
  const Wish& wish_;
  const BakeOptions& base_;
  const Solve& solve_;
  mutable BakePlan planned_;  // the last one
  Tuned result_;
};

}  // namespace

std::uint32_t ram_on(const CostModel& model, const BakePlan& plan) {
  const std::uint32_t on_target =
      pool_bytes(plan.sizes) + state_bytes(model.pointer_bytes) + plan.matrix_bytes;
  return std::max(on_target, plan.ram());
}

Tuned tune(const PreparedScene& scene, const Wish& wish, const BakeOptions& base, const Solve& solve) {
  return Search(scene, wish, base, solve).run();
}

}  // namespace fixrad::host
