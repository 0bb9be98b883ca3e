#!/usr/bin/env bash
# Everything from scratch: installs what is missing, builds, simulates the paper's joint with the
# noise of a real drive, identifies it, draws the figures, writes the report and a small study, and
# prints where they are.
set -euo pipefail
cd "$(dirname "$0")/.."
./setup.sh program
tribolog=${TRIBOLOG_BUILD:-build}/src/tribolog
out=${1:-out/paper}
mkdir -p "$out"
"$tribolog" simulate examples/paper/scenario_noise.toml -o "$out"
"$tribolog" report "$out/dataset.toml" -o "$out/report.html"
"$tribolog" study --runs 10 --factor torque_noise -o "$out/study.html"
printf 'tribolog: open %s/report.html and study.html beside it\n' "$(cd "$out" && pwd)"
