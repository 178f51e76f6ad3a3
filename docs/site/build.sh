#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds the manual: build/site/index.html, for any browser, without a network. Runs on a fresh machine
# too: installs packages where they are missing, and builds the library to build/manual. GCV_LIBRARY
# names a library that is there, by an absolute path. Every warning is an error. Sphinx makes all but
# the references of the crates and of the package for JavaScript, which rustdoc and TypeDoc make.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
. bench/setup.sh  # what installs packages

install_packages() {
  local packages=(doxygen git python3-venv)
  [ -n "${GCV_LIBRARY-}" ] || packages+=(cmake g++ ninja-build pkg-config libboost-dev)
  command -v cargo > /dev/null || packages+=(cargo)
  command -v npm > /dev/null || packages+=(nodejs npm)
  install_missing "${packages[@]}"
}

build_library() {
  { cmake -S . -B build/manual -G Ninja -DCMAKE_BUILD_TYPE=Release -DGCV_BUILD_TESTS=OFF \
      -DGCV_BUILD_EXAMPLES=OFF && cmake --build build/manual --target gcv; } \
    > build/manual.log 2>&1 || { cat build/manual.log >&2; exit 1; }
  export GCV_LIBRARY=$PWD/build/manual/capi/libgcv.so
}

# The tools of Sphinx, in a folder of their own: installed again where their list has changed.
install_tools() {
  cmp -s docs/site/requirements.txt build/docs-venv/requirements.txt && return
  python3 -m venv build/docs-venv
  build/docs-venv/bin/pip install -q -r docs/site/requirements.txt
  cp docs/site/requirements.txt build/docs-venv
}

# Members of structs that share a comment, and macros, need none of their own.
read_header() {
  rm -rf build/doxygen
  mkdir -p build/doxygen
  doxygen docs/site/Doxyfile
  ! grep -v 'Member .* (\(variable\|macro definition\)) ' build/doxygen/warnings >&2
}

build_site() {
  export PYTHONPATH=$PWD/bindings/python PYTHONDONTWRITEBYTECODE=1
  rm -rf build/site
  build/docs-venv/bin/sphinx-build --quiet --fresh-env --fail-on-warning --keep-going \
    --doctree-dir build/site-cache --conf-dir docs/site docs build/site \
    > build/site.log 2>&1 || { cat build/site.log >&2; exit 1; }
}

add_rust() {
  { cd bindings/rust && GCV_LIB_DIR=$(dirname "$GCV_LIBRARY") RUSTDOCFLAGS="-D warnings" \
      CARGO_TARGET_DIR=../../build/rustdoc \
      cargo doc --quiet --locked --no-deps --features geo-types,num-rational; } >&2
  cp -r ../../build/rustdoc/doc ../../build/site/reference/rust
}

# In a copy: TypeDoc reads the sources, and the module need not be built.
add_javascript() {
  rm -rf build/typedoc/src
  mkdir -p build/typedoc
  cp -r bindings/javascript/{src,tsconfig.json,README.md} docs/site/{package.json,package-lock.json} \
    docs/site/typedoc.json build/typedoc
  cd build/typedoc
  npm ci --silent --no-audit --no-fund >&2
  NO_COLOR=1 npx typedoc --out ../site/reference/javascript >&2
}

mkdir -p build
install_packages >&2
[ -n "${GCV_LIBRARY-}" ] || build_library
install_tools
read_header
build_site
(add_rust)
(add_javascript)
build/docs-venv/bin/python docs/site/check.py build/site >&2
echo "$PWD/build/site/index.html"
