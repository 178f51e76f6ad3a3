#!/bin/sh
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Installs a build to a fresh folder and uses it from there as a stranger would.
# Usage: smoke_test.sh BUILD_FOLDER WORK_FOLDER; CC, CXX, CMAKE and PKG_CONFIG name tools.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
build=$1
work=$2
prefix=$work/prefix
cc="${CC:-cc} -std=c99 -Wall -Wextra -Werror"
cxx="${CXX:-c++} -std=c++17 -Wall -Wextra -Werror"

fail() {
  echo "smoke_test: $*" >&2
  exit 1
}

# The N-th block of a language in the README: example LANGUAGE N.
example() {
  awk -v start="\`\`\`$1" -v left="$2" '
    $0 == "```" && on { exit }
    on { print }
    $0 == start && --left == 0 { on = 1 }' "$here/README.md"
}

rm -rf "$work"
mkdir -p "$work"
cd "$work"
"${CMAKE:-cmake}" --install "$build" --prefix "$prefix" >install.log

pc=$(find "$prefix" -name gcv.pc)
[ -n "$pc" ] || fail "no gcv.pc is installed"
PKG_CONFIG_PATH=$(dirname "$pc")
export PKG_CONFIG_PATH
pkg_config=${PKG_CONFIG:-pkg-config}
$pkg_config --validate gcv
libdir=$($pkg_config --variable=libdir gcv)

# Word splitting of the flags is wanted below.
flags=$($pkg_config --cflags --libs gcv)
static_flags=$($pkg_config --static --cflags --libs gcv)

$cc "$here/smoke.c" $flags -o dynamic
LD_LIBRARY_PATH=$libdir ./dynamic || fail "the dynamic program fails"

if $cc "$here/smoke.c" -o bare 2>bare.log; then
  fail "the program compiles without the flags"
fi

$cc -static "$here/smoke.c" $static_flags -o static
./static || fail "the static program fails"

# What the README shows; the test c.cmake goes on from here.
LD_LIBRARY_PATH=$libdir
export LD_LIBRARY_PATH
example c 1 >sum.c
example cmake 1 >CMakeLists.txt
$cc sum.c $flags -o sum
[ "$(./sum)" = "area 9" ] || fail "the first example of the README fails"
$cc sum.c -I"$prefix/include" -L"$libdir" -lgcv -o plain
$cc -static sum.c -I"$prefix/include" -L"$libdir" -lgcv -lstdc++ -lm -o plain_static
[ "$(./plain) $(./plain_static)" = "area 9 area 9" ] || fail "plain flags fail"

example c 2 >files.c
$cc files.c $flags -o files
echo "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))" >square.wkt
[ "$(./files square.wkt square.wkt)" = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))" ] ||
  fail "the example of the README with files fails"
if ./files square.wkt none.wkt 2>files.log; then fail "a file that there is not is read"; fi
grep -q "GCVX_ERR_SYSTEM: No such file" files.log || fail "the message is $(cat files.log)"

example cpp 1 >region.cpp
$cxx region.cpp $flags -o region
# Behind it, the first block without a language.
sed '1,/^```cpp$/d' "$here/README.md" | sed '1,/^```$/d' |
  awk '$0 == "```" && on { exit } on { print } $0 == "```" { on = 1 }' >region.expected
./region | diff - region.expected || fail "the example of the README in C++ fails"
