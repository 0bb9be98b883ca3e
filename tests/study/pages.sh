#!/usr/bin/env bash
# To look at: the report on each disturbance of the misfit study, at the width of a desktop, of a
# phone, and as the first printed page. Not a test: what is asked of the first screen, eyes judge.
#   tests/study/pages.sh TRIBOLOG JOINT OUT [DISTURBANCE...]
set -euo pipefail
tribolog=$(realpath "$1")
joint=$2
out=$3
shift 3
mkdir -p "$out"
chosen=()
for disturbance in "$@"; do chosen+=(--disturbance "$disturbance"); done
"$tribolog" --quiet study --misfit --joint "$joint" "${chosen[@]}" --runs 2 --logs "$out/logs" \
  --json "$out/numbers.json"
picture() {  # NAME WIDTH HEIGHT
  chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size="$2,$3" \
    --screenshot="$out/$1.png" "file://$(realpath "$page")" >/dev/null 2>&1
}
for logs in "$out"/logs/*/; do
  name=$(basename "$logs")
  page=$out/$name.html
  "$tribolog" --quiet report "$logs/dataset.toml" -o "$page" --no-figures \
    --truth-runs 0 || [ $? -eq 1 ]
  picture "$name-desktop" 1400 1000
  picture "$name-phone" 390 844
  chromium --headless --no-sandbox --disable-gpu --no-pdf-header-footer \
    --print-to-pdf="$out/$name.pdf" "file://$(realpath "$page")" >/dev/null 2>&1
  pdftoppm -png -r 60 -f 1 -l 1 -singlefile "$out/$name.pdf" "$out/$name-print"
  rm "$out/$name.pdf"
done
