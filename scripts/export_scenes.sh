#!/bin/sh
# SPDX-License-Identifier: MIT
# Write the scenes of the firmware, firmware/scenes/<scene>_<profile>.h.
#   scripts/export_scenes.sh [TOOL]           write the files that differ
#   scripts/export_scenes.sh --check [TOOL]   write nothing; exit 1 and name each file that differs from what would be
#                                             written, is missing, or is in the folder and not in the list
# TOOL is the fixrad to use, build/host/fixrad without.
set -eu
cd "$(dirname "$0")/.."

check=no
if [ "${1:-}" = --check ]; then
  check=yes
  shift
fi
tool=${1:-build/host/fixrad}
if [ $# -gt 1 ] || [ ! -x "$tool" ]; then
  echo "usage: scripts/export_scenes.sh [--check] [TOOL]; TOOL must exist: $tool" >&2
  exit 2
fi

# Scene (or name=scene), profile, options of fixrad export. cornell_quick is the least work with which 250 elements stay
# within 0.8 % of the truth. Mesh and precision of the larger profiles are limited so that a run in an
# emulator takes seconds; most of all in the white room, which reflects its light twenty times. Scenes of scenes/worst are
# what scripts/worst_scenes.py has found.
list='
cornell tiny --elements 120 --flux-per-row 0.00055
cornell small
cornell_quick=cornell small --elements 250 --flux-per-row 0.00045 --flux-per-eye 0.3
cornell_picture=cornell tiny --elements 120 --flux-per-row 0.00055 --size 64x48
cornell medium --elements 500
cornell large --elements 1000
cornell_grey tiny
cornell_grey small
cornell_grey medium --elements 500
cornell_grey large --elements 800
closed_box tiny
closed_box small
closed_box medium --elements 500
closed_box large --elements 800
white_room tiny --unshot 0.01
white_room small
white_room medium --elements 150 --unshot 0.01
white_room large --elements 250 --unshot 0.01
portico tiny
colonnade small
colonnade medium
colonnade large --elements 800
worst_row=worst/worst_row small --elements 160 --unshot 0.2 --flux-per-row 0.001 --flux-per-eye 0.2
worst_step=worst/worst_step small --elements 160 --unshot 0.2 --flux-per-row 0.0002 --flux-per-eye 0.004
'

folder=firmware/scenes
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT

printf '%s' "$list" | while read -r scene profile options; do
  [ -n "$scene" ] || continue
  # shellcheck disable=SC2086  # options are words
  "$tool" --quiet export "scenes/${scene#*=}.obj" --profile "$profile" $options -o "$fresh/${scene%%=*}_$profile.h"
done

stale=0
for file in "$fresh"/*.h; do
  name=${file##*/}
  if ! cmp -s "$file" "$folder/$name"; then
    stale=1
    if [ $check = yes ]; then
      echo "$folder/$name: differs from what scripts/export_scenes.sh writes; run it" >&2
    else
      mkdir -p "$folder"
      cp "$file" "$folder/$name.partial"
      mv "$folder/$name.partial" "$folder/$name"
      echo "wrote $folder/$name"
    fi
  fi
done
for file in "$folder"/*.h; do
  name=${file##*/}
  if [ -f "$file" ] && [ ! -f "$fresh/$name" ]; then
    stale=1
    if [ $check = yes ]; then
      echo "$folder/$name: not in the list of scripts/export_scenes.sh; delete it or list it" >&2
    else
      rm "$file"
      echo "removed $folder/$name"
    fi
  fi
done
[ $check = no ] || exit $stale
