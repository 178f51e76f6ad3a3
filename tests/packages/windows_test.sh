#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The library for Windows: built by mingw-w64, tested by wine, packed, and used from the package by
# pkg-config, by CMake, and by a linker that knows Microsoft's format alone.
# Usage: windows_test.sh SCRATCH
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$1"
cd "$1"
scratch=$PWD
toolchain=$source/pkgconfig/windows/mingw-w64.cmake
program=$source/bindings/c/smoke.c
cc=(x86_64-w64-mingw32-gcc-posix -std=c99 -Wall -Wextra -Werror)
wine=/usr/lib/wine/wine64

. "$source/tests/packages/steps.sh"

missing=()
need() { command -v "$1" > /dev/null || missing+=("$2"); }
need x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
need "$wine" wine64
need llvm-dlltool-14 llvm-14
need lld-link-14 lld-14
[ ${#missing[@]} -eq 0 ] || fail "packages are missing: apt-get install ${missing[*]}"

# A Windows of its own, without windows on a screen, which starts once.
export WINEPREFIX=$scratch/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="
unset DISPLAY
trap '/usr/lib/wine/wineserver64 -k || true' EXIT

# start_wine: Windows made anew. Of a hundred such starts one did not find its kernel32.dll.
start_wine() {
  /usr/lib/wine/wineserver64 -k || true
  rm -rf "$WINEPREFIX"
  mkdir -p "$WINEPREFIX"
  /usr/lib/wine/wineserver64 -p
  "$wine" wineboot
}

if ! start_wine > wine.log 2>&1; then
  cat wine.log
  say "Windows does not start; once more"
  run wine start_wine
fi

say "build"
run build "$source/pkgconfig/windows/package.sh" build -DGCV_BUILD_TESTS=ON -DGCV_WERROR=ON
run build cmake --build build --target tests/capi/all digest

say "test"
export WINEPATH="Z:$scratch/build/capi"
ctest --test-dir build --output-on-failure --parallel "$(nproc)" --no-tests=error --timeout 600 \
  > ctest.log || { cat ctest.log; fail "tests fail"; }
tail -n 12 ctest.log
grep -rh '^skipped:' build/Testing/Temporary/LastTest.log | sort -u

say "the package, unpacked elsewhere"
rm -rf unpacked
mkdir unpacked
cmake -E chdir unpacked cmake -E tar xf "$(echo "$scratch"/build/gcv-*-windows-x86_64.zip)"
cd unpacked/gcv-*
package=$PWD
for file in LICENSE README.md include/gcv/gcv.h include/gcv/gcvx.h include/gcv/gcv.hpp \
  include/gcv/hpp/base.hpp lib/gcv.def; do
  [ -f "$file" ] || fail "there is no $file"
done
python3 "$source/tests/packages/dll_test.py" --objdump x86_64-w64-mingw32-objdump \
  --header include/gcv/gcv.h bin/gcv.dll || fail "gcv.dll is not as it should be"

cd "$scratch"
"$wine" build/tests/capi/capi_sum_test.exe || fail "a program does not start with the DLL"
WINEPATH="" "$wine" build/tests/capi/capi_sum_test.exe && fail "a program starts without the DLL"
export WINEPATH="Z:$package/bin"

say "a consumer by pkg-config"
export PKG_CONFIG_LIBDIR=$package/lib/pkgconfig
# Flags are separated by blanks.
"${cc[@]}" "$program" $(pkg-config --cflags --libs gcv) -o dynamic.exe
"$wine" dynamic.exe || fail "the dynamic program fails"
"${cc[@]}" -static "$program" $(pkg-config --static --cflags --libs gcv) -o static.exe
WINEPATH="" "$wine" static.exe || fail "the static program fails"

# by_cmake CMAKE-ARGUMENTS
by_cmake() {
  rm -rf finding
  run consumer cmake -S "$source/tests/packages/consumer" -B finding -G Ninja \
    --toolchain "$toolchain" -DGCV_BY=find_package -Dgcv_DIR="$package/lib/cmake/gcv" "$@"
  run consumer cmake --build finding
  "$wine" finding/shared.exe || fail "by CMake, the program with the DLL fails"
}

say "a consumer by CMake"
by_cmake
WINEPATH="" "$wine" finding/static.exe || fail "the program with the static library fails"

say "the import library of Microsoft's format"
by_cmake -DMSVC=ON
grep -q 'gcv\.lib' finding/build.ninja || fail "CMake does not take gcv.lib for MSVC"
cat > version.c << 'END'
#include <gcv/gcv.h>
int start(void) { return gcv_version_number() >= 200 ? 0 : 1; }
END
"${cc[@]}" -I "$package/include" -c version.c -o version.obj
lld-link-14 /entry:start /subsystem:console /nodefaultlib /out:version.exe version.obj \
  "$package/lib/gcv.lib"
"$wine" version.exe || fail "the program linked in Microsoft's way ends with $?"
say "all passed"
