#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds the library for Windows in the folder BUILD, and packs what programs are built with there:
# BUILD/gcv-<version>-windows-x86_64.zip. Takes Debian's packages g++-mingw-w64-x86-64-posix,
# libboost-dev, llvm-14, cmake, ninja-build and pkg-config.
# Usage: package.sh BUILD [CMAKE-ARGUMENT ...]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../.." && pwd)
build=$1
shift

cmake -S "$source" -B "$build" -G Ninja --toolchain "$here/mingw-w64.cmake" \
  -DCMAKE_BUILD_TYPE=Release -DGCV_BUILD_TESTS=OFF -DGCV_BUILD_EXAMPLES=OFF \
  -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_DOCDIR=. "$@"
cmake --build "$build" --target gcv gcv_static

cd "$build"
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' CMakeCache.txt)
name=gcv-$version-windows-x86_64
rm -rf "$name" "$name.zip"
cmake --install . --prefix "$name" --strip
cp "$source/README.md" "$name"
cp /usr/share/doc/mingw-w64-x86-64-dev/copyright "$name/LICENSE.mingw-w64"

# The import library of Microsoft's format. Functions are found by name, not by number.
sed -i 's/ @[0-9]*$//; 1i LIBRARY gcv.dll' "$name/lib/gcv.def"
llvm-dlltool-14 -m i386:x86-64 -d "$name/lib/gcv.def" -l "$name/lib/gcv.lib"

cmake -E tar cf "$name.zip" --format=zip "$name"
echo "$PWD/$name.zip"
