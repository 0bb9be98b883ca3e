#!/usr/bin/env python3
"""What each part of the recordings is worth: identifies the paper's joint with the noise of a real drive
without it, and puts the table into docs/recording.md.

  python3 docs/lacking.py TRIBOLOG

The manifest that `simulate` writes states that there are no disturbing effects; here it does not, as of a
real joint, and friction is not known beforehand."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

DOCS = pathlib.Path(__file__).resolve().parent
SCENARIO = DOCS.parent / "examples/paper/scenario_noise.toml"
PAGE = DOCS / "recording.md"
PART = re.compile(r"(<!-- made by docs/lacking.py -->\n)(.*?)(<!-- end of it -->)", re.DOTALL)

RAMPS = """
[break_away]
centre_deg = -22.23187
rate_Nm_s = 0.22
largest_torque_Nm = 1.42
repeats = 5
both_directions = true
sample_rate_Hz = 1000
"""


# A variant is what to do with the scenario, and with the manifest of what was simulated.

def as_it_is(text):
    return text


def without_role(*roles):
    def change(manifest):
        parts = re.split(r"(?=\[\[recording\]\])", manifest)
        return "".join(part for part in parts if not any(f'role = "{role}"' in part for role in roles))
    return as_it_is, change


def scenario_with(old, new):
    def change(scenario):
        if not re.search(old, scenario):
            sys.exit(f"the scenario has no {old}")
        return re.sub(old, new, scenario)
    return change, as_it_is


ALL_SPEEDS = r"motor_speeds_rad_s = \[[^]]*\]"
VARIANTS = [
    ("everything", (as_it_is, as_it_is)),
    ("no rough sweep", without_role("rough_sweep")),
    ("no precise sweep", without_role("precise_sweep")),
    ("no oscillation", without_role("oscillation")),
    ("no runs at constant speed", without_role("constant_speed")),
    ("no break-away ramps", without_role("break_away")),
    ("rough sweep alone", without_role("precise_sweep", "oscillation", "constant_speed", "break_away")),
    ("runs alone", without_role("rough_sweep", "precise_sweep", "oscillation", "break_away")),
    ("oscillation alone", without_role("rough_sweep", "precise_sweep", "constant_speed", "break_away")),
    ("one direction in sweeps and runs", scenario_with(r"both_directions = true +# ours", "both_directions = false # ours")),
    ("sweep over 20° in place of 140°", scenario_with(r"from_deg = -80 (.*)\nto_deg = 60", r"from_deg = -32 \1\nto_deg = -12")),
    ("three speeds in place of twenty", scenario_with(ALL_SPEEDS, "motor_speeds_rad_s = [10, 55, 300]")),
    ("100 Hz in place of 1 kHz", scenario_with(r"sample_rate_Hz = 1000", "sample_rate_Hz = 100")),
    ("encoder of 4,096 counts to a motor turn", scenario_with(r"encoder_counts_per_turn = 131072", "encoder_counts_per_turn = 4096")),
]

QUANTITIES = ["cog_angle", "gravity_torque", "break_away_torque", "bristle_stiffness", "bristle_damping", "inertia"]
HEADS = ["angle", "gravity", "break-away", "stiffness", "damping", "inertia", "friction at 2 rad/s", "at 30", "at 240"]
SPEEDS = [2, 30, 240]


def shown(value, verdict):
    """Usable plain, doubtful in brackets."""
    return value if verdict == "usable" else f"({value})"


def cell(quantity):
    if quantity is None or quantity["verdict"] == "not_identifiable" or quantity.get("estimate") is None:
        return "–"
    estimate = quantity["estimate"]
    half = (estimate["high"] - estimate["low"]) / 2
    if quantity["key"] == "cog_angle":
        return shown(f"{half * 57.29578:.2g}°", quantity["verdict"])
    return shown(f"{100 * half / abs(estimate['estimate']):.2g} %", quantity["verdict"])


def friction_cell(points, speed):
    """The half width at the speed, from the nearest that is stated."""
    near = [p for p in points if abs(p["speed_rad_s"] / speed - 1) < 0.05]
    if not near:
        return "–"
    point = min(near, key=lambda p: abs(p["speed_rad_s"] - speed))
    if point["verdict"] == "not_identifiable":
        return "–"
    half = (point["high"] - point["low"]) / 2
    return shown(f"{100 * half / abs(point['estimate']):.2g} %", point["verdict"])


def row_of(program, name, change, folder):
    scenario = SCENARIO.read_text(encoding="utf-8").replace('description = "am100ib.toml"', "#") + RAMPS
    (folder / "scenario.toml").write_text(change[0](scenario), encoding="utf-8")
    subprocess.run([program, "simulate", "-q", folder / "scenario.toml", "-o", folder], check=True)
    manifest = (folder / "dataset.toml").read_text(encoding="utf-8")
    manifest = re.sub(r"\[(effects|reference[^]]*)\]\n(?:[^\[\n#].*\n|\n)*", "", manifest)
    (folder / "dataset.toml").write_text(change[1](manifest), encoding="utf-8")
    numbers = folder / "numbers.json"
    subprocess.run([program, "identify", "-q", folder / "dataset.toml", "-o", numbers, "--truth-runs", "0"],
                   check=True, stderr=subprocess.DEVNULL)
    found = json.loads(numbers.read_text(encoding="utf-8"))
    quantities = {q["key"]: q for q in found["verdict"]["quantities"]}
    points = found["friction_at_speed"] or []
    cells = [cell(quantities.get(key)) for key in QUANTITIES] + [friction_cell(points, s) for s in SPEEDS]
    return f"| {name} | " + " | ".join(cells) + " |\n"


def main(program):
    table = "| recorded | " + " | ".join(HEADS) + " |\n" + "|---" * (len(HEADS) + 1) + "|\n"
    for name, change in VARIANTS:
        with tempfile.TemporaryDirectory() as scratch:
            table += row_of(program, name, change, pathlib.Path(scratch))
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(PART.sub(lambda part: f"{part[1]}\n{table}\n{part[3]}", text), encoding="utf-8")
    print(table, end="")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
