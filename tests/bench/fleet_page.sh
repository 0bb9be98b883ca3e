#!/usr/bin/env bash
# The fleet sheet of 500 robots of 6 joints with 10 calibrations each: its size, the time to make it
# and the time until Chromium shows it. Needs a build with tests, chromium and python3.
#   ./tests/bench/fleet_page.sh [BUILD]
set -euo pipefail
build=$(realpath "${1:-build}")
work=$(mktemp -d -p "${TMPDIR:-/dev/shm}")
trap 'rm -rf "$work"' EXIT
"$build/tests/archive/fleet_archive" "$work/fleet.tribolog"
time "$build/src/tribolog" archive fleet --archive "$work/fleet.tribolog" -o "$work/fleet.html"
printf 'page: %s bytes\n' "$(stat -c %s "$work/fleet.html")"
chromium --headless --no-sandbox --disable-gpu --trace-startup=loading,blink,blink.user_timing \
  --trace-startup-format=json --trace-startup-file="$work/trace.json" --trace-startup-duration=0 \
  --screenshot="$work/page.png" --window-size=1400,1400 "file://$work/fleet.html" 2>/dev/null
python3 - "$work/trace.json" <<'P'
import json
import sys
events = json.load(open(sys.argv[1]))['traceEvents']
start = [e for e in events if e['name'] == 'navigationStart' and 'fleet.html' in json.dumps(e)][-1]
for name in ('firstContentfulPaint', 'loadEventEnd'):
    times = [e['ts'] - start['ts'] for e in events if e['name'] == name and e['pid'] == start['pid']]
    print(f'{name}: {min(t for t in times if t > 0) / 1e6:.2f} s')
P
