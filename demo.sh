#!/bin/sh
# SPDX-License-Identifier: MIT
# Install what is missing, build the tool, bake the Cornell box and print the error table. Leaves its files in out/.
set -eu
cd "$(dirname "$0")"

scripts/install_packages.sh build
cmake --preset host --log-level=WARNING
cmake --build --preset host --target fixrad_tool --parallel "$(nproc)"

mkdir -p out
echo
echo "== fixrad bake scenes/cornell.obj"
build/host/fixrad bake scenes/cornell.obj \
  -o out/cornell.png -o out/cornell.glb -o out/cornell.hpp -o out/cornell.json
echo
echo "== fixrad compare scenes/cornell.obj"
build/host/fixrad compare scenes/cornell.obj
cat <<'END'

Left in out/:
  cornell.png   a picture of the baked box
  cornell.glb   the mesh with vertex colours, for any glTF viewer
  cornell.hpp   the same lighting as a constexpr table for flash
  cornell.json  what was measured: memory, shots, the energy ledger
Next: build/host/fixrad --help, scenes/README.md for other scenes, ./test.sh for the tests.
END
