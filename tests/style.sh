#!/usr/bin/env bash
# Formatting and a short list of clang-tidy checks, as errors. Needs a configured build directory.
#   tests/style.sh BUILD [format|tidy]
# Skips, saying so, where the tools are not installed.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/.."
what=${2:-format}
mapfile -t sources < <(git ls-files '*.cpp' '*.h')
case $what in
  format)
    # Versions format differently; the one of Debian 12 decides.
    clang-format --version 2>/dev/null | grep -q 'version 14\.' ||
      { echo "SKIPPED: clang-format 14 is not installed"; exit 0; }
    clang-format --dry-run --Werror "${sources[@]}"
    ;;
  tidy)
    command -v clang-tidy >/dev/null || { echo "SKIPPED: clang-tidy is not installed"; exit 0; }
    mapfile -t units < <(git ls-files 'src/*.cpp' 'render/*.cpp')
    printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy -p "$build" --quiet
    ;;
esac
