#!/usr/bin/env bash
# Redraws the tutorial's picture: the friction curve identified from the logs of the paper's joint with the
# noise of a real drive.
#   examples/paper/friction_curve.sh [PICTURE.svg]
# Environment: TRIBOLOG (the program).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
picture=${1:-$here/friction_curve.svg}
tribolog=${TRIBOLOG:-tribolog}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$tribolog" simulate --quiet "$here/scenario_noise.toml" -o "$out"
"$tribolog" figures --quiet "$out/dataset.toml" --format svg -o "$out/figures"
cp "$out/figures/fig-21-selected-curve.svg" "$picture"
