#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The Debian packages, from a clean checkout: built with their tests; `twice` built again, without
# them, to the same bytes; clean for lintian; and, by root, installed, used as debian/tests says, and
# purged without a trace. Each check has to fail where it should.
# Usage: debian_test.sh SCRATCH [twice]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mkdir -p "$1"
scratch=$(cd "$1" && pwd)
packages=(libgcv0 libgcv-dev python3-gcv)

. tests/packages/steps.sh

# build FOLDER: the packages of what git tracks.
build() {
  local sources=$scratch/$1/gcv
  rm -rf "${scratch:?}/$1"
  mkdir -p "$sources"
  git ls-files -z | tar --create --null --files-from=- | tar --extract -C "$sources"
  run "$1" env -C "$sources" dpkg-buildpackage -us -uc -b
}

same_bytes() {
  local package
  for package in "$scratch/$1"/*.deb; do
    cmp "$package" "$scratch/$2/${package##*/}" || return 1
  done
}

clean() { lintian --pedantic --fail-on error,warning --allow-root "$@"; }

# All that carries the name of the library, wherever packages leave things.
traces() {
  find /etc /opt /usr /var -name '*gcv*'
  dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${packages[@]}" 2> /dev/null || true
  ldconfig -p | grep gcv || true
}

say "build, with the tests of the library"
build tested
if [ "${2:-}" = twice ]; then
  say "build again"
  DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-} nocheck" build untested
  same_bytes tested untested || fail "the two builds differ"
  echo >> "$(echo "$scratch"/untested/libgcv0_*.deb)"
  same_bytes tested untested > "$scratch/cmp.log" 2>&1 && fail "another byte is not noticed"
fi

say "lintian"
clean "$scratch"/tested/*.changes
broken=$scratch/broken
rm -rf "$broken"
mkdir "$broken"
dpkg-deb -R "$scratch"/tested/libgcv0_*.deb "$broken/content"
rm "$broken/content/usr/share/doc/libgcv0/copyright"
dpkg-deb -b "$broken/content" "$broken" > "$broken/log"
clean "$broken"/libgcv0_*.deb > "$broken/log" &&
  fail "a package without its copyright is not noticed"

if [ "$(id -u)" -ne 0 ]; then
  say "only root can install the packages; what they do installed is not tested"
  exit
fi

say "install, use, purge"
traces > "$scratch/before"
grep -w installed "$scratch/before" && fail "this machine has packages of the library"
for name in c cpp cmake python3; do
  mkdir -p "$broken/$name"
  AUTOPKGTEST_TMP=$broken/$name "debian/tests/$name" > "$scratch/$name.log" 2>&1 &&
    fail "debian/tests/$name passes without the packages"
done
debs=()
for name in "${packages[@]}"; do
  debs+=("$scratch/tested/${name}"_*.deb)
done
trap 'dpkg --purge "${packages[@]}" > "$scratch/purge.log" 2>&1' EXIT
run install dpkg -i "${debs[@]}"
run autopkgtest autopkgtest -B "$scratch/tested/gcv" -- null
libdir=$(pkg-config --variable=libdir gcv)
run hardening python3 tests/packages/hardening_test.py "$libdir/libgcv.so.0" "$libdir/libgcv.a"
[ -z "$(pkg-config --cflags gcv)" ] || fail "pkg-config names directories of the system"
traces > "$scratch/installed"
cmp -s "$scratch/before" "$scratch/installed" && fail "what is installed is not noticed"
run purge dpkg --purge "${packages[@]}"
trap - EXIT
traces > "$scratch/after"
diff "$scratch/before" "$scratch/after" || fail "something stays behind"
