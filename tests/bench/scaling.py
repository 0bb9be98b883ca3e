"""Rows against time and memory, for every kind of recording: does the cost grow with the work?

usage: scaling.py PROGRAM [--rows 1e3,1e4,1e5,1e6,1e7] [--kinds NAME,...] [-- OPTION...]

Makes one log of each size and kind, identifies it, and prints a table: user time is what one core
would take, `x` how many times that of the row before it (10 is linear), memory the largest resident
set beside the limit, twice the log and 200 MB. What stands behind -- goes to `identify`."""

import argparse
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

from measure import measured

JOINT = """schema = "tribolog-scenario-1"
name = "scaling"
[robot]
name = "bench"
[joint]
name = "1"
gear_ratio = 100
motor_inertia_kgm2 = 1e-4
arm_inertia_kgm2 = 15.8
[load]
mass_kg = 98.95988047910294
distance_m = 0.4
q_peak_deg = -22.23187
[surrogate]
distance_m = 0.5
[friction]
model = "lugre"
[friction.presliding]
bristle_stiffness_Nm_rad = 465.42
bristle_damping_Nms_rad = 0.7708
viscous_Nms_rad = 0.001
coulomb_Nm = 0.6
static_Nm = 0.88437633
stribeck_speed_rad_s = 5
[friction.sliding]
model = "waiboer"
asperity_torque_Nm = 0.8844
stribeck_speed_rad_s = 5
stribeck_power = 0.7
viscous_coefficient = 0.12
viscous_power = 0.6
smoothing_s_rad = 1e6
[noise]
torque_white_Nm = 0.02
torque_step_Nm = 0.005
encoder_counts_per_turn = 131072
speed_filter_Hz = 100
"""

MANIFEST = """schema = "tribolog-dataset-1"
[robot]
name = "bench"
[joint]
name = "1"
gear_ratio = 100
[effort]
kind = "motor_torque"
side = "motor"
[columns]
time = {name = "t_s", unit = "s"}
angle = {name = "q_rad", unit = "rad", side = "joint"}
effort = {name = "torque_Nm", unit = "Nm"}
[[recording]]
role = "oscillation"
file = "log.csv"
"""


def allow_any_rate(manifest):
    """The largest logs are sampled faster than any drive's, which is refused unless stated."""
    with open(manifest) as file:
        text = file.read()
    with open(manifest, "w") as file:
        file.write(text.replace('unit = "s"}', 'unit = "s", any_rate = true}'))


def simulated(section):
    """A log by the program's own simulation; `section` gives its experiment for so many rows."""
    def make(program, directory, rows):
        scenario = f"{directory}/scenario.toml"
        with open(scenario, "w") as out:
            out.write(JOINT + section(rows))
        subprocess.run([program, "simulate", scenario, "-o", directory], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        allow_any_rate(f"{directory}/dataset.toml")
        return ["identify", f"{directory}/dataset.toml", "-o", f"{directory}/out.json"]
    return make


def sweep(name, low, high, speed, duration_s):
    return simulated(lambda rows: f"""[{name}]
from_deg = {low}
to_deg = {high}
speed_deg_s = {speed}
acceleration_rad_s2 = 1
sample_rate_Hz = {rows / duration_s}
""")


def oscillation(cycles_of, rate_of):
    return simulated(lambda rows: f"""[oscillation]
centre_deg = -22.23187
amplitude_rad = 1e-4
frequency_Hz = 1
cycles = {cycles_of(rows)}
sample_rate_Hz = {rate_of(rows)}
record_bristle = false
""")


def runs(rows):
    seconds = 2 * 3 * 5.0  # three speeds, there and back, and what the ramps take
    return f"""[constant_speed]
motor_speeds_rad_s = [3, 10, 30]
centre_deg = -22.23187
largest_travel_deg = 60
longest_plateau_s = 5
acceleration_rad_s2 = 20
sample_rate_Hz = {rows / seconds}
"""


def ramps(rows):
    seconds = 2 * 2.0 * 9  # two ramps each way
    return f"""[break_away]
centre_deg = -22.23187
rate_Nm_s = 0.1
largest_torque_Nm = 1.5
repeats = 2
sample_rate_Hz = {rows / seconds}
"""


def stroke_rows(strokes, rows_per_stroke):
    """Angle, speed and torque along strokes of no period, as under a drifting torque: the contact
    relaxes over the way, G cos(q - q_peak) on top. All but the time, as text."""
    rng = random.Random(1)
    level, reach = 0.88, 0.0019  # N·m, and rad at the motor within which friction turns over
    n, q, z, side = 100, 0.0, 0.0, 1
    out = []
    for _ in range(strokes):
        # Back to the other side of the middle, each time to another angle.
        target = side * (5e-5 + 6e-5 * rng.random())
        side = -side
        travel, start, z_start = target - q, q, z
        count = int(rows_per_stroke * (0.7 + 0.6 * rng.random()))
        for i in range(count):
            share = (1 - math.cos(math.pi * i / count)) / 2
            way = abs(travel) * share * n
            sign = 1 if travel > 0 else -1
            z = sign + (z_start - sign) * math.exp(-way / reach)
            q = start + travel * share
            noisy = q + rng.gauss(0, 2e-9)
            speed = travel * math.pi / 2 / count * math.sin(math.pi * i / count) * 1000
            torque = 3.88 * math.cos(q) + level * z + rng.gauss(0, 0.005)
            out.append(f",{noisy:.12g},{speed:.9g},{torque:.6g}\n")
    return out


def driven_by_torque(program, directory, rows):
    block = stroke_rows(2 * round(min(rows, 100000) / 1000 / 2) or 4, min(rows / 4, 1000))
    with open(f"{directory}/log.csv", "w") as out:
        out.write("t_s,q_rad,dq_rad_s,torque_Nm\n")
        for first in range(0, rows, len(block)):
            part = block[:rows - first]
            out.writelines(f"{(first + i) / 1000}{row}" for i, row in enumerate(part))
    with open(f"{directory}/dataset.toml", "w") as out:
        out.write(MANIFEST)
    return ["identify", f"{directory}/dataset.toml", "-o", f"{directory}/out.json"]


def many_columns(program, directory, columns):
    """Not rows but columns grow: 200 rows of names that mean nothing, and of joints."""
    rng = random.Random(1)
    names = ["t_s"] + [f"{'q' if k % 2 else 'signal_'}{k}" for k in range(1, columns)]
    with open(f"{directory}/log.csv", "w") as out:
        out.write(",".join(names) + "\n")
        row = [f"{rng.random():.6f}" for _ in range(columns)]
        for i in range(200):
            row[0] = f"{i / 1000}"
            row[1 + i % (columns - 1)] = f"{rng.random():.6f}"
            out.write(",".join(row) + "\n")
    return ["inspect", f"{directory}/log.csv"]


def inspected(make):
    def made(program, directory, rows):
        make(program, directory, rows)
        logs = [f for f in os.listdir(directory) if f.endswith(".csv")]
        return ["inspect", *(f"{directory}/{log}" for log in logs)]
    return made


KINDS = {
    "rough sweep": sweep("rough_sweep", -80, 60, 2, 140),
    "precise sweep": sweep("precise_sweep", -23.2, -21.2, 0.1, 40),
    "oscillation, more cycles": oscillation(lambda n: max(2, n / 1000), lambda n: min(n / 2, 1000)),
    "oscillation, finer samples": oscillation(lambda n: 10, lambda n: n / 10),
    "oscillation, torque-driven": driven_by_torque,
    "constant speed": simulated(runs),
    "break-away ramps": simulated(ramps),
    "inspect, rough sweep": inspected(sweep("rough_sweep", -80, 60, 2, 140)),
    "inspect, oscillation": inspected(
        oscillation(lambda n: max(2, n / 1000), lambda n: min(n / 2, 1000))),
    "inspect, columns": many_columns,
}


def log_megabytes(directory):
    logs = (f for f in os.listdir(directory) if f.endswith(".csv"))
    return sum(os.path.getsize(f"{directory}/{f}") for f in logs) / 1e6


def main():
    arguments = sys.argv[1:]
    further = []
    if "--" in arguments:
        at = arguments.index("--")
        arguments, further = arguments[:at], arguments[at + 1:]
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--rows", default="1e3,1e4,1e5,1e6,1e7")
    parser.add_argument("--kinds", default=",".join(KINDS).replace(", ", "; "))
    options = parser.parse_args(arguments)
    kinds = [name.strip().replace("; ", ", ") for name in options.kinds.split(",")]
    program = os.path.abspath(options.program)
    print("| recording | rows | log MB | s | user s | x | peak MB | limit MB | status |\n"
          "|---|--:|--:|--:|--:|--:|--:|--:|--:|")
    for name in kinds:
        before = None
        for rows in (int(float(n)) for n in options.rows.split(",")):
            directory = tempfile.mkdtemp()
            try:
                if KINDS[name] is many_columns and rows > 100000:
                    break
                command = KINDS[name](program, directory, rows)
                if command[0] == "identify":
                    command += further
                size = log_megabytes(directory)
                wall, usage, status = measured([program, *command])
                user, peak = usage.ru_utime, usage.ru_maxrss / 1024
            finally:
                shutil.rmtree(directory)
            growth = f"{user / before:.1f}" if before else ""
            print(f"| {name} | {rows:,} | {size:.1f} | {wall:.2f} | {user:.2f} | {growth} | "
                  f"{peak:.0f} | {2 * size + 200:.0f} | {status} |", flush=True)
            before = max(user, 1e-3)


if __name__ == "__main__":
    main()
