// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/stability/hard_case.h"

namespace fixrad::host {

// Laws that light keeps whatever the form factors are, and numbers that closed forms are about.

/// Mean radiosity over the elements of input face `face`, weighted by area.
double face_radiosity(const Light& light, std::uint32_t face, int channel = 0);

/// What the elements of input face `face` receive, over all that the channel emits.
double face_received(const Light& light, std::uint32_t face, int channel = 0);

/// All light that leaves surfaces over what they emit, in flux: by what elements have received.
double exitance_gain(const Light& light, int channel = 0);

/// The same by the radiosities of elements.
double radiosity_gain(const Light& light, int channel = 0);

/// Appends: every one of the faces `first` .. `last` has the radiosity `expected`, to within the part `bound`
/// of it. Each face is a finding of its own only if it is the worst one.
void expect_radiosity(const Light& light, std::uint32_t first, std::uint32_t last, double expected,
                      double bound, std::vector<Finding>& findings, int channel = 0);

/// Appends: in a closed scene of one reflectance all that leaves surfaces is 1 / (1 - reflectance) times what
/// they emit, since all of it arrives; to within the part `bound`. Form factors do not matter. The same of
/// radiosities, which are rounded down to their unit.
void expect_conserved(const Light& light, double reflectance, double bound, std::vector<Finding>& findings,
                      int channel = 0);

/// Appends: nothing escapes and nothing hits a back, in any channel, to the unit.
void expect_no_leak(const Light& light, std::vector<Finding>& findings);

/// Appends: face `face` receives the part `expected` of all that is emitted, to within `bound` of 1.
void expect_received(const Light& light, std::uint32_t face, const char* what, double expected, double bound,
                     std::vector<Finding>& findings, int channel = 0);

}  // namespace fixrad::host
