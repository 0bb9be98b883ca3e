#!/usr/bin/env bash
# Installs what is missing from the distribution's packages, and builds. Called by examples/run.sh
# and tests/run.sh; not meant to be called by hand.
#   ./setup.sh program        what the program needs; builds it into build/
#   ./setup.sh package        the same, and packs it: build/tribolog_*.deb, build/libtribolog*.deb
#   ./setup.sh tests          that and what the tests need; builds them too
#   ./setup.sh lint           the same and what looks at the source: clang-tidy, a second compiler
#   ./setup.sh nightly        the same and what tests/nightly.sh needs
#   ./setup.sh bench          the tests' and what the benchmarks need
# Environment: TRIBOLOG_BUILD (build directory), TRIBOLOG_CMAKE (more options for CMake).
set -euo pipefail
cd "$(dirname "$0")"
goal=${1:-program}
build=${TRIBOLOG_BUILD:-build}

needed=(cmake ninja-build g++ pkg-config git
  libvtk9-dev libexpat1-dev libfreetype-dev libdeflate-dev fonts-dejavu-core
  libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libctemplate-dev libssl-dev libsundials-dev libboost-dev libboost-locale-dev gettext
  libbz2-dev liblz4-dev libprotobuf-dev libzstd-dev libsnappy-dev libbrotli-dev libsqlite3-dev libpq-dev
  libmatio-dev libhdf5-dev zlib1g-dev)
case $goal in
  package) needed+=(dpkg-dev file) ;;
  tests | lint | nightly | bench) needed+=(libgtest-dev librapidcheck-dev libpng-dev liburdfdom-dev
    python3-minimal python3-venv python3-jsonschema python3-markdown python3-numpy python3-scipy
    python3-matplotlib poppler-utils qpdf librsvg2-bin
    postgresql slurm-wlm munge) ;;&
  nightly) needed+=(valgrind) ;;
  bench) needed+=(libbenchmark-dev python3-pandas) ;;
esac

# Of each line the first that the distribution has: Ubuntu 22.04 has no toml++; newer Mesa has no
# OSMesa.
alternatives=("libtomlplusplus-dev | libtoml11-dev"
  "libosmesa6-dev | libegl-dev libegl1 libgl1-mesa-dri")

# What not every distribution has; a test that misses its own says so.
offered=()
case $goal in
  tests | lint | nightly | bench) offered+=(libmujoco-dev libsdformat-dev clang-format-19 texlive-latex-base) ;;&
  lint) offered+=(clang-19 clang-tidy-19 libc++-19-dev libc++abi-19-dev) ;;
esac

# A browser and its driver for the report's tests, where the distribution packages them as such (in
# Ubuntu, Chromium is a snap): without them these tests say so. Node may come from elsewhere, with npm.
if [[ $goal != program && $goal != package ]] && grep -q '^ID=debian$' /etc/os-release 2>/dev/null; then
  command -v chromium >/dev/null || needed+=(chromium)
  command -v npm >/dev/null || needed+=(nodejs npm)
fi

say() { printf 'tribolog: %s\n' "$*"; }

installed() { dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null | grep -q '^installed$'; }

offers() { [ -n "$(apt-cache policy "$1" 2>/dev/null | grep -E 'Candidate: [0-9]')" ]; }

all_installed() {
  local package
  for package in "$@"; do installed "$package" || return 1; done
}

# choice "A | B C": the packages of the first that is installed or can be; else of the last.
choice() {
  local packages chosen
  while IFS= read -r packages; do
    read -ra chosen <<<"$packages"
    if all_installed "${chosen[@]}" || offers "${chosen[0]}"; then break; fi
  done < <(tr '|' '\n' <<<"$1")
  echo "${chosen[@]}"
}

# The tests start servers of their own: nothing starts because it was installed, and nothing fails
# because it cannot start (a container without systemd). Until the end of the (sub)shell.
start_no_service() {
  local policy=/usr/sbin/policy-rc.d
  [ ! -e "$policy" ] || return 0
  printf '#!/bin/sh\nexit 101\n' | "${root[@]}" tee "$policy" >/dev/null
  "${root[@]}" chmod 755 "$policy"
  # shellcheck disable=SC2064
  trap "${root[*]} rm -f $policy" EXIT
}

install() {
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y \
    --no-install-recommends -o Dpkg::Use-Pty=0 "$@" >/dev/null
}

install_missing() {
  local missing=()
  for package in "${needed[@]}"; do installed "$package" || missing+=("$package"); done
  local packages
  for one in "${alternatives[@]}"; do
    read -ra packages < <(choice "$one")
    all_installed "${packages[@]}" || missing+=("$one")
  done
  local extra=()
  for package in "${offered[@]}"; do installed "$package" || extra+=("$package"); done
  [ ${#missing[@]} -eq 0 ] && [ ${#extra[@]} -eq 0 ] && return
  command -v apt-get >/dev/null || {
    [ ${#missing[@]} -eq 0 ] && return
    say "these packages are missing, and there is no apt-get to install them: ${missing[*]}" >&2
    exit 1
  }
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      [ ${#missing[@]} -eq 0 ] && return
      say "to install ${missing[*]} this needs root or sudo" >&2
      exit 1
    }
    root=(sudo)
  fi
  if [ ${#missing[@]} -gt 0 ]; then
    say "installing: ${missing[*]}"
    "${root[@]}" apt-get -qq update
  fi
  local wanted=()
  for one in "${missing[@]}"; do
    read -ra packages < <(choice "$one")
    wanted+=("${packages[@]}")
  done
  local offered_here=()
  for package in "${extra[@]}"; do offers "$package" && offered_here+=("$package"); done
  (
    [[ $goal == program || $goal == package ]] || start_no_service
    [ ${#wanted[@]} -eq 0 ] || install "${wanted[@]}"
    [ ${#offered_here[@]} -eq 0 ] || install "${offered_here[@]}" ||
      say "not installed: ${offered_here[*]}; the tests that need them will say so"
  )
}

install_missing
preset=program
case $goal in
  tests | lint | nightly) preset=tests ;;
  bench) preset=bench ;;
esac
# A build directory made for more keeps it: switching goals would rebuild for nothing.
has() { grep -q "^$1:.*=ON" "$build/CMakeCache.txt" 2>/dev/null; }
if has TRIBOLOG_BENCH; then preset=bench; elif has TRIBOLOG_TESTS && [ $preset = program ]; then preset=tests; fi
# shellcheck disable=SC2086
cmake --preset $preset -B "$build" ${TRIBOLOG_CMAKE:-} >"$build.log" 2>&1 ||
  { cat "$build.log" >&2; exit 1; }
rm -f "$build.log"
targets=(all)
[[ $goal == program || $goal == package ]] && targets=(tribolog tribolog_shared)
cmake --build "$build" --target "${targets[@]}"
if [ "$goal" = package ]; then (cd "$build" && cpack); fi
