"""What the commands cost: seconds, processor seconds and memory, as docs/performance.md has it.

usage: commands.py PROGRAM [--before PROGRAM] [--rounds N] [--rows NAME,...]

Prints a Markdown table. With --before, a second program does each row in turn with the first. The
memory is that of all processes of a command together, of a run that is not timed."""

import argparse
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile

from measure import measured, peak_memory_mb

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

HEAD = """schema = "tribolog-dataset-1"
[robot]
name = "bench"
[joint]
name = "1"
gear_ratio = 100
[effort]
kind = "motor_torque"
side = "motor"
confirmed = true
[columns]
time = {name = "t_s", unit = "s"}
angle = {name = "q_rad", unit = "rad", side = "joint"}
speed = {name = "dq_rad_s", unit = "rad/s"}
effort = {name = "torque_Nm", unit = "Nm"}
"""


def write(path, text):
    with open(path, "w") as out:
        out.write(text)


def friction(motor_speed):
    return math.copysign(0.6 + 0.05 * abs(motor_speed) ** 0.6, motor_speed)


def write_friction_points(directory, rows):
    rng = random.Random(1)
    with open(f"{directory}/points.csv", "w") as out:
        out.write("dq_rad_s,torque_Nm\n")
        for _ in range(rows):
            speed = rng.choice((-1, 1)) * 100 * rng.uniform(0.02, 2)
            out.write(f"{speed / 100:.6g},{friction(speed) + rng.gauss(0, 0.01):.6g}\n")
    head = HEAD.replace('time = {name = "t_s", unit = "s"}\n', "").replace(
        'angle = {name = "q_rad", unit = "rad", side = "joint"}\n', "")
    write(f"{directory}/points.toml", head + '[[recording]]\nrole = "friction_points"\nfile = "points.csv"\n')


def write_recordings(directory, recordings, rows=200):
    """Runs at constant speed, a file each."""
    rng = random.Random(1)
    entries = []
    for k in range(recordings):
        speed = (-1) ** k * 0.01 * (1 + k // 2 % 50)
        with open(f"{directory}/{k}.csv", "w") as out:
            out.write("t_s,q_rad,dq_rad_s,torque_Nm\n")
            for i in range(rows):
                q = speed * (i - rows / 2) * 0.01
                torque = 3.9 * math.cos(q) + friction(100 * speed) + rng.gauss(0, 0.01)
                out.write(f"{i * 0.01:.2f},{q:.7f},{speed:.7f},{torque:.5f}\n")
        entries.append(f'[[recording]]\nrole = "constant_speed"\nfile = "{k}.csv"\n')
    write(f"{directory}/many.toml", HEAD + "".join(entries))


def prepare(program, at):
    """What the rows read, in folders below `at`."""
    def simulate(scenario, name):
        subprocess.run([program, "simulate", f"{ROOT}/examples/{scenario}", "-o", f"{at}/{name}"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    simulate("paper/scenario_noise.toml", "noisy")
    simulate("six_axes/scenario.toml", "six")
    for rows in (100_000, 1_000_000):
        os.makedirs(f"{at}/points_{rows}")
        write_friction_points(f"{at}/points_{rows}", rows)
    for recordings in (1_000, 10_000):
        os.makedirs(f"{at}/many_{recordings}")
        write_recordings(f"{at}/many_{recordings}", recordings)
    subprocess.run([program, "identify", f"{at}/noisy/dataset.toml", "-o", f"{at}/noisy.json"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def rows_of(at, out):
    """Name of each row, and its command; `out` is a folder of its own for what is written."""
    examples = f"{ROOT}/examples"
    noisy = f"{at}/noisy/dataset.toml"
    rough = f"{at}/noisy/rough_sweep.csv"
    return {
        "simulate": ["simulate", f"{examples}/paper/scenario_noise.toml", "-o", f"{out}/simulated"],
        "inspect": ["inspect", rough],
        "init": ["init", rough, "-o", f"{out}/proposed.toml", "--force"],
        "identify": ["identify", noisy, "-o", f"{out}/c.json"],
        "figures": ["figures", noisy, "-o", f"{out}/png"],
        "figures, SVG and PDF": ["figures", noisy, "-o", f"{out}/vector", "--format", "svg,pdf"],
        "report": ["report", noisy, "-o", f"{out}/report.html"],
        "report, six axes": ["report", f"{at}/six/robot.toml", "-o", f"{out}/six"],
        "export": ["export", f"{at}/noisy.json", "--format", "csv", "-o", f"{out}/export"],
        "plan": ["plan", f"{examples}/plan/joint.toml", "-o", f"{out}/plan"],
        "paper": ["paper", "-o", f"{out}/paper.html"],
        "study, 2 runs": ["study", f"{examples}/paper/scenario_noise.toml", "--runs", "2",
                          "-o", f"{out}/study.html"],
        "identify, 1e5 friction points": ["identify", f"{at}/points_100000/points.toml",
                                          "-o", f"{out}/c.json"],
        "identify, 1e6 friction points": ["identify", f"{at}/points_1000000/points.toml",
                                          "-o", f"{out}/c.json"],
        "identify, 1,000 recordings": ["identify", f"{at}/many_1000/many.toml",
                                       "-o", f"{out}/c.json"],
        "identify, 10,000 recordings": ["identify", f"{at}/many_10000/many.toml",
                                        "-o", f"{out}/c.json"],
    }


def seconds_of(command):
    """Seconds and processor seconds of a command and of the processes it starts."""
    wall, usage, status = measured(command)
    if status != 0:
        sys.exit(f"status {status}: {' '.join(command)}")
    return wall, usage.ru_utime + usage.ru_stime


def shown(seconds):
    return f"{seconds:.2f}" if seconds < 10 else f"{seconds:.1f}"


def is_refused(command):
    """Twice: what it wrote must not be in its way."""
    return any(measured(command)[2] != 0 for _ in range(2))


def cells(runs, command):
    walls = sorted(wall for wall, _ in runs)
    processor = statistics.median(cpu for _, cpu in runs)
    return [f"{shown(statistics.median(walls))} ({shown(walls[0])} to {shown(walls[-1])})",
            shown(processor), f"{peak_memory_mb(command):.0f}"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--before")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--rows", help="names of rows, separated by semicolons")
    options = parser.parse_args()
    programs = [os.path.abspath(p) for p in (options.before, options.program) if p]
    columns = ["s (lowest to highest)", "processor s", "peak MB"]
    titles = ([f"before: {c}" for c in columns] if options.before else []) + columns
    print("| command | " + " | ".join(titles) + " |\n|---|" + "--:|" * len(titles))
    with tempfile.TemporaryDirectory() as at:
        prepare(programs[-1], at)
        os.makedirs(f"{at}/out")
        rows = rows_of(at, f"{at}/out")
        for name in options.rows.split(";") if options.rows else rows:
            commands = [[program, *rows[name]] for program in programs]
            # What an older program does not know has no cells.
            is_new = len(commands) > 1 and is_refused(commands[0])
            if is_new:
                del commands[0]
            first = [seconds_of(command) for command in commands]
            # A row of half a minute tells enough in three rounds.
            rounds = options.rounds if first[-1][0] < 15 else min(3, options.rounds)
            runs = [[seconds_of(command) for command in commands] for _ in range(rounds)]
            row = ["–"] * len(columns) if is_new else []
            row += [c for k, command in enumerate(commands) for c in cells([r[k] for r in runs], command)]
            print(f"| {name} | " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
