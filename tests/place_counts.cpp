// SPDX-License-Identifier: MIT
// Part of every test program of a build with FIXRAD_CHECKED: at its end, no place that docs/numbers.md argues
// to be safe may have cut a number.
#include <gtest/gtest.h>

#include <iostream>

#include "lib/fixed/checked.h"

namespace fixrad {
namespace {

class NothingWasCut : public testing::Environment {
 public:
  void TearDown() override {
    for (int place = 0; place < static_cast<int>(Place::kCount); ++place) {
      if (place < static_cast<int>(Place::kMeant)) {
        EXPECT_EQ(place_counts[place], 0u) << "place " << place << " of lib/fixed/checked.h";
      } else if (place_counts[place] > 0) {
        std::cout << "place " << place << " has cut " << place_counts[place] << " numbers, as it may\n";
      }
    }
  }
};

testing::Environment* const environment = testing::AddGlobalTestEnvironment(new NothingWasCut);

}  // namespace
}  // namespace fixrad
