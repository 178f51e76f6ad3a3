#!/usr/bin/env bash
# Copyright (C) 2026 The libgcv authors
# SPDX-License-Identifier: LGPL-3.0-or-later
#
#   test.sh   checks the types of the page, and tests it in Chromium without a window
#
# Takes Node 20, npm, and Chromium, or another one named by the variable CHROMIUM.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

browser=${CHROMIUM:-chromium}
if ! command -v "$browser" >/dev/null; then
  echo "examples/web/test.sh: $browser is missing. On Debian 12:" >&2
  echo "  sudo apt-get install --no-install-recommends chromium fonts-dejavu-core" >&2
  echo "or name another one: CHROMIUM=/path/to/chrome examples/web/test.sh" >&2
  exit 1
fi
[ -d node_modules/playwright-core ] && [ -x node_modules/.bin/tsc ] || npm ci
node -e 'import("./serve.mjs").then(({ prepare }) => {
  const missing = prepare();
  if (missing) { console.error(missing); process.exit(1); }
})'
npx tsc -p .
node --test --test-concurrency=1 tests/*.test.mjs
