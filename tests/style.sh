#!/usr/bin/env bash
# Formatting and a short list of clang-tidy checks, as errors. Needs a configured build directory.
#   tests/style.sh BUILD [format|includes|types|tidy [COUNT]]
# Skips, saying so, where the tools are not installed.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "$0")/.."
what=${2:-format}
mapfile -t sources < <(git ls-files '*.cpp' '*.h')
case $what in
  format)
    # Versions format differently; the one that Debian 12 and 13 both have decides.
    command -v clang-format-19 >/dev/null ||
      { echo "SKIPPED: clang-format-19 is not installed"; exit 0; }
    clang-format-19 --dry-run --Werror "${sources[@]}"
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
    # Through clang's front end with its own standard library: what only GCC and libstdc++ let pass
    # is found here. All units, or those of the last day's commits, COUNT at most.
    command -v clang-tidy-19 >/dev/null || { echo "SKIPPED: clang-tidy-19 is not installed"; exit 0; }
    mapfile -t units < <(git ls-files 'src/*.cpp' 'render/*.cpp')
    if [ -n "${3:-}" ]; then
      before=$(git rev-list -1 --before=$(($(git log -1 --format=%ct) - 86400)) HEAD)
      mapfile -t changed < <(git diff --name-only --diff-filter=d "${before:-HEAD}" -- \
        'src/*.cpp' 'render/*.cpp')
      units=("${changed[@]:0:$3}")
      echo "clang-tidy: ${#units[@]} of ${#changed[@]} changed files"
    fi
    commands=$(python3 tests/style/single_units.py "$build")
    [ ${#units[@]} -eq 0 ] || printf '%s\n' "${units[@]}" |
      xargs -P "$(nproc)" -n 1 clang-tidy-19 -p "$commands" --quiet --extra-arg=-stdlib=libc++
    ;;
esac
