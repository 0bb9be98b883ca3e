#!/usr/bin/env bash
# Every test, from nothing: installs what is missing, builds, and runs them.
#   ./tests/run.sh               all tests
#   ./tests/run.sh -R pattern    passes its arguments to ctest
# TRIBOLOG_SANITIZE=1 runs the same tests once more under ASan and UBSan, in a build of its own.
set -euo pipefail
cd "$(dirname "$0")/.."
./setup.sh tests
ctest --test-dir "${TRIBOLOG_BUILD:-build}" --output-on-failure -j "$(($(nproc) + 1))" "$@"
if [ -n "${TRIBOLOG_SANITIZE:-}" ]; then
  TRIBOLOG_BUILD=build-sanitize \
    TRIBOLOG_CMAKE="-DTRIBOLOG_SANITIZE=address;undefined -DCMAKE_BUILD_TYPE=RelWithDebInfo" \
    ./setup.sh tests
  ctest --test-dir build-sanitize --output-on-failure -j "$(($(nproc) + 1))" "$@"
fi
