#!/bin/sh
# SPDX-License-Identifier: MIT
# Install what is missing, build, and run every test and check, on the host and on all seven targets.
#   ./test.sh          everything
#   ./test.sh host     the quick one: build and run the tests of the host; `quick` is the same
# Ends with a verdict; the exit code is not 0 at the first thing that fails. Does only what is left to do.
set -eu
cd "$(dirname "$0")"

case "${1:-all}" in
  all | host) scope=${1:-all} ;;
  quick) scope=host ;;
  *) echo "usage: ./test.sh [all|host]" >&2; exit 2 ;;
esac

targets="cortex-m0 cortex-m3 cortex-m4f cortex-m7 rv32imc atmega2560 esp8266"
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

# test_folder PRESET FOLDER [OPTION...]: options are ctest's.
test_folder() {
  folder=build/$1/tests/$2
  shift 2
  ctest --test-dir "$folder" --output-on-failure --no-tests=error -j "$jobs" "$@"
}

# Configure, build, test: any compiler or emulator that is missing fails here.
run_target() {
  CMAKE_BUILD_PARALLEL_LEVEL=$jobs CTEST_PARALLEL_LEVEL=$jobs cmake --workflow --preset "$1"
}

part "packages" scripts/install_packages.sh test
part "configure (host)" configure host
# The benchmarks are no part of a plain build, but they must go on compiling.
part "build (host)" cmake --build --preset host --parallel "$jobs" --target all fixrad_bench
part "tests (host)" ctest --preset host -j "$jobs"
[ "$scope" = all ] || exit 0

passed=0
for target in $targets; do
  part "target $target" run_target "$target"
  passed=$((passed + 1))
done

part "clang-format" scripts/check_format.sh
part "sample scenes" python3 -B scripts/make_scenes.py --check
part "configure (clang)" configure host-clang
part "what must not compile (clang)" test_folder host-clang nocompile
part "build the core and the reader (sanitizers)" build_folders host-sanitize lib tests/lib tests/io
# Left out: hundreds of thousands of bounces through code that the shorter tests run too.
part "tests of the core (sanitizers)" test_folder host-sanitize lib -E 'Permille999|Cube.RefinedMesh'
part "tests of the reader (sanitizers)" test_folder host-sanitize io
part "build the fuzzers" build_folders host-fuzz tests/fuzz
part "fuzzers, a fixed number of runs" test_folder host-fuzz fuzz
part "cppcheck" scripts/check_cppcheck.sh
part "clang-tidy" scripts/check_tidy.sh
echo "targets that ran all their tests: $passed of $(echo "$targets" | wc -w)"
