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
    libcgal-dev libbenchmark-dev libpolyclipping-dev libsfcgal-dev libgeos-dev python3 "$@"
}

# Clipper2 in build/clipper2, where there is none: Debian 12 has no package of it, but the sources
# of one of PyPI hold its own.
provide_clipper2() {
  local folder=$PWD/build/clipper2
  pkg-config --exists Clipper2 && return
  if [ ! -e "$folder/lib/pkgconfig/Clipper2.pc" ]; then
    mkdir -p "$folder"
    { python3 -m venv "$folder/venv" &&
        "$folder/venv/bin/pip" download -q --no-deps --no-binary pyclipr -d "$folder" \
          pyclipr==0.1.8 &&
        tar -xzf "$folder/pyclipr-0.1.8.tar.gz" -C "$folder" &&
        cmake -S "$folder/pyclipr-0.1.8/external/clipper2/CPP" -B "$folder/build" -G Ninja \
          -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-Wno-error=maybe-uninitialized -DCLIPPER2_UTILS=OFF -DCLIPPER2_EXAMPLES=OFF \
          -DCLIPPER2_TESTS=OFF -DBUILD_SHARED_LIBS=OFF -DCMAKE_INSTALL_LIBDIR=lib \
          -DCMAKE_INSTALL_PREFIX="$folder" &&
        cmake --build "$folder/build" --target install; } > "$folder.log" 2>&1 ||
      { cat "$folder.log" >&2; exit 1; }
  fi
  export PKG_CONFIG_PATH=$folder/lib/pkgconfig${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}
}

# parry, which is in Rust, in build/parry, where cargo is there and new enough. Sets parry_library.
provide_parry() {
  parry_library=
  mkdir -p build
  if cargo build --release --locked --manifest-path bench/contact/parry/Cargo.toml \
    --target-dir build/parry > build/parry.log 2>&1; then
    parry_library=$PWD/build/parry/release/libparry_questions.so
  else
    echo "parry is left out: build/parry.log says why" >&2
  fi
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
