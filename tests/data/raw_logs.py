#!/usr/bin/env python3
"""Writes docs/raw_logs.md: from the raw logs of robots that exist to their numbers, what has to be typed.

  python3 tests/data/raw_logs.py build/src/tribolog > docs/raw_logs.md

The logs are not part of the project; sets that are not beside the checkout are named as missing.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

shared = pathlib.Path(__file__).resolve().parents[3] / "shared/data"

# What the log is, its files, and what nobody can tell from it.
sets = [
    ("UR10e, joint 2", ["ur10e_jointwise/joint_2.csv"], ["--torque-constant", "10.696", "--effort-side", "joint"]),
    ("UR10e, joint 3", ["ur10e_jointwise/joint_3.csv"], ["--torque-constant", "8.457", "--effort-side", "joint"]),
    ("CICESE, joint 1", ["cicese_joint1/breakaway", "cicese_joint1/constant_velocity", "cicese_joint1/presliding"],
     ["--effort-kind", "joint_torque"]),
    ("CICESE, joint 2", ["cicese_joint2"], ["--effort-kind", "joint_torque", "--joint", "2"]),
    ("XL330 pendulum", ["bam_xl330_pendulum"], []),
    # Fs_12 has other columns.
    ("LuGre servo", [f"lugre_servo/LuGre_{name}.txt" for name in ("J_1", "J_2", "Fs_1", "Fs_3", "Fs_7", "sigma0_1")],
     ["--rate", "1000", "--column", "angle=#1", "--column", "effort=#5", "--effort-kind", "motor_torque",
      "--effort-unit", "Nm", "--no-gravity"]),
    ("Damiao motor 3", ["damiao/motor_03.npz"], ["--effort-kind", "joint_torque", "--no-gravity"]),
    ("Damiao motor 5", ["damiao/motor_05.npz"], ["--effort-kind", "joint_torque", "--no-gravity"]),
    ("OpenArm, joint 4", ["openarm_joint4"], ["--effort-kind", "joint_torque"]),
    ("moteus dynamometer", ["moteus_dynamometer"], ["--effort-kind", "joint_torque", "--no-gravity"]),
    ("KUKA LWR 4+, joint 3", ["kuka_lwr4"], ["--joint", "2"]),
]


def run(*command):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True)


def known(quantity):
    """Coulomb torque 0.54 (0.33 to 0.75), doubtful"""
    estimate = quantity["estimate"]
    if quantity["verdict"] == "not_identifiable" or not estimate:
        return None
    side = estimate.get("joint") or estimate.get("motor") or estimate
    return (f'{quantity["words"]} {side["estimate"]:.4g} ({side["low"]:.4g} to {side["high"]:.4g}), '
            f'{quantity["verdict"]}')


def row(program, files, options):
    missing = [name for name in files if not (shared / name).exists()]
    if missing:
        return "", "not beside the checkout"
    with tempfile.TemporaryDirectory() as scratch:
        manifest, result = (pathlib.Path(scratch) / name for name in ("d.toml", "c.json"))
        done = run(program, "--quiet", "init", *[shared / name for name in files], *options, "-o", manifest)
        if done.returncode != 0:
            return "", "init: " + done.stderr.strip().splitlines()[-1][:200]
        roles = [line.split('"')[1] for line in manifest.read_text().splitlines() if line.startswith("role")]
        counts = ", ".join(f"{roles.count(role)} {role}" for role in dict.fromkeys(roles))
        done = run(program, "--quiet", "identify", manifest, "-o", result, "--truth-runs", "0")
        if done.returncode not in (0, 1):
            return counts, done.stderr.strip().splitlines()[-1][:200]
        verdict = json.loads(result.read_text())["verdict"]
        numbers = [text for text in map(known, verdict["quantities"]) if text]
        return counts, "<br>".join(numbers) or verdict["sentence"]


print("""# From raw logs to numbers

Written by `python3 tests/data/raw_logs.py build/src/tribolog`. Each set takes two commands, `init` with
the options shown and `identify`; no line of a manifest is edited.
""")
print("| set | options of init | recordings found | numbers, SI at the joint (95 %), verdict |")
print("|---|---|---|---|")
for name, files, options in sets:
    counts, numbers = row(pathlib.Path(sys.argv[1]).resolve(), files, options)
    print(f'| {name} | `{" ".join(options)}` | {counts} | {numbers} |')
