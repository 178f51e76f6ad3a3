# SPDX-License-Identifier: LGPL-3.0-or-later
#
# For the commands of bench, in the folder of the project: what they need on a fresh machine,
# and their builds.

# install_missing PACKAGE...: those that are not there.
install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2> /dev/null | grep -q '^install ok installed' ||
      missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    echo "Packages are missing, and only root can install them. Please run:" >&2
    echo "  apt-get install ${missing[*]}" >&2
    exit 1
  fi
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "${missing[@]}"
}

# install_packages PACKAGE...: these, beside what the build of all benchmarks takes.
install_packages() {
  install_missing cmake g++ ninja-build pkg-config libgmp-dev libmpfr-dev libboost-dev \
    libcgal-dev libbenchmark-dev libpolyclipping-dev libsfcgal-dev python3 "$@"
}

# build_in FOLDER CMAKE-ARGUMENT... -- TARGET...
build_in() {
  local folder=$1 arguments=()
  shift
  while [ "$1" != -- ]; do
    arguments+=("$1")
    shift
  done
  shift
  mkdir -p build
  { cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGCV_WERROR=ON \
      -DGCV_BUILD_TESTS=OFF "${arguments[@]}" && cmake --build "$folder" --target "$@"; } \
    > "$folder.log" 2>&1 || { cat "$folder.log" >&2; exit 1; }
}

build_benchmarks() { build_in build/bench -DGCV_BUILD_BENCH=ON -- all; }
