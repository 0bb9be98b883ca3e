#!/usr/bin/env python3
"""Writes docs/real_logs.md: what tribolog says of logs of robots that exist, beside what others found.

  python3 tests/data/real_logs.py build/src/tribolog > docs/real_logs.md

The logs are not part of the project; sets that are not beside the checkout are named as missing.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent

# By manifest: what the log is, and what was found by hand or published, SI, joint side:
# key: (low, high, where from). The same number twice: a value; a range: fits that differ.
sets = {
    "ur10e_joint_2": ("UR10e, joint 2, sine sweeps", {
        "gravity_torque": (109.1, 109.1, "amplitude of the mid-line by hand"),
        "coulomb_torque": (13.27, 13.27, "published, fit of the whole arm"),
        "viscous_coefficient": (20.22, 20.22, "published, fit of the whole arm")}),
    "ur10e_joint_3": ("UR10e, joint 3, sine sweeps", {
        "gravity_torque": (36.96, 36.96, "amplitude of the mid-line by hand"),
        "coulomb_torque": (4.99, 4.99, "published, fit of the whole arm"),
        "viscous_coefficient": (10.38, 10.38, "published, fit of the whole arm")}),
    "cicese_joint1": ("CICESE direct drive, joint 1, runs and loops", {
        "gravity_torque": (38.465, 38.465, "by design"),
        "coulomb_torque": (10.94, 12.44, "published, by direction"),
        "viscous_coefficient": (2.80, 3.44, "published, by direction"),
        "inertia": (2.5, 2.8, "published for this kind of arm, both joints moving together")}),
    "cicese_break_away": ("CICESE direct drive, joint 1, ramps", {
        "break_away_torque": (10.94, 12.44, "no less than the published Coulomb torque")}),
    "cicese_joint2": ("CICESE direct drive, joint 2, ramps and sines that never slide", {
        "break_away_torque": (1.43, 1.82, "ramps by hand")}),
    "damiao_motor_3": ("Damiao motor 3, stair of speeds, no load", {
        "coulomb_torque": (0.49, 0.50, "by hand, all moving samples"),
        "viscous_coefficient": (0.038, 0.038, "by hand, all moving samples"),
        "inertia": (0.030, 0.030, "by hand, all moving samples")}),
    "damiao_motor_5": ("Damiao motor 5, stair of speeds, no load", {
        "coulomb_torque": (0.103, 0.103, "by hand, all moving samples"),
        "viscous_coefficient": (0.0032, 0.0032, "by hand, all moving samples"),
        "inertia": (0.0004, 0.0004, "by hand, all moving samples")}),
    "lugre_servo": ("LuGre servo, torque ramps, no gravity", {
        "inertia": (1.995e-4, 1.995e-4, "by hand"),
        "break_away_torque": (0.0255, 0.031, "ramps by hand, at 0.1 to 2 rad/s"),
        "coulomb_torque": (0.0272, 0.0342, "by hand, by direction"),
        "viscous_coefficient": (2.47e-4, 2.47e-4, "by hand")}),
    "moteus_dynamometer": ("moteus, gearless motor, one direction", {
        "coulomb_torque": (0.024, 0.049, "by hand, quadratic to straight")}),
    "openarm_joint4": ("OpenArm, joint 4, rests and slips at 12 Hz", {
        "gravity_torque": (3.0, 3.0, "by hand"),
        "coulomb_torque": (0.71, 0.78, "published, by hand")}),
    "kuka_joint3": ("KUKA LWR 4+, joint 3, all joints moving", {}),
    "bam_up_and_down": ("XL330 pendulum, voltage alone", {}),
}


def identify(program, manifest):
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch) / "c.json"
        done = subprocess.run([program, "--quiet", "identify", manifest, "-o", out, "--truth-runs", "0"],
                              capture_output=True, text=True)
        if done.returncode not in (0, 1):
            return None, done.stderr.strip()
        return json.loads(out.read_text()), ""


def shown(low, high):
    return f"{low:.4g}" if low == high else f"{low:.4g} to {high:.4g}"


def main(program):
    print("# Logs of robots that exist\n")
    print("Written by `python3 tests/data/real_logs.py build/src/tribolog`; SI units, at the joint. *Others*: what")
    print("was published or found by hand, none of it a truth. A number that is doubtful or not identifiable is")
    print("shown for comparison; the report says why it is.\n")
    print("| set | quantity | others | tribolog, 95 % | verdict |\n|---|---|---|---|---|")
    wrong = []
    for name, (title, others) in sets.items():
        c, refused = identify(program, here / f"{name}.toml")
        if c is None:
            missing = "cannot open" in refused or "No such file" in refused
            print(f"| {title} | | | {'not beside the checkout' if missing else refused} | |")
            continue
        rows = 0
        for q in c["verdict"]["quantities"]:
            estimate, key = q.get("estimate"), q["key"]
            if not estimate or key not in others and q["verdict"] != "usable":
                continue
            low, high, source = others.get(key, (None, None, ""))
            ours = f"{estimate['estimate']:.4g} ({estimate['low']:.4g} to {estimate['high']:.4g})"
            beside = f"{shown(low, high)}, {source}" if source else ""
            print(f"| {title} | {key} | {beside} | {ours} | {q['verdict'].replace('_', ' ')} |")
            title = ""
            rows += 1
            far = source and (estimate["high"] < 0.9 * low or estimate["low"] > 1.1 * high)
            if far and q["verdict"] == "usable":
                wrong.append(f"{name} {key}")
        if rows == 0:
            words = c["verdict"].get("sentence", "")
            print(f"| {title} | | | nothing | {c['verdict']['verdict'].replace('_', ' ')}: {words} |")
    print("\nUsable, and more than a tenth beyond its interval from all that others found: "
          f"{', '.join(wrong) if wrong else 'none'}.")


if __name__ == "__main__":
    main(sys.argv[1])
