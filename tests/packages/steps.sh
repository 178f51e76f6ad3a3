# SPDX-License-Identifier: LGPL-3.0-or-later
#
# For the tests of packages: what they say, and how they run commands. Their folder is in `scratch`.

say() { echo "$(basename "$0" .sh): $*"; }
fail() {
  say "$@" >&2
  exit 1
}

# run LOG COMMAND ...: quietly, unless it fails.
run() {
  local log=$scratch/$1.log
  shift
  "$@" > "$log" 2>&1 || { tail -n 100 "$log"; fail "this fails, see $log: $*"; }
}
