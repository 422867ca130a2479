// SPDX-License-Identifier: MIT
#include "host_sim/sweep/tune.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

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
  // Every mesh that fits into `ram`, once, in the smallest profile that holds it.
  std::vector<Candidate> candidates(std::uint32_t ram, const std::vector<double>& row_factors) const {
    std::vector<Candidate> all;
    std::set<std::uint32_t> seen;
    const auto faces = static_cast<double>(scene_.faces.size());
    for (const char* profile : {"tiny", "small", "medium", "large"}) {
      for (double n = std::max(40.0, faces); n <= std::max<double>(kMostElements, faces); n *= kMeshStep) {
        BakeOptions options = base_;
        options.profile = profile;
        options.elements = static_cast<std::uint32_t>(n);
        const std::optional<BakePlan> plan = plan_of(options);
        if (!plan) {
          continue;  // this mesh needs more elements than these
        }
        if (ram_on(*wish_.model, *plan) > ram || 2 * plan->sizes.elements < n) {
          break;  // finer meshes do not fit either
        }
        if (seen.insert(plan->sizes.elements).second) {
          const double own = flux_per_row(options, *plan);
          for (const double factor : row_factors) {
            options.flux_per_row = short_value(factor * own);
            all.push_back(candidate_of(options, *plan));
          }
        }
      }
    }
    return all;
  }

  std::optional<BakePlan> plan_of(const BakeOptions& options) const {
    try {
      return make_plan(scene_, options);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  // Rows cost time, not memory: the plan of one number of rows serves all. Rows are what strong shots add to
  // the few that each of some ten shots an element takes; each crosses about the root of the elements.
  Candidate candidate_of(const BakeOptions& options, const BakePlan& plan) const {
    const double n = plan.sizes.elements;
    const double rows = 2 / flux_per_row(options, plan) + 40 * n;
    return {options, ram_on(*wish_.model, plan), rows * (20 + std::sqrt(n)) + 10 * n * n};
  }

  void search_meshes(std::uint32_t ram) {
    std::vector<Candidate> all = candidates(ram, {8, 4, 2, 1, 0.5, 0.25});
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

  // Rows, eye points and stop fractions: cheaper ones round what was found or, where all were too dear, round
  // the cheapest; finer ones where the error is what is missing.
  void refine() {
    const bool is_missing_accuracy = !result_.cheapest && result_.closest;
    const std::optional<SweepPoint>& start = result_.cheapest  ? result_.cheapest
                                             : result_.closest ? result_.closest
                                                               : least_;
    if (!start || result_.interrupted) {
      return;
    }
    const BakeOptions middle = start->options;
    const std::vector<Stop> stops = is_missing_accuracy
                                        ? std::vector<Stop>{{0.001, false}, {0.0003, false}}
                                        : std::vector<Stop>{{0.001, false}, {0.003, true}, {0.01, true}};
    const std::vector<double> factors =
        is_missing_accuracy ? std::vector<double>{1, 0.5, 0.25} : std::vector<double>{0.7, 1, 1.4, 2};
    for (const double factor : factors) {
      for (const double flux_per_eye : {0.03, 0.1, 0.3}) {
        for (const Stop& stop : stops) {
          BakeOptions options = middle;
          options.flux_per_row = short_value(factor * start->flux_per_row);
          options.flux_per_eye = flux_per_eye;
          options.unshot = stop.unshot;
          options.ambient = stop.ambient;
          const std::optional<BakePlan> plan = plan_of(options);
          if (plan && !result_.interrupted) {
            consider(candidate_of(options, *plan));
          }
        }
      }
    }
  }

  // More memory than wished, by rising need, with so many rows that the mesh is the limit.
  void find_enough() {
    const std::uint32_t most = find_profile("large")->ram_bytes;
    std::vector<Candidate> all = candidates(most, {0.25});
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

  // How many times the wished error a point has.
  double excess(const SweepPoint& point) const {
    const double worst = wish_.max_worst ? point.worst_error / *wish_.max_worst : 0;
    return std::max(point.mean_error / wish_.max_error, worst);
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
    const bool is_accurate =
        point.mean_error <= wish_.max_error && point.worst_error <= wish_.max_worst.value_or(kUnlimited);
    const auto cost_of = [&](const SweepPoint& p) { return cost_on(*wish_.model, p).value_or(kUnlimited); };
    if (candidate.ram <= wish_.ram && (!least_ || cost < cost_of(*least_))) {
      least_ = point;
    }
    if (is_within && is_accurate && (!result_.cheapest || cost < cost_of(*result_.cheapest))) {
      result_.cheapest = point;
    }
    if (is_within && (!result_.closest || excess(point) < excess(*result_.closest))) {
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
  Tuned result_;
  std::optional<SweepPoint> least_;  // the cheapest in the wished memory, whatever its error
};

}  // namespace

std::uint32_t ram_on(const CostModel& model, const BakePlan& plan) {
  return std::max(pool_bytes(plan.sizes) + plan.matrix_bytes + state_bytes(model.pointer_bytes), plan.ram());
}

std::uint32_t ram_on(const CostModel& model, const SweepPoint& point) {
  return std::max(point.pools + state_bytes(model.pointer_bytes), point.ram_bytes);
}

Tuned tune(const PreparedScene& scene, const Wish& wish, const BakeOptions& base, const Solve& solve) {
  return Search(scene, wish, base, solve).run();
}

}  // namespace fixrad::host
