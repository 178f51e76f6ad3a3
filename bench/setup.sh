# SPDX-License-Identifier: LGPL-3.0-or-later
#
# For bench/run and bench/accuracy, in the folder of the project: what they need on a fresh
# machine, and the build of all benchmarks in build/bench.

# install_packages PACKAGE...: these, beside what the build takes, where they are missing.
install_packages() {
  local packages=(cmake g++ ninja-build pkg-config libgmp-dev libmpfr-dev libboost-dev
                  libcgal-dev libbenchmark-dev libpolyclipping-dev libsfcgal-dev python3 "$@")
  local missing=() package
  for package in "${packages[@]}"; do
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

build_benchmarks() {
  mkdir -p build
  { cmake -S . -B build/bench -G Ninja -DCMAKE_BUILD_TYPE=Release -DGCV_WERROR=ON \
      -DGCV_BUILD_TESTS=OFF -DGCV_BUILD_BENCH=ON && cmake --build build/bench; } \
    > build/bench.log 2>&1 || { cat build/bench.log >&2; exit 1; }
}
