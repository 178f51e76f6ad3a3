#!/bin/sh
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Builds and runs the first program in Rust of a page.
# Usage: page_test.sh PAGE WORK_FOLDER; CARGO and CARGO_TARGET_DIR as for cargo, GCV_LIB_DIR
# names the folder of a library.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
page=$1 work=$2

rm -rf "$work"
mkdir -p "$work/src"
cp "$here/Cargo.lock" "$work"
awk '$0 == "```" && on { exit } on { print } $0 == "```rust" { on = 1 }' "$page" \
  >"$work/src/main.rs"
cat >"$work/Cargo.toml" <<EOF
[package]
name = "page"
version = "0.0.0"
edition = "2021"

[dependencies]
gcv = { path = "$here/gcv" }

[workspace]
EOF
"${CARGO:-cargo}" run --manifest-path "$work/Cargo.toml"
