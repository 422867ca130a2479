#!/bin/sh
# SPDX-License-Identifier: MIT
# Install the Debian packages that are missing:  scripts/install_packages.sh build|targets|test
#   build:   what it takes to configure and build the preset `host`
#   targets: compilers and emulators of the seven target presets
#   test:    all of that, and what ./test.sh checks with
# docs/dependencies.md says what each is for. As root, or with sudo; does nothing if all is there, fails if anything
# cannot be installed.
set -eu

# command:package where any provider of the command will do, else a package that must be installed.
build="g++:g++ cmake:cmake ninja:ninja-build libcli11-dev libtinygltf-dev nlohmann-json3-dev libpng-dev
libeigen3-dev libembree-dev libtbb-dev libglm-dev libgeos-dev libgtest-dev libgmock-dev libbenchmark-dev libtinyobjloader-dev
ca-certificates node:nodejs npm:npm python3:python3"
targets="cmake:cmake ninja:ninja-build python3:python3 cc:gcc libc6-dev
arm-none-eabi-g++:gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm:qemu-system-arm
riscv64-unknown-elf-g++:gcc-riscv64-unknown-elf
xtensa-lx106-elf-g++:gcc-xtensa-lx106 qemu-system-riscv32:qemu-system-misc qemu-system-xtensa:qemu-system-misc
avr-g++:gcc-avr avr-ar:binutils-avr avr-libc clang++:clang libsimavr-dev libelf-dev"
checks="ca-certificates clang-format:clang-format clang-tidy:clang-tidy libclang-rt-dev cppcheck:cppcheck git:git python3:python3 node:nodejs npm:npm chromium:chromium"

case "${1:-}" in
  build) wanted=$build ;;
  targets) wanted=$targets ;;
  test) wanted="$build $targets $checks" ;;
  *) echo "usage: $0 build|targets|test" >&2; exit 2 ;;
esac

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  echo "no dpkg here: packages are not checked; docs/dependencies.md lists what must be there" >&2
  exit 0
fi

find_missing() {
  missing=""
  for entry in $wanted; do
    case $entry in
      *:*) command -v "${entry%%:*}" >/dev/null || missing="$missing ${entry#*:}" ;;
      *) is_installed "$entry" || missing="$missing $entry" ;;
    esac
  done
}

find_missing
[ -n "$missing" ] || exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "missing packages, and neither root nor sudo to install them; as root: apt-get install$missing" >&2
    exit 1
  fi
  as_root="sudo"
fi

echo "installing:$missing"
$as_root apt-get update -q -o DPkg::Lock::Timeout=300
# $missing is a list of words.
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
  -o DPkg::Lock::Timeout=300 $missing

find_missing
if [ -n "$missing" ]; then
  echo "installed, and still not there:$missing" >&2
  exit 1
fi
