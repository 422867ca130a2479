// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/stability/bench.h"

namespace fixrad::host {

// What properties() asks of a scene: empty, or what is wrong.

// How it is solved.
std::string keep_books(const RandomScene& scene);
std::string solve_in_slices(const RandomScene& scene);

// How solutions of related scenes are related.
std::string scale_light(const RandomScene& scene);
std::string shuffle_vertices(const RandomScene& scene);
std::string turn_axes(const RandomScene& scene);

// What its eyes see.
std::string shuffle_faces(const RandomScene& scene);
std::string reciprocate(const RandomScene& scene);

/// What to say of a scene that does not load, or that does not come to its end.
std::string refusal(const Bench& bench);
std::string unsolved(const Bench& bench);

/// A fixed shuffle of 0 .. n - 1.
std::vector<std::uint32_t> shuffled(std::size_t n, std::uint64_t seed);

}  // namespace fixrad::host
