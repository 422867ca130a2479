// SPDX-License-Identifier: MIT
// The host as a board, for programs with the small header.
#include <cstdio>

#include "firmware/boards/board.h"

namespace fixrad {
namespace board {

void write(const char* text) {
  std::fputs(text, stdout);
}

}  // namespace board
}  // namespace fixrad
