#!/bin/sh
# SPDX-License-Identifier: MIT
# The project's C++ sources, one path a line: those that git knows and new ones; without git, those on disk.
set -eu
cd "$(dirname "$0")/.."
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  git ls-files --cached --others --exclude-standard -- '*.h' '*.cpp' | while read -r path; do
    [ ! -f "$path" ] || printf '%s\n' "$path"
  done
else
  find lib host_sim firmware tests \( -name '*.h' -o -name '*.cpp' \) -not -path '*/node_modules/*' | sort
fi
