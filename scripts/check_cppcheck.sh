#!/bin/sh
# SPDX-License-Identifier: MIT
# cppcheck over the core and the host folders that read, mesh and simulate. What has not changed since the last run is
# not looked at again. Left out everywhere: members without a first value (a solver's memory, and arrays that are written
# before they are read), and that assigning in a constructor is slow, which it is not for integers. What else is wrong
# of it is suppressed beside the line, with the reason.
set -eu
cd "$(dirname "$0")/.."
build=build/cppcheck
mkdir -p "$build"
# The generated delta tables are numbers only.
scripts/sources.sh | grep -E '^(lib|host_sim/(io|meshing|simulate|bake|tables))/.*\.cpp$' | grep -v 'delta_table_[0-9]*\.cpp$' |
  xargs cppcheck --quiet -j "$(nproc)" --std=c++17 --language=c++ --enable=warning,performance,portability --inline-suppr \
    --suppress=missingIncludeSystem --suppress=uninitMemberVar --suppress=useInitializationList --error-exitcode=1 --template=gcc --max-configs=2 -I. --cppcheck-build-dir="$build"
