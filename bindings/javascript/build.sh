#!/usr/bin/env bash
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
#   build.sh [FOLDER [CMAKE-ARGUMENT...]]
#   builds the package: dist/, by way of FOLDER, build/ by default
#
# Takes Emscripten, CMake, the headers of Boost, 1.74 or later, and npm.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
build=${1:-build}
arguments=("${@:2}")

# build_module NAME CMAKE-ARGUMENTS
build_module() {
  local name=$1
  shift
  emcmake cmake -S . -B "$build/$name" -Wno-dev -DCMAKE_BUILD_TYPE=Release "${arguments[@]}" "$@"
  cmake --build "$build/$name" --target gcv_wasm --parallel "$(nproc)"
  cp "$build/$name/gcv.wasm" "dist/$name.wasm"
}

mkdir -p dist
cp ../../LICENSE .  # npm packs no links
[ -x node_modules/.bin/tsc ] || npm ci
npx tsc -p .
build_module gcv-simd
build_module gcv -DGCV_SIMD=OFF
