#!/usr/bin/env bash
# Ratios against peers doing the same work, each pair measured in one run, and what each command
# costs: times of single runs mean nothing on a shared machine. Installs what is missing and builds.
# What it prints stands in docs/performance.md.
#   ./tests/bench/run.sh [ROUNDS] [PROGRAM-BEFORE]
set -euo pipefail
cd "$(dirname "$0")/../.."
./setup.sh bench
build=${TRIBOLOG_BUILD:-build}
peers=$build/bench_peers
[ -x "$peers/bin/python" ] || /usr/bin/python3 -m venv --system-site-packages "$peers"
"$peers/bin/pip" install --quiet polars pyarrow || echo "polars and pyarrow cannot be had here"
# Of the distribution's NumPy where that is older.
"$peers/bin/python" -c 'import pyarrow' 2>/dev/null || "$peers/bin/pip" install --quiet 'pyarrow<18' || true
"$peers/bin/python" tests/bench/compare.py "$build" --rounds "${1:-5}"
status=0
"$peers/bin/python" tests/bench/ratios.py "$build/src/tribolog" --rounds "${1:-5}" --tolerance 0.1 || status=$?
"$peers/bin/python" tests/bench/commands.py "$build/src/tribolog" --rounds "${1:-5}" ${2:+--before "$2"}
exit "$status"
