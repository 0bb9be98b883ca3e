#!/usr/bin/env python3
"""Round trip of `export --format mjcf` and `mjcf-lugre` in MuJoCo: the engine, run on the exported file,
gives the certified friction at each speed within the largest error that the file states.

  mujoco_friction.py TRIBOLOG SCENARIO.toml [JOINTS]

JOINTS (default 200) are made of the scenario's calibration: every torque, stiffness and inertia times a factor
drawn at random, every speed by another, the gear ratio anew. Exit status 1 where one is off; prints
SKIPPED without MuJoCo in this Python. The LuGre model needs 3.12 or newer.
"""

import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile


def scaled(e, factor):
    for key in ("estimate", "low", "high"):
        if e.get(key) is not None:
            e[key] *= factor


def drawn(calibration, rng):
    """Another joint: torque and speed in other units, so to speak, and another gear."""
    joint = json.loads(json.dumps(calibration))
    torque, speed = 10 ** rng.uniform(-1.5, 1), 10 ** rng.uniform(-0.7, 0.7)
    joint["drive"]["gear_ratio"] = rng.uniform(1, 160)
    of = {"break_away_torque": torque, "coulomb_torque": torque, "gravity_torque": torque,
          "bristle_stiffness": torque, "bristle_damping": torque / speed,
          "viscous_coefficient": torque / speed, "inertia": torque}
    for q in joint["verdict"]["quantities"]:
        if q["estimate"] and q["key"] in of:
            scaled(q["estimate"], of[q["key"]])
            if q.get("budget"):
                scaled(q["budget"]["expanded"], of[q["key"]])
    for f in joint["friction_at_speed"]:
        f["speed_rad_s"] *= speed
        scaled(f, torque)
        for key in ("forward", "backward"):
            if f.get(key):
                scaled(f[key], torque)
    joint["friction_stated_at_rad_s"] = []
    return joint


def torque_in_engine(mujoco, model, speed):
    """Torque that a servo gives to hold the speed, the armature moving against the friction."""
    model.opt.timestep = 1e-4
    data = mujoco.MjData(model)
    data.qvel[0] = speed
    gain, integral = 2000 * model.dof_M0[0], 0.0
    steps = 4000
    held = []
    for step in range(steps):
        error = speed - data.qvel[0]
        integral += error * model.opt.timestep
        data.qfrc_applied[0] = gain * (error + 200 * integral)
        mujoco.mj_step(model, data)
        if step > 0.95 * steps:
            held.append(data.qfrc_applied[0])
    return sum(held) / len(held)


def exported(program, path, form):
    """The model, and the largest error that it states [N·m]."""
    text = subprocess.run([program, "export", str(path), "--format", form, "--doubtful-too"],
                          capture_output=True, text=True, check=True).stdout
    return text, float(re.search(r"largest error there is ([0-9.e+-]+) N·m", text)[1])


def round_trip(mujoco, program, path, form, calibrations):
    """How many speeds are off. @param path for the calibration of a joint at a time."""
    worst, off = -math.inf, 0
    for k, joint in enumerate(calibrations):
        path.write_text(json.dumps(joint))
        text, stated = exported(program, path, form)
        n = joint["drive"]["gear_ratio"]
        inertia = n**2 * next(q["estimate"]["estimate"] for q in joint["verdict"]["quantities"]
                              if q["key"] == "inertia")
        model = mujoco.MjModel.from_xml_string(
            text.replace('diaginertia="1 1 1"', f'diaginertia="{inertia} {inertia} {inertia}"'))
        usable = [f for f in joint["friction_at_speed"] if f["verdict"] != "not_identifiable"]
        for f in usable[:: max(1, len(usable) // 4)]:
            for sign in (1, -1):
                speed, want = sign * f["speed_rad_s"] / n, sign * f["estimate"] * n
                error = abs(torque_in_engine(mujoco, model, speed) - want)
                excess = 100 * (error - stated) / abs(want)
                worst = max(worst, excess)
                if excess > 1:
                    off += 1
                    print(f"{form}, joint {k}: {speed:.4g} rad/s: {error:.3g} N·m off, stated {stated}")
    print(f"{form}, MuJoCo {mujoco.__version__}: {len(calibrations)} joints, {off} speeds beyond the stated "
          f"error; largest excess {worst:.3g} % of the friction")
    return off


def main(program, scenario, joints):
    try:
        import mujoco
    except ImportError:
        print("SKIPPED: no module mujoco")
        return 0
    is_recent = tuple(int(x) for x in mujoco.__version__.split(".")[:2]) >= (3, 12)
    rng = random.Random(5)
    program = pathlib.Path(program).absolute()
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "joint.json"
        for words in (["simulate", scenario, "-o", folder],
                      ["identify", f"{folder}/dataset.toml", "-o", str(path)]):
            subprocess.run([program, "-q", *words], check=True)
        calibration = json.loads(path.read_text())
        os.chdir(folder)  # the engine writes its warnings into a file where it runs
        drawn_joints = [drawn(calibration, rng) for _ in range(joints)]
        forms = ["mjcf", "mjcf-lugre"] if is_recent else ["mjcf"]
        off = sum(round_trip(mujoco, program, path, form, drawn_joints) for form in forms)
    return 1 if off else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 200))
