#!/bin/bash
# Builds the fuzz targets with clang and runs them one after the other; what they find stands in
# OUT/<target>-crash-..., and is exit status 1.
# usage: tests/fuzz/run.sh [EXECUTIONS=100000] [OUT=build-fuzz] [TARGET...]
# What a target learns is kept in OUT/corpus, so that a second run goes on from there.
# MAT and HDF5 are read in the very process here, and in a child of its own in the program: a crash
# of matio or libhdf5 found here is to be given to `tribolog inspect`, which has to refuse the file.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
executions=${1:-100000}
out=${2:-$root/build-fuzz}
targets=("${@:3}")
[[ ${#targets[@]} -gt 0 ]] || targets=(csv manifest json npz mcap bag db3 mf4 tdms mat hdf5 parquet)

cmake -S "$root" --preset fuzz -B "$out" >"$out.log" 2>&1 ||
  { cat "$out.log" >&2; exit 1; }
status=0
for target in "${targets[@]}"; do
  cmake --build "$out" -j"$(nproc)" --target "fuzz_$target" >"$out.log" 2>&1 ||
    { cat "$out.log" >&2; exit 1; }
  mkdir -p "$out/corpus/$target"
  longest=4096
  resident=2048
  memory=(-malloc_limit_mb=1024)
  sanitizer=quarantine_size_mb=8
  if [[ $target == hdf5 ]]; then
    longest=8192  # the format's smallest file has 6 kB
    # libhdf5 itself keeps some hundred bytes of many a damaged file: of no weight to a process
    # that reads one file, but here it adds up to a gigabyte in some million executions.
    memory+=(-detect_leaks=0)
    sanitizer+=:detect_leaks=0
    resident=8192
  fi
  # matio makes room for what a damaged file claims, before it reads; more than this fails there.
  if [[ $target == mat ]]; then
    memory=(-malloc_limit_mb=0)
    sanitizer+=:allocator_may_return_null=1:max_allocation_size_mb=512
  fi
  # A target that refuses its own seeds never gets behind the door.
  seeds=$(ASAN_OPTIONS=$sanitizer "$out/tests/fuzz/fuzz_$target" "${memory[@]}" \
    "$root/tests/fuzz/corpus/$target"/* 2>&1 | grep '^outcomes:') || seeds="outcomes: none"
  if [[ $seeds != *' '[1-9]*' read,'* ]]; then
    echo "$target: no seed is read ($seeds)"
    status=1
    continue
  fi
  if ASAN_OPTIONS=$sanitizer "$out/tests/fuzz/fuzz_$target" -runs="$executions" \
    -max_len="$longest" -timeout=60 -rss_limit_mb="$resident" "${memory[@]}" -print_final_stats=1 \
    -artifact_prefix="$out/$target-" "$out/corpus/$target" "$root/tests/fuzz/corpus/$target" \
    >"$out/fuzz_$target.log" 2>&1; then
    sed -n "s/^stat::number_of_executed_units: */$target: nothing found, executions: /p;
            s/^outcomes:/  of these/p; s/^stat::average_exec_per_sec: */  per second: /p;
            s/^stat::peak_rss_mb: */  peak memory in MB: /p" "$out/fuzz_$target.log"
  else
    echo "$target: see $out/fuzz_$target.log"
    status=1
  fi
done
exit $status
