#!/usr/bin/env bash
# What takes too long for every change: memory errors, undefined behaviour and values that were
# never set, looked for in the whole program. Exit status 1 on a finding, with the log that tells it.
#   ./tests/nightly.sh [PART...]    all parts, in this order, unless some are named:
#     program    ASan, UBSan and libstdc++'s assertions: every command, on every example and on
#                every real log                          (ten minutes, and half an hour of building)
#     valgrind   memcheck: identify on every real log                          (three minutes)
#     cases      the test suite with every seed and every case that a change sees in part (an hour)
#     tests      ASan and UBSan: the whole test suite                         (some hours)
#     lint       clang-tidy over all of the source, through clang and libc++  (half an hour)
#     house      the program and its tests without the annexes        (a quarter of an hour)
#     bench      ratios to the same work in Python: none a tenth lower than in tests/bench/ratios.json
# Real logs are those in ../shared/data, by the manifests of tests/data and by those that `init`
# proposes; where they are absent, it says so. Everything is kept in build-nightly/.
# Environment: TRIBOLOG_SANITIZED, a sanitized program that is there already; TRIBOLOG_PROGRAM, the
# same for valgrind, without sanitizers.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 1
root=$PWD
data=$root/../shared/data
out=$root/build-nightly
findings=0
commands=0
parts=("$@")
[ ${#parts[@]} -gt 0 ] || parts=(program valgrind cases tests lint house bench)

# A status of its own, which no command of the program has. Drivers keep what they made for as long
# as the process lives, and the template engine its modifiers.
finding=86
suppressions=$out/leaks_of_libraries
mkdir -p "$out"
printf 'leak:%s\n' libOSMesa libgallium swrast_dri libGLX_mesa libEGL_mesa libLLVM \
  libctemplate >"$suppressions"
export ASAN_OPTIONS=exitcode=$finding:detect_stack_use_after_return=1
export UBSAN_OPTIONS=exitcode=$finding:print_stacktrace=1
export LSAN_OPTIONS=exitcode=$finding:suppressions=$suppressions:print_suppressions=0

say() { printf 'nightly: %s\n' "$*"; }

# Each source by itself: so one that lacks an include is found.
sanitized_build() {
  [ -x build-sanitize/src/tribolog ] && [ "${1:-}" = program ] && return
  TRIBOLOG_BUILD=build-sanitize \
    TRIBOLOG_CMAKE="-DTRIBOLOG_SANITIZE=address;undefined -DCMAKE_BUILD_TYPE=RelWithDebInfo \
      -DCMAKE_UNITY_BUILD=OFF" \
    ./setup.sh nightly || exit 1
}

# run NAME COMMAND...: its status is one that the README promises for input (0, 1, 3; and $refusal,
# where that is set), and no tool has said anything.
refusal=0
run() {
  local name=$1 status=0
  local log=$out/$part/$name.log
  shift
  mkdir -p "$(dirname "$log")"
  "${wrapper[@]}" "$@" >"$log" 2>&1 </dev/null || status=$?
  commands=$((commands + 1))
  case $status in
    0 | 1 | 3 | "$refusal") grep -qE 'Sanitizer|runtime error|Assertion .* failed' "$log" || return 0 ;;
  esac
  findings=$((findings + 1))
  say "FOUND, status $status: $log"
  grep -m 3 -E 'ERROR|runtime error|Assertion|SUMMARY|error:' "$log"
}

# Everything that is done with a dataset.
use_dataset() {
  local name=$1 manifest=$2 to=$out/$part/$1
  mkdir -p "$to"
  run "$name/identify" "$program" identify "$manifest" -o "$to/calibration.json" \
    --truth-runs 2
  run "$name/report" "$program" report "$manifest" -o "$to/report.html" \
    --truth-runs 2 --archive "$archive" --archive-inputs
  run "$name/figures" "$program" figures "$manifest" -o "$to/figures" --format png,svg,pdf \
    --style paper --language pl
  [ -f "$to/report.html" ] || return 0
  run "$name/show" "$program" show "$to/report.html" --json
  run "$name/review" "$program" review "$to/report.html" --archive "$archive" --reviewer Night \
    --approve
}

use_archive() {
  local ids id format
  run archive/list "$program" archive list --archive "$archive"
  run archive/verify "$program" archive verify --archive "$archive"
  run archive/backup "$program" archive backup --archive "$archive" -o "$out/$part/copy.tribolog"
  run archive/trend "$program" archive trend --archive "$archive" -o "$out/$part/trend.html"
  run archive/fleet "$program" archive fleet --archive "$archive" -o "$out/$part/fleet.html" \
    --reports "$out/$part/reports"
  mapfile -t ids < <("$program" archive list --archive "$archive" --json 2>/dev/null |
    grep -oE '"id": *"[0-9a-f]+"' | grep -oE '[0-9a-f]{8,}')
  for id in "${ids[@]}"; do
    run "archive/$id/show" "$program" archive show "$id" --archive "$archive"
    run "archive/$id/report" "$program" archive report "$id" --archive "$archive" \
      -o "$out/$part/archived.html"
    [ "$id" = "${ids[0]}" ] ||
      run "archive/$id/diff" "$program" archive diff "${ids[0]}" "$id" --archive "$archive" \
        --different-joints -o "$out/$part/diff.html"
    for format in csv latex json dcc urdf mjcf modelica; do
      # A simulator is not given what was not identified.
      refusal=2 run "archive/$id/export_$format" "$program" archive export "$id" --archive "$archive" \
        --format $format --doubtful-too -o "$out/$part/export"
    done
  done
}

use_examples() {
  local scenario name
  for scenario in examples/paper/scenario*.toml; do
    name=$(basename "$scenario" .toml)
    run "$name/simulate" "$program" simulate "$scenario" -o "$out/$part/$name"
    use_dataset "$name" "$out/$part/$name/dataset.toml"
    run "$name/study" "$program" study "$scenario" --runs 2 -o "$out/$part/$name/study.html"
  done
  run plan/plan "$program" plan examples/plan/joint.toml --runs 2 -o "$out/$part/plan"
  run template/inspect "$program" inspect examples/templates/controller_log.csv
  run models/list "$program" models
  run models/compare "$program" models --compare -o "$out/$part/models.html"
  run paper/paper "$program" paper -o "$out/$part/paper.html"
}

# Writes a manifest for each folder of logs and for each log, as `init` proposes it, beside those of
# tests/data, and sets `manifests`.
propose_manifests() {
  local to=$out/$part/manifests manifest logs log name
  mkdir -p "$to"
  manifests=()
  if [ ! -d "$data" ]; then
    say "no real logs in ../shared/data: that part is left out"
    return
  fi
  for manifest in tests/data/*.toml; do
    grep -q tribolog-dataset "$manifest" && manifests+=("$manifest")
  done
  for folder in "$data"/*/ "$data"/*/*/; do
    mapfile -t logs < <(find "$folder" -maxdepth 1 -type f \
      ! -name '*.md' ! -name '*.xsd' ! -name '*.toml' | sort)
    [ ${#logs[@]} -gt 0 ] || continue
    name=$(realpath --relative-to="$data" "$folder" | tr / _)
    run "init/$name" "$program" init "${logs[@]}" -o "$to/$name.toml" --force
    run "inspect/$name" "$program" inspect "${logs[@]}" --json "$to/$name.json"
    [ ${#logs[@]} -le 8 ] || continue
    for log in "${logs[@]}"; do
      run "init/${name}_$(basename "$log")" "$program" init "$log" --force \
        -o "$to/${name}_$(basename "$log").toml"
    done
  done
  for manifest in "$to"/*.toml; do
    [ ! -f "$manifest" ] || manifests+=("$manifest")
  done
}

part_program() {
  program=${TRIBOLOG_SANITIZED:-}
  if [ -z "$program" ]; then
    sanitized_build program
    program=$root/build-sanitize/src/tribolog
  fi
  archive=$out/$part/archive.tribolog
  wrapper=(timeout 3000)
  use_examples
  propose_manifests
  for manifest in "${manifests[@]}"; do
    use_dataset "logs/$(basename "$manifest" .toml)" "$manifest"
  done
  use_archive
}

part_valgrind() {
  program=${TRIBOLOG_PROGRAM:-}
  if [ -z "$program" ]; then
    ./setup.sh nightly || exit 1
    program=$root/${TRIBOLOG_BUILD:-build}/src/tribolog
  fi
  wrapper=()
  propose_manifests
  wrapper=(valgrind -q --error-exitcode="$finding" --track-origins=yes)
  for manifest in "${manifests[@]}"; do
    run "logs/$(basename "$manifest" .toml)" "$program" identify "$manifest" \
      -o "$out/$part/calibration.json" --truth-runs 1
  done
}

part_cases() {
  ./setup.sh tests || exit 1
  commands=$((commands + 1))
  TRIBOLOG_EVERY_CASE=1 ctest --test-dir "${TRIBOLOG_BUILD:-build}" --output-on-failure \
    -j "$(nproc)" >"$out/cases.log" 2>&1 && return
  findings=$((findings + 1))
  say "FOUND: $out/cases.log"
  sed -n '/The following tests FAILED/,$p' "$out/cases.log"
}

part_tests() {
  sanitized_build
  commands=$((commands + 1))
  ctest --test-dir build-sanitize --output-on-failure -j "$(nproc)" >"$out/tests.log" 2>&1 && return
  findings=$((findings + 1))
  say "FOUND: $out/tests.log"
  sed -n '/The following tests FAILED/,$p' "$out/tests.log"
}

part_lint() {
  ./setup.sh lint || exit 1
  commands=$((commands + 1))
  tests/style.sh "${TRIBOLOG_BUILD:-build}" tidy >"$out/lint.log" 2>&1 && return
  findings=$((findings + 1))
  say "FOUND: $out/lint.log"
}

part_house() {
  commands=$((commands + 1))
  (cmake --preset house && cmake --build --preset house && ctest --preset house -j "$(nproc)") \
    >"$out/house.log" 2>&1 && return
  findings=$((findings + 1))
  say "FOUND: $out/house.log"
  tail -5 "$out/house.log"
}

part_bench() {
  ./setup.sh tests || exit 1
  commands=$((commands + 1))
  /usr/bin/python3 tests/bench/ratios.py "${TRIBOLOG_BUILD:-build}/src/tribolog" --rounds 7 \
    --tolerance 0.1 >"$out/bench.log" 2>&1 && return
  findings=$((findings + 1))
  say "FOUND: $out/bench.log"
  tail -5 "$out/bench.log"
}

for part in "${parts[@]}"; do
  case $part in
    program | valgrind | cases | tests | lint | house | bench)
      say "$part"
      rm -rf "${out:?}/$part"
      mkdir -p "$out/$part"
      "part_$part"
      ;;
    *)
      say "no part '$part': program, valgrind, cases, tests, lint, house or bench" >&2
      exit 2
      ;;
  esac
done
say "$commands commands, $findings findings"
[ "$findings" -eq 0 ]
