#!/bin/sh
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Packages both crates, and uses the packages as a stranger would who has no libgcv: the
# first example of the README, with the library built from the package.
# Usage: package_test.sh WORK_FOLDER; CARGO and CARGO_TARGET_DIR as for cargo.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
work=$1
cargo=${CARGO:-cargo}

packages=$CARGO_TARGET_DIR/package

rm -rf "$work" "$packages"
mkdir -p "$work/src"

# gcv takes this gcv-sys, whatever crates.io has. Both are built below.
cd "$here"
"$cargo" package -p gcv-sys --locked --allow-dirty --no-verify
"$cargo" package -p gcv --locked --allow-dirty --no-verify \
  --config 'patch.crates-io.gcv-sys.path="gcv-sys"'

cd "$work"
# As new files, so that cargo builds from them.
for crate in "$packages"/*.crate; do tar xzmf "$crate"; done
cp "$here/Cargo.lock" .
awk '$0 == "```" && on { exit } on { print } $0 == "```rust" { on = 1 }' "$here/README.md" \
  >src/main.rs
cat >Cargo.toml <<EOF
[package]
name = "stranger"
version = "0.0.0"
edition = "2021"

[dependencies]
gcv = { path = "$(echo gcv-[0-9]*)", features = ["vendored"] }

[patch.crates-io]
gcv-sys = { path = "$(echo gcv-sys-[0-9]*)" }

[workspace]
EOF
unset GCV_LIB_DIR LD_LIBRARY_PATH
"$cargo" run
