#!/usr/bin/env bash
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
#   digest.sh BUILD DIGESTS  the same bits as everywhere, of a build of the module
set -euo pipefail
cmake --build "$1" --target digest
seq 4 | xargs -P "$(nproc)" -I{} node "$1/digest.cjs" "$2" {} 4
