// SPDX-License-Identifier: MIT
#pragma once

// Tests of the core that run on the host and on every target: GoogleTest where it fits, else a header with
// the same macros. Tests keep to what both know: TEST, the comparisons of integers, bool and enumerations,
// EXPECT_NEAR of integers of 32 bits, nothing streamed into an assertion.

#ifdef FIXRAD_SMALL_TEST
#include "tests/device/small_test.h"
#else
#include <gtest/gtest.h>
#endif
