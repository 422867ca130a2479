// SPDX-License-Identifier: MIT
// CLI11's class by name alone: its header costs each file that includes it seconds to compile.
#pragma once

namespace CLI {
class App;
}
