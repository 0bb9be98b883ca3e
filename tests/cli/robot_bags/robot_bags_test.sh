#!/usr/bin/env bash
# A robot of six joints as ROS 2 records it, a rosbag2 folder of two SQLite files and an MCAP of the
# format's own library: each becomes a report of the robot by two commands, with the numbers that the
# text log of the same rows gives.
#   robot_bags_test.sh TRIBOLOG PACKAGES DIRECTORY
set -euo pipefail
tribolog=$(realpath "$1")
packages=$2
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$3" && mkdir -p "$3" && cd "$3"

"$tribolog" --quiet simulate "$here/../../../examples/six_axes/scenario.toml" -o simulated
# At a change every fifth row; each night, by tests/nightly.sh cases, all.
every=5
[ -z "${TRIBOLOG_EVERY_CASE:-}" ] || every=1
awk "NR == 1 || NR % $every == 2 % $every" simulated/robot.csv >robot.csv
constants() { sed -n "s/^$1 = //p" simulated/robot.toml | paste -sd,; }
python3 "$here/write_rosbag2.py" robot.csv rosbag2
logs=(robot.csv rosbag2)
if "$here/../../support/npm_packages.sh" "$packages" "$here/../../ingest/bags/peer/package.json" \
  >no_packages 2>&1; then
  PEER_PACKAGES=$packages node "$here/write_mcap.mjs" robot.csv robot.mcap
  logs+=(robot.mcap)
else
  echo "without an MCAP: $(cat no_packages)"
fi

for log in "${logs[@]}"; do
  "$tribolog" --quiet init "$log" --all-joints --gear-ratio "$(constants gear_ratio)" \
    --torque-constant "$(constants torque_constant_Nm_A)" --effort-side motor -o "$log.toml"
  "$tribolog" --quiet report "$log.toml" -o "$log.report" --no-figures --truth-runs 0
done

python3 - "${logs[@]}" <<'END'
import json
import sys


def numbers(log, joint):
    name = str(joint) if log == "robot.csv" else f"J{joint}"  # its columns are q1_rad, i1_A
    with open(f"{log}.report/{name}.calibration.json", encoding="utf8") as file:
        quantities = json.load(file)["verdict"]["quantities"]
    return {q["key"]: (q["verdict"], q["estimate"]) for q in quantities}


wrong = compared = 0
for joint in range(1, 7):
    of_text = numbers(sys.argv[1], joint)
    for log in sys.argv[2:]:
        for key, (verdict, estimate) in numbers(log, joint).items():
            text_verdict, text = of_text[key]
            same = verdict == text_verdict and (estimate is None) == (text is None)
            for side in ("estimate", "low", "high") if estimate and text else ():
                compared += 1
                # Stamps that are rounded otherwise move a wide interval by more than a narrow one.
                near = max(1e-4 * abs(text[side]), 0.01 * (text["high"] - text["low"]))
                same = same and abs(estimate[side] - text[side]) <= near
            if not same:
                wrong += 1
                print(f"{log}, J{joint}, {key}: {verdict} {estimate}, not {text_verdict} {text}")
print(f"{compared} numbers compared, {wrong} quantities differ")
sys.exit(0 if compared >= 6 * 3 * 4 and wrong == 0 else 1)
END
