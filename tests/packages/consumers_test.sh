#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Uses libgcv as strangers do: from an installation that was moved, by pkg-config and by CMake,
# and as a part of their own project, which they install in turn to unusual places.
# Usage: consumers_test.sh SOURCE BUILD SCRATCH; CC, CMAKE and PKG_CONFIG name tools.
set -euo pipefail
source=$1
build=$2
scratch=$3
here=$source/tests/packages/consumer
program=$source/bindings/c/smoke.c
cmake=${CMAKE:-cmake}
pkg_config=${PKG_CONFIG:-pkg-config}
cc=("${CC:-cc}" -std=c99 -Wall -Wextra -Werror)

fail() {
  echo "consumers_test: $*" >&2
  exit 1
}

# by_pkg_config LIBDIR: dynamic, static, and not without it.
by_pkg_config() {
  local flags static_flags
  export PKG_CONFIG_PATH=$1/pkgconfig
  "$pkg_config" --validate gcv
  flags=$("$pkg_config" --cflags --libs gcv)
  static_flags=$("$pkg_config" --static --cflags --libs gcv)
  # Flags are separated by blanks, here and below.
  "${cc[@]}" "$program" $flags -o dynamic
  LD_LIBRARY_PATH=$1 ./dynamic || fail "the dynamic program fails"
  "${cc[@]}" -static "$program" $static_flags -o static
  ./static || fail "the static program fails"
  "${cc[@]}" "$program" -o bare 2> bare.log &&
    fail "the program compiles without the flags"
  return 0
}

# by_cmake WAY FOLDER CMAKE-ARGUMENTS
by_cmake() {
  local way=$1 folder=$2
  shift 2
  rm -f "$folder/shared" "$folder/static"
  "$cmake" -S "$here" -B "$folder" -DGCV_BY="$way" -DCMAKE_BUILD_TYPE=Debug "$@" > "$way.log"
  "$cmake" --build "$folder" --parallel "$(nproc)" >> "$way.log"
  "$folder/shared" || fail "$way: the program with the shared library fails"
  "$folder/static" || fail "$way: the program with the static library fails"
}

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

DESTDIR=$PWD/stage "$cmake" --install "$build" --prefix /usr/somewhere > install.log
mv stage/usr/somewhere moved
rmdir stage/usr || fail "files were installed outside the prefix"
grep -rI -e /usr/somewhere -e "$build" moved && fail "the installation names the place it was in"
[ -f moved/share/doc/gcv/LICENSE ] || fail "the licence is not installed"
libdir=$(find "$PWD/moved" -name libgcv.a -printf %h)
by_pkg_config "$libdir"
by_cmake find_package finding -DCMAKE_PREFIX_PATH="$PWD/moved"

# As a part of the project, built once for both ways: with a relative libdir of any depth ...
by_cmake add_subdirectory adding -DGCV_SOURCE="$source" -DCMAKE_INSTALL_LIBDIR=lib/deep/down
"$cmake" --install adding --prefix "$PWD/deep" > install.log
by_pkg_config "$PWD/deep/lib/deep/down"

# ... and with an absolute one, also below DESTDIR.
by_cmake FetchContent adding -DGCV_SOURCE="$source" -DCMAKE_INSTALL_LIBDIR="$PWD/libraries" \
  -DCMAKE_INSTALL_PREFIX="$PWD/fetched"
DESTDIR=$PWD/stage "$cmake" --install adding > install.log
[ -f "stage$PWD/libraries/libgcv.so" ] || fail "DESTDIR is not honoured"
[ ! -e libraries ] || fail "DESTDIR is left"
"$cmake" --install adding > install.log
by_pkg_config "$PWD/libraries"
by_cmake find_package finding -Dgcv_DIR="$PWD/libraries/cmake/gcv"
