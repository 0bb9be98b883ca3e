#!/usr/bin/env bash
# Formatting and a short list of clang-tidy checks, as errors. Needs a configured build directory.
#   tests/style.sh BUILD [format|includes|types|tidy]
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
  includes)
    python3 tests/style/standard_includes.py "${sources[@]}"
    ;;
  types)
    # Two types of one name in one namespace are mixed up by the linker without a word.
    twice=$(git ls-files 'src/*.h' 'render/*.h' | xargs awk '
      FNR == 1 { room = "" }
      /^namespace [a-z:_]+ \{/ { room = $2 }
      /^(struct|class|enum class) [A-Za-z]+( final)?( :.*)? \{/ {
        name = room "::" ($1 == "enum" ? $3 : $2); sub(/:$/, "", name); print name, FILENAME
      }' | sort | awk '{ if ($1 == last) print $1 ": " file ", " $2; last = $1; file = $2 }')
    [ -z "$twice" ] || { printf 'two types of one name:\n%s\n' "$twice"; exit 1; }
    ;;
  tidy)
    command -v clang-tidy >/dev/null || { echo "SKIPPED: clang-tidy is not installed"; exit 0; }
    mapfile -t units < <(git ls-files 'src/*.cpp' 'render/*.cpp')
    printf '%s\n' "${units[@]}" | xargs -P "$(nproc)" -n 4 clang-tidy -p "$build" --quiet
    ;;
esac
