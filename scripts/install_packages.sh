#!/bin/sh
# SPDX-License-Identifier: MIT
# Install the Debian packages that are missing:  scripts/install_packages.sh build|test
#   build: what it takes to configure and build the preset `host`
#   test:  that, and what ./test.sh checks with
# docs/dependencies.md says what each is for. As root, or with sudo; does nothing if all is there.
set -eu

# command:package where any provider of the command will do, else a package that must be installed.
build="g++:g++ cmake:cmake ninja:ninja-build libcli11-dev libtinygltf-dev nlohmann-json3-dev libpng-dev
libeigen3-dev libembree-dev libtbb-dev libglm-dev libgeos-dev libgtest-dev libgmock-dev libbenchmark-dev libtinyobjloader-dev"
checks="ca-certificates clang++:clang clang-format:clang-format clang-tidy:clang-tidy git:git python3:python3 node:nodejs npm:npm"

case "${1:-}" in
  build) wanted=$build ;;
  test) wanted="$build $checks" ;;
  *) echo "usage: $0 build|test" >&2; exit 2 ;;
esac

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  echo "no dpkg here: packages are not checked; docs/dependencies.md lists what must be there" >&2
  exit 0
fi

missing=""
for entry in $wanted; do
  case $entry in
    *:*) command -v "${entry%%:*}" >/dev/null || missing="$missing ${entry#*:}" ;;
    *) is_installed "$entry" || missing="$missing $entry" ;;
  esac
done
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
