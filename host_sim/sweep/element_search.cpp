// SPDX-License-Identifier: MIT
#include "host_sim/sweep/element_search.h"

#include <algorithm>

namespace fixrad::host {
namespace {

constexpr double kStep = 1.4;
constexpr std::uint32_t kMostElements = 6000;  // seconds a solution

// Meshes of one profile, coarse to fine.
class ProfileSearch {
 public:
  /// `fitting`: a plan of that profile.
  ProfileSearch(const PreparedScene& scene, const BakePlan& fitting, double max_error, const Solve& solve,
                ElementNeed& need)
      : scene_(scene), fitting_(fitting), max_error_(max_error), solve_(solve), need_(need) {}

  /// From `elements` upwards, until two meshes in a row keep to the error or the memory is full. Returns the
  /// number of elements of the last mesh.
  std::uint32_t run(BakeOptions options, std::uint32_t elements) {
    std::optional<SweepPoint> first_good;
    std::uint32_t last = 0;
    for (double wanted = elements; wanted <= kMostElements && fits(wanted); wanted *= kStep) {
      options.elements = static_cast<std::uint32_t>(wanted);
      const std::uint32_t planned = make_plan(scene_, options).sizes.elements;
      if (planned <= last) {
        continue;
      }
      const SweepPoint point = solve_(options);
      if (point.interrupted) {
        need_.interrupted = true;
        return last;
      }
      last = planned;
      note(point);
      if (point.mean_error > max_error_) {
        first_good.reset();
        need_.too_few = point;
      } else if (first_good) {
        need_.enough = first_good;
        return last;
      } else {
        first_good = point;
      }
    }
    return last;
  }

 private:
  void note(const SweepPoint& point) {
    if (!need_.closest || point.mean_error < need_.closest->mean_error) {
      need_.closest = point;
    }
  }

  bool fits(double elements) const {
    Sizes sizes = fitting_.sizes;
    sizes.elements = static_cast<std::uint32_t>(elements);
    return ram_bytes(fitting_.profile, sizes) <= fitting_.profile.ram_bytes;
  }

  const PreparedScene& scene_;
  const BakePlan& fitting_;
  double max_error_;
  const Solve& solve_;
  ElementNeed& need_;
};

}  // namespace

ElementNeed find_elements(const PreparedScene& scene, double max_error, const BakeOptions& base,
                          const Solve& solve) {
  ElementNeed need;
  const auto faces = static_cast<std::uint32_t>(scene.faces.size());
  std::uint32_t start = faces;
  for (const Profile& profile : profiles()) {
    if (profile.name == "host") {
      break;
    }
    BakeOptions options = base;
    options.profile = profile.name;
    options.elements.reset();
    std::optional<BakePlan> fitting;
    try {
      fitting = make_plan(scene, options);
    } catch (const InputError&) {
      continue;  // not even one element a face fits
    }
    need.too_few.reset();
    const std::uint32_t last = ProfileSearch(scene, *fitting, max_error, solve, need).run(options, start);
    if (need.enough || need.interrupted) {
      break;
    }
    start = std::max(faces, last / 2);
  }
  return need;
}

}  // namespace fixrad::host
