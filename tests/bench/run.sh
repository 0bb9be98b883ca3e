#!/usr/bin/env bash
# Ratios against peers doing the same work, each pair measured in one run: times of single runs mean
# nothing on a shared machine. Installs what is missing and builds.
#   ./tests/bench/run.sh [ROUNDS]
set -euo pipefail
cd "$(dirname "$0")/../.."
./setup.sh bench
python3 tests/bench/compare.py "${TRIBOLOG_BUILD:-build}" --rounds "${1:-5}"
