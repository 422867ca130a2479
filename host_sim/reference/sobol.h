// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fixrad::host {

/// A Sobol sequence in kSobolDimensions dimensions with Owen's nested scrambling: each seed gives a
/// randomised copy of it, whose points are uniform one by one and evenly spread together, best in stretches
/// of 2^k points. Means over copies of different seeds are independent and unbiased, so their scatter is the
/// standard error. The first 2^32 points differ. Same numbers on every machine. Sources: S. Joe, F. Kuo, SIAM
/// J. Sci. Comput. 30, 2008 (direction numbers); I. Antonov, V. Saleev, 1979 (the order by Gray code, which
/// changes one digit a point); B. Burley, JCGT 9(4), 2020 (scrambling by a hash).
constexpr std::size_t kSobolDimensions = 10;

class ScrambledSobol {
 public:
  explicit ScrambledSobol(std::uint64_t seed);

  /// The next point, each coordinate in [0, 1), 32 bits. Cost: about 50 ns.
  std::array<double, kSobolDimensions> next();

 private:
  std::array<std::uint32_t, kSobolDimensions> digits_{};
  std::array<std::uint32_t, kSobolDimensions> seeds_{};
  std::uint32_t index_ = 0;
};

}  // namespace fixrad::host
