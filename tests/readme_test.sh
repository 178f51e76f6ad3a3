#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Compiles and runs the first program in a page, and compares what it prints with the block behind
# it: readme_test.sh PAGE LIBRARY SCRATCH FOLDER_OF_HEADERS...
set -euo pipefail
page=$1 library=$2 scratch=$3
shift 3
mkdir -p "$scratch"

# The first block of the page that begins with this line.
block() {
  awk -v start="$1" '
    $0 == "```" && on { exit }
    on { print }
    $0 == start && !on { on = 1 }' "$2"
}

block '```c' "$page" > "$scratch/program.c"
sed '1,/^```c$/d' "$page" | sed '1,/^```$/d' > "$scratch/rest"
block '```' "$scratch/rest" > "$scratch/expected"
"${CC:-cc}" -std=c99 -Wall -Wextra -Werror "${@/#/-I}" "$scratch/program.c" "$library" \
  -Wl,-rpath,"$(dirname "$library")" -o "$scratch/program"
"$scratch/program" | diff - "$scratch/expected"
[ -s "$scratch/expected" ]
