#!/bin/sh
# SPDX-License-Identifier: MIT
# Fail if clang-format would change a source. To repair: scripts/sources.sh | xargs clang-format -i
set -eu
cd "$(dirname "$0")/.."
scripts/sources.sh | xargs clang-format --dry-run -Werror
