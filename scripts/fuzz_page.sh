#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes the table of docs/fuzzing.md from the logs that scripts/fuzz_long.sh has left.
set -eu
cd "$(dirname "$0")/.."
page=docs/fuzzing.md
long=build/host-fuzz/long

row() {
  cat "$long/$1"/*.log | awk -v target="$1" '
    /^#[0-9]+[ \t]+DONE/ { for (i = 1; i < NF; ++i) { if ($i == "cov:" && $(i + 1) > edges) edges = $(i + 1)
                                                      if ($i == "corp:") { split($(i + 1), of, "/"); inputs = of[1] } } }
    /^Done [0-9]+ runs in/ { seconds += $5 }
    /^stat::number_of_executed_units:/ { sum += $2 }
    END { printf "| `%s` | %d | %d | %d | %d | 0 |\n", target, sum, edges, inputs, seconds }'
}

table=$(mktemp)
trap 'rm -f "$table"' EXIT
{
  echo "| target | executions | edges | inputs kept | seconds | findings left |"
  echo "| --- | ---: | ---: | ---: | ---: | ---: |"
  for folder in "$long"/*/; do row "$(basename "$folder")"; done
  echo
  echo "By $(clang++ --version | head -n 1), its libFuzzer, AddressSanitizer and UndefinedBehaviorSanitizer."
} > "$table"

awk -v table="$table" '
  /<!-- fuzzing:begin -->/ { print; print ""; while ((getline line < table) > 0) print line; print ""; skipping = 1 }
  /<!-- fuzzing:end -->/ { skipping = 0 }
  !skipping { print }' "$page" > "$table.page"
mv "$table.page" "$page"
