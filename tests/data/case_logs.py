#!/usr/bin/env python3
"""Writes docs/cases.md: logs in the dialects and with the faults that people have, from one command to numbers.

  python3 tests/data/case_logs.py build/src/tribolog FOLDER > docs/cases.md

FOLDER has a folder for each case with its logs; those that are not there are left out. Each log is given to
`tribolog report` twice: alone, and with what its user knows. Right: within 5 % of the truth (angles 0.02 rad), or the
interval, widened by 5 %, holds it.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ARM = {"gravity_torque": 38.0, "coulomb_torque": 6.0, "break_away_torque": 7.0, "viscous_coefficient": 8.0,
       "bristle_stiffness": 2e4, "inertia": 1.2, "cog_angle": 0.0}
FRICTION = {key: ARM[key] for key in ("coulomb_torque", "break_away_torque", "viscous_coefficient", "bristle_stiffness",
                                      "inertia")}
SERVO = {"gravity_torque": 0.9, "coulomb_torque": 0.12, "break_away_torque": 0.15, "viscous_coefficient": 0.04,
         "bristle_stiffness": 60.0, "inertia": 0.006, "cog_angle": math.pi / 2}
COUNTED = dict(SERVO, cog_angle=3 * math.pi / 2)  # zero of the counts half a turn away
WHEEL = {"coulomb_torque": 2.0, "viscous_coefficient": 0.8, "inertia": 0.05}
POINTS = {"coulomb_torque": 0.572, "viscous_coefficient": 0.522}
TORQUE = ["--effort-kind", "joint_torque"]
NEWTON = TORQUE + ["--effort-unit", "Nm"]
GEAR = ["--gear-ratio", "101"]
DYNAMIXEL = ["--angle-unit", "0.087890625 deg", "--speed-unit", "0.229 rpm", "--effort-unit", "2.69 mA",
             "--torque-constant", "1.7", "--effort-side", "joint"]
HELD = ["--column", "effort=jts2", "--column", "angle=q2", "--angle-unit", "deg"]

# Log, its truth at the joint, what its user knows.
cases = [
    ("base/log.csv", ARM, TORQUE + GEAR),
    ("ur_effort_amps/joint_states.csv", ARM, ["--torque-constant", "0.11188", "--effort-side", "motor"] + GEAR),
    ("ur_gravity_taken_off/log.csv", FRICTION, TORQUE + GEAR),
    ("ur_joint_order/log.csv", ARM, ["--torque-constant", "0.11188", "--effort-side", "motor"] + GEAR),
    ("effort_denormal/log.csv", {}, TORQUE),
    ("torque_constant_twice/log.csv", ARM, TORQUE + GEAR + ["--known-gravity", "38@0"]),
    ("dynamixel_unsigned/log.csv", COUNTED, DYNAMIXEL),
    ("dynamixel_unsigned/signed.csv", COUNTED, DYNAMIXEL),
    ("wrap_pi/pm_pi.csv", FRICTION, TORQUE + GEAR + ["--no-gravity"]),
    ("wrap_pi/deg360.csv", FRICTION, TORQUE + GEAR + ["--no-gravity"]),
    ("two_publishers/log.csv", ARM, TORQUE + GEAR),
    ("out_of_order/interleaved.csv", ARM, TORQUE + GEAR),
    ("out_of_order/ntp_step.csv", ARM, TORQUE + GEAR),
    ("ethercat_units/log.csv", ARM, GEAR + ["--effort-kind", "motor_torque", "--effort-unit", "‰ of 1.27 Nm",
                                            "--angle-unit", "0.00274658203125 deg", "--angle-side", "motor"]),
    ("twincat_scope/point.csv", ARM, NEWTON + GEAR + ["--angle-unit", "deg"]),
    ("twincat_scope/comma.csv", ARM, NEWTON + GEAR + ["--angle-unit", "deg"]),
    ("friction_points/points.csv", POINTS, []),
    ("filtered_late/log.csv", ARM, TORQUE + GEAR),
    ("torque_clipped/log.csv", ARM, TORQUE + GEAR),
    ("current_spikes/log.csv", SERVO, ["--torque-constant", "1.7", "--effort-side", "joint"]),
    ("held_samples/log.csv", ARM, NEWTON + GEAR + HELD),
    ("sign_flipped/log.csv", ARM, TORQUE + GEAR),
    ("sign_flipped/speed_flipped.csv", ARM, TORQUE + GEAR),
    ("pandas_index/log.csv", ARM, NEWTON + GEAR + ["--angle-unit", "rad"]),
    ("odrive_wheel/log.csv", WHEEL, ["--gear-ratio", "8", "--torque-constant", "0.083", "--effort-side", "motor", "--no-gravity",
                                     "--angle-unit", "turn"]),
    ("wheel_plain/rad.csv", WHEEL, NEWTON + ["--no-gravity", "--angle-unit", "rad"]),
    ("wheel_plain/turns.csv", WHEEL, NEWTON + ["--no-gravity", "--angle-unit", "turn"]),
    ("wheel_plain/counts.csv", WHEEL, NEWTON + ["--no-gravity", "--angle-unit", "0.087890625 deg", "--time-unit", "s"]),
    ("warm_up/log.csv", {"gravity_torque": 38.0, "cog_angle": 0.0, "inertia": 1.2}, TORQUE + GEAR),
    ("torque_and_constant/joint_torque.csv", ARM, GEAR + ["--torque-constant", "0.1"]),
    ("torque_and_constant/tau.csv", ARM, GEAR + ["--torque-constant", "0.1"]),
    ("torque_and_constant/torque.csv", ARM, GEAR + ["--torque-constant", "0.1"]),
]
POWERS = {"gravity_torque": 1, "break_away_torque": 1, "coulomb_torque": 1, "inertia": 2, "viscous_coefficient": 2,
          "bristle_stiffness": 2, "bristle_damping": 2, "stribeck_speed": -1}


def is_right(key, value, low, high, truth):
    if key == "cog_angle":
        off = abs(math.remainder(value - truth, 2 * math.pi))
        return off < 0.02 or off <= (high - low) / 2
    margin = 0.05 * abs(value)
    return abs(value / truth - 1) < 0.05 or low - margin <= truth <= high + margin


def outcome(program, log, options, truth):
    """Names of the quantities by what became of them, and the first words."""
    with tempfile.TemporaryDirectory() as scratch:
        numbers = pathlib.Path(scratch) / "c.json"
        done = subprocess.run([program, "-q", "report", log, *options, "--no-figures", "--calibration", numbers,
                               "-o", pathlib.Path(scratch) / "r.html"], capture_output=True, text=True)
        if not numbers.exists():
            return None, done.stderr.strip().splitlines()[-1].split(": ", 2)[-1]
        calibration = json.loads(numbers.read_text())
    ratio = calibration["drive"]["gear_ratio"]
    kinds = {"right, usable": [], "right, doubtful": [], "WRONG, usable": [], "wrong, doubtful": []}
    for quantity in calibration["verdict"]["quantities"]:
        estimate = quantity.get("estimate") or {}
        key, verdict = quantity["key"], quantity["verdict"]
        if estimate.get("estimate") is None or verdict == "not_identifiable":
            continue
        if key not in truth and key not in ARM:
            continue
        factor = ratio ** POWERS.get(key, 0)
        low, value, high = (factor * (estimate[k] if estimate.get(k) is not None else estimate["estimate"])
                            for k in ("low", "estimate", "high"))
        right = key in truth and is_right(key, value, low, high, truth[key])
        in_amperes = calibration["drive"].get("torque_is_in_amperes")
        kind = ("right" if right else "WRONG" if verdict == "usable" else "wrong") + ", " + verdict
        if not right and in_amperes and verdict == "doubtful":
            continue  # a number of amperes, said to be one
        kinds[kind].append(key)
    findings = calibration["verdict"].get("findings") or []
    first = findings[0] if findings else ""
    return kinds, (first if isinstance(first, str) else first.get("words", ""))


def listed(names):
    return ", ".join(names) or "–"


def main():
    program, folder = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    print("# Logs as people have them\n")
    print("Made by `tests/data/case_logs.py`; the logs are simulated joints of known truth, written in the dialects and with"
          " the\nfaults of real ones. Each is given to `tribolog report` alone, and with what its user knows.\n")
    print("| log | command | right, usable | right, doubtful | wrong, usable | wrong, doubtful | first finding |")
    print("|---|---|---|---|---|---|---|")
    wrong = right = 0
    for log, truth, options in cases:
        if not (folder / log).exists():
            continue
        for stated in ([], options) if options else ([],):
            typed = " ".join(["tribolog report", pathlib.Path(log).name,
                              *(f'"{one}"' if " " in one else one for one in stated)])
            kinds, words = outcome(program, folder / log, stated, truth)
            words = " ".join(words.split()).replace("|", "/")[:160]
            if kinds is None:
                print(f"| {log} | `{typed}` ({len(typed)}) | refused | | | | {words} |")
                continue
            wrong += len(kinds["WRONG, usable"])
            right += len(kinds["right, usable"])
            print(f"| {log} | `{typed}` ({len(typed)}) | " + " | ".join(listed(names) for names in kinds.values()) + f" | {words} |")
    print(f"\nRight and usable: {right}; wrong and usable: {wrong}. Behind each command its keystrokes.")


main()
