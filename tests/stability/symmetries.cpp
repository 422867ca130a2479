// SPDX-License-Identifier: MIT
#include "tests/stability/symmetries.h"

#include <algorithm>

namespace fixrad::host {
namespace {

constexpr std::size_t kMirrors = 8;
// The even permutations first.
constexpr int kPermutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

template <class Vector>
Vector image(Vector p, std::size_t i, typename Vector::value_type extent) {
  Vector q;
  for (int k = 0; k < 3; ++k) {
    const auto coordinate = p[kPermutations[i / kMirrors][k]];
    q[k] = ((i % kMirrors) >> k & 1u) != 0 ? extent - coordinate : coordinate;
  }
  return q;
}

}  // namespace

bool is_rotation(std::size_t i) {
  const std::size_t m = i % kMirrors;
  const bool odd_mirrors = ((m & 1u) + (m >> 1 & 1u) + (m >> 2)) % 2 != 0;
  const bool odd_permutation = i / kMirrors >= 3;
  return odd_mirrors == odd_permutation;
}

glm::ivec3 image_of(glm::ivec3 p, std::size_t i, int extent) {
  return image(p, i, extent);
}

std::vector<Model> images_of(const Model& model) {
  std::vector<Model> images;
  for (std::size_t i = 0; i < 6 * kMirrors; ++i) {
    images.push_back(model);
    for (glm::dvec3& p : images.back().positions) {
      p = image(p, i, 0.0);
    }
    for (Face& face : images.back().faces) {
      if (!is_rotation(i)) {
        std::reverse(face.corners.begin() + 1, face.corners.end());
      }
    }
  }
  return images;
}

}  // namespace fixrad::host
