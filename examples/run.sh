#!/usr/bin/env bash
# The main job from nothing: installs what is missing, builds, simulates the paper's joint,
# identifies it, draws the figures, writes the report, and says where it is.
set -euo pipefail
cd "$(dirname "$0")/.."
./setup.sh program
tribolog=${TRIBOLOG_BUILD:-build}/src/tribolog
out=${1:-out/paper}
mkdir -p "$out"
"$tribolog" simulate examples/paper/scenario.toml -o "$out"
"$tribolog" report "$out/dataset.toml" -o "$out/report.html"
printf 'tribolog: open %s/report.html\n' "$(cd "$out" && pwd)"
