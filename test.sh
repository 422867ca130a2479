#!/bin/sh
# SPDX-License-Identifier: MIT
# Install what is missing, build, and run every test and check; under ten minutes on two cores.
#   ./test.sh         everything
#   ./test.sh quick   build and run the tests only
# Ends with a verdict; the exit code is not 0 at the first thing that fails. Does only what is left to do.
set -eu
cd "$(dirname "$0")"

case "${1:-all}" in
  all | quick) scope=${1:-all} ;;
  *) echo "usage: ./test.sh [quick]" >&2; exit 2 ;;
esac

jobs=$(nproc)
start=$(date +%s)
times=""
current="set-up"

report() {
  status=$?
  printf '\n%s' "$times"
  if [ "$status" -eq 0 ]; then
    echo "PASSED ($scope) in $(($(date +%s) - start)) s"
  else
    echo "FAILED: $current (exit code $status), after $(($(date +%s) - start)) s" >&2
  fi
}
trap report EXIT

# part NAME COMMAND...: run it under a heading and keep its time.
part() {
  current=$1
  shift
  printf '\n== %s\n' "$current"
  begin=$(date +%s)
  "$@"
  times="$times$(printf '%6d s  %s' $(($(date +%s) - begin)) "$current")
"
}

configure() {
  cmake --preset "$1" --log-level=WARNING -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
}

# build_folders PRESET FOLDER...: only these; Ninja knows a folder's targets as FOLDER/all.
build_folders() {
  preset=$1
  shift
  configure "$preset"
  cmake --build --preset "$preset" --parallel "$jobs" --target $(printf '%s/all ' "$@")
}

test_folder() {
  ctest --test-dir "build/$1/tests/$2" --output-on-failure --no-tests=error -j "$jobs"
}

part "packages" scripts/install_packages.sh test
part "configure (host)" configure host
part "build (host)" cmake --build --preset host --parallel "$jobs"
part "tests (host)" ctest --preset host -j "$jobs"
[ "$scope" = all ] || exit 0

part "clang-format" scripts/check_format.sh
part "sample scenes" python3 -B scripts/make_scenes.py --check
part "build the core (clang)" build_folders host-clang lib tests/lib
part "tests of the core (clang)" test_folder host-clang lib
part "what must not compile (clang)" test_folder host-clang nocompile
part "build the core and the reader (sanitizers)" build_folders host-sanitize lib tests/lib tests/io
part "tests of the core (sanitizers)" test_folder host-sanitize lib
part "tests of the reader (sanitizers)" test_folder host-sanitize io
part "clang-tidy" scripts/check_tidy.sh
