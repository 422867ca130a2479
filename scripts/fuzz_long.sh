#!/bin/sh
# SPDX-License-Identifier: MIT
# The long run of the programs of tests/fuzz:  scripts/fuzz_long.sh [EXECUTIONS [TARGET...]]
# Builds the preset host-fuzz and runs each target (all, if none is named) until its logs add up to EXECUTIONS (default:
# 10 million), in turns of 250,000, one process at low priority; started again, it goes on where it was stopped. Ends at
# the first finding, else writes what libFuzzer said into docs/fuzzing.md. The logs, and the corpora that grow from turn
# to turn, are in build/host-fuzz/long; remove that folder after the code has changed, to count anew.
set -eu
cd "$(dirname "$0")/.."
wanted=${1:-10000000}
[ $# -eq 0 ] || shift
turn=250000
build=build/host-fuzz
long=$build/long

cmake --preset host-fuzz --log-level=WARNING
cmake --build --preset host-fuzz --target tests/fuzz/all
all=$(for source in tests/fuzz/*_fuzz.cpp; do basename "$source" .cpp; done)
targets=${*:-$all}

# executed TARGET: what its logs add up to.
executed() {
  cat "$long/$1"/*.log 2>/dev/null | awk '/^stat::number_of_executed_units:/ { sum += $2 } END { printf "%d\n", sum }'
}

# run_turn TARGET: the number of the turn is the seed.
run_turn() {
  folder=$long/$1
  mkdir -p "$folder/corpus"
  number=$(($(find "$folder" -name '*.log' | wc -l) + 1))
  log=$folder/$(printf '%04d' "$number").log
  dictionary=""
  [ ! -f "tests/fuzz/$1.dict" ] || dictionary="-dict=tests/fuzz/$1.dict"
  seeds=""
  [ ! -d "tests/fuzz/corpus/$1" ] || seeds="tests/fuzz/corpus/$1"
  # shellcheck disable=SC2086
  ASAN_OPTIONS=malloc_context_size=0 nice -n 15 "$build/tests/fuzz/$1" -runs=$turn -seed="$number" -max_len=256 \
    -entropic=0 -reload=0 -print_final_stats=1 -artifact_prefix="$folder/" $dictionary "$folder/corpus" $seeds > "$log.part" 2>&1 || {
    tail -n 40 "$log.part" >&2
    echo "$1: a finding; its input is in $folder, what it says in $log.part" >&2
    exit 1
  }
  mv "$log.part" "$log"
}

left=$targets
while [ -n "$left" ]; do
  next=""
  for target in $left; do
    run_turn "$target"
    [ "$(executed "$target")" -ge "$wanted" ] || next="$next $target"
  done
  left=$next
done
scripts/fuzz_page.sh
