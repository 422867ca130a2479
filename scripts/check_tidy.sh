#!/bin/sh
# SPDX-License-Identifier: MIT
# clang-tidy over the core and the host files that do not include a large third-party header (those take ten
# seconds each and more). Needs build/host-clang/compile_commands.json. Says so and ends if nothing changed since it passed.
set -eu
cd "$(dirname "$0")/.."
build=build/host-clang
large='<(CLI/|Eigen/|embree|nlohmann/json.hpp|tiny_gltf|tbb/|gtest/|gmock/|benchmark/)'

state=$( (cat .clang-tidy; scripts/sources.sh | grep -E '^(lib|host_sim)/' | xargs cat; clang-tidy --version) | sha256sum)
if [ "$(cat "$build/tidy_passed" 2>/dev/null)" = "$state" ]; then
  echo "clang-tidy: nothing changed since it passed"
  exit 0
fi

# The generated delta tables are numbers only.
files=$(scripts/sources.sh | grep -E '^(lib|host_sim)/.*\.cpp$' | grep -v 'delta_table_[0-9]*\.cpp$' |
  xargs grep -LE "$large" | while read -r path; do
    if grep -q "/$path\"" "$build/compile_commands.json"; then echo "$path"; fi
  done)
echo "clang-tidy: $(echo "$files" | wc -l) files"
# Only what fails speaks: clang-tidy counts the warnings it hides in system headers on stderr.
# shellcheck disable=SC2016
echo "$files" | xargs -P "$(nproc)" -n 1 sh -c \
  'output=$(clang-tidy --quiet --extra-arg=-Wno-ignored-optimization-argument --extra-arg=-Wreserved-identifier -p "$0" "$1" 2>&1) || { printf "%s\n" "$output"; exit 1; }' "$build"
echo "$state" > "$build/tidy_passed"
