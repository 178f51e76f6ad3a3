#!/usr/bin/env bash
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
#   digest.sh BUILD DIGESTS PART...  the same bits as everywhere, of a build of the module, in these
#                                    eighths of the cases, 1 to 8
set -euo pipefail
build=$1 digests=$2
shift 2
cmake --build "$build" --target digest
printf '%s\n' "$@" | xargs -P "$(nproc)" -I{} node "$build/digest.cjs" "$digests" {} 8
