#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Compiles and runs the program in README.md, and compares what it prints with what README.md
# says: readme_test.sh README HEADERS LIBRARY SCRATCH
set -euo pipefail
readme=$1 headers=$2 library=$3 scratch=$4
mkdir -p "$scratch"
sed -n '/^```c$/,/^```$/p' "$readme" | sed '1d;$d' > "$scratch/readme.c"
"${CC:-cc}" -std=c99 -Wall -Wextra -Werror -I "$headers" "$scratch/readme.c" "$library" \
  -Wl,-rpath,"$(dirname "$library")" -o "$scratch/readme"
diff <("$scratch/readme") <(sed -n '/^MULTIPOLYGON/,/^```$/p' "$readme" | sed '$d')
