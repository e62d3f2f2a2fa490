# SPDX-License-Identifier: Apache-2.0
# What both commands need: packages and a build. Sourced from the repository's root.

# Debian packages, by the command or file that shows that each is there.
feline_packages() {
  local pair
  for pair in "$@"; do
    local probe=${pair%%=*}
    if [[ $probe == /* ]]; then
      compgen -G "$probe" >/dev/null || echo "${pair#*=}"
    else
      command -v "$probe" >/dev/null || echo "${pair#*=}"
    fi
  done
}

# Installs the build's packages and those given as PROBE=PACKAGE, if any is missing.
feline_install() {
  local missing
  mapfile -t missing < <(feline_packages g++=g++ cmake=cmake ninja=ninja-build ccache=ccache verilator=verilator \
    /usr/include/CLI/CLI.hpp=libcli11-dev /usr/include/fmt/format.h=libfmt-dev \
    /usr/include/nlohmann/json.hpp=nlohmann-json3-dev /usr/include/gtest/gtest.h=libgtest-dev \
    /usr/include/OpenImageIO/imageio.h=libopenimageio-dev /usr/bin/oiiotool=openimageio-tools \
    "/usr/lib/*/libz.so=zlib1g-dev" gnuplot=gnuplot-nox \
    "/usr/include/*/gmp.h=libgmp-dev" /usr/include/mpfr.h=libmpfr-dev /usr/include/jxl/butteraugli.h=libjxl-dev \
    /usr/include/xxhash.h=libxxhash-dev "$@")
  ((${#missing[@]} == 0)) && return
  echo "installing: ${missing[*]}"
  local sudo=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || { echo "error: needs root or sudo to install ${missing[*]}" >&2; exit 2; }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -qq
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# feline_build DIRECTORY BUILD_TYPE TARGET [cmake options...]: configures when needed and builds.
feline_build() {
  local directory=$1 type=$2 target=$3
  shift 3
  local launcher=()
  if command -v ccache >/dev/null; then
    export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
    launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  local log
  log=$(mktemp)
  if ! cmake -S . -B "$directory" -G Ninja -DCMAKE_BUILD_TYPE="$type" "${launcher[@]}" "$@" >"$log" 2>&1 ||
    ! cmake --build "$directory" --target "$target" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    echo "error: the build of $directory failed" >&2
    exit 1
  fi
  rm -f "$log"
}
