#!/usr/bin/env python3
"""Sets every number of every example and of a manifest with every table to numbers that no joint has.

    walk_numbers.py PROGRAM SOURCE_DIR [--share N] [--jobs N]

The program has to take each as it is or refuse it at its place: status 0, 1 or 2, or 3 with
file:line:column; no other status, no signal, no more than 30 s of CPU time or 2 GB. With
--share N every N-th of the runs alone (ctest's quick form); without, all of them.
"""

import argparse
import concurrent.futures
import math
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile

VALUES = ["0", "-1", "1e-320", "1e-308", "1e-300", "1e9", "1e15", "1e308", "inf", "nan", "-0.0",
          "9223372036854775807"]
CPU_S = 30
MEMORY_BYTES = 2 << 30
NUMBER = re.compile(r"(?<![\w.\"'#+-])[-+]?\d[\d_]*(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.\"':-])")

MANIFEST = """schema = "tribolog-dataset-1"
[robot]
name = "test robot"
[joint]
name = "J1"
gear_ratio = 100
[effort]
kind = "motor_current"
side = "motor"
torque_constant_Nm_A = 1.0
sign = 1
[payload]
mass_kg = 5
distance_m = 0.25
[temperature]
degC = 21.5
[surrogate]
distance_m = 0.5
gravity_m_s2 = 9.81
[known_gravity]
amplitude_Nm = 70
q_peak_deg = 11
[[known_load]]
amplitude_Nm = 1.825
angles = ["q"]
phase_deg = -90
[intervals]
seed = 1
[[limit]]
quantity = "coulomb_joint_Nm"
max = 150
min = 0.5
half_width = 3
half_width_percent = 20
[reference.waiboer]
asperity_torque_Nm = 0.88
viscous_coefficient = 0.03
stribeck_speed_rad_s = 5
stribeck_power = 1.0
viscous_power = 0.6
[log]
header_line = 1
[columns]
time = { name = "t", unit = "s" }
angle = { name = "q", unit = "rad" }
effort = { name = "i", unit = "A" }
[[recording]]
role = "rough_sweep"
file = "log.csv"
from_s = 0.5
to_s = 55
"""


def sweep_log():
    rows = ["t,q,i"]
    for direction in (1, -1):
        for k in range(1500):
            t = k / 50 + (30 if direction < 0 else 0)
            q = direction * (-1.5 + 0.1 * (t % 30))
            rows.append(f"{t:.2f},{q:.6f},{0.7 * math.cos(q - 0.2) + 0.6 * direction + 0.01 * (k % 7):.5f}")
    return "\n".join(rows) + "\n"


def cases(source):
    """Name, files of the folder, the file to walk, and the command's arguments."""
    paper = os.path.join(source, "examples", "paper")

    def text(*path):
        with open(os.path.join(source, *path), encoding="utf-8") as file:
            return file.read()

    arm = text("examples", "paper", "am100ib.toml")
    for name in sorted(os.listdir(paper)):
        if name.startswith("scenario"):
            files = {name: text("examples", "paper", name), "am100ib.toml": arm}
            yield name, files, name, ["simulate", name, "-o", "out"]
    files = {"scenario.toml": text("examples", "paper", "scenario.toml"), "am100ib.toml": arm}
    yield "am100ib.toml", files, "am100ib.toml", ["simulate", "scenario.toml", "-o", "out"]
    joint = text("examples", "plan", "joint.toml")
    yield "joint.toml", {"joint.toml": joint}, "joint.toml", ["plan", "joint.toml", "-o", "out",
                                                               "--runs", "2", "-j", "1"]
    files = {"dataset.toml": MANIFEST, "log.csv": sweep_log()}
    yield "dataset.toml", files, "dataset.toml", ["identify", "dataset.toml", "-o", "c.json",
                                                  "--truth-runs", "2"]


def numbers_of(text):
    """Places of the numbers that stand as values."""
    at = 0
    for line in text.splitlines(keepends=True):
        code = re.sub(r'"[^"]*"', lambda m: '"' * len(m.group()), line).split("#")[0]
        begin = code.find("=") + 1
        if begin > 0:
            for found in NUMBER.finditer(code, begin):
                yield at + found.start(), at + found.end()
        at += len(line)


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_S, CPU_S))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(program, arguments, folder):
    # What is used and not what is reserved counts: the peak is asked for behind the run.
    command = ["/usr/bin/env", program, "--quiet", *arguments]
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, preexec_fn=limits)
    said = process.stderr.read().decode("utf-8", "backslashreplace")
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    return process.returncode, said, usage


def fault_of(status, said, usage, walked):
    if status not in (0, 1, 2, 3):
        return f"status {status}"
    if status == 3 and not re.search(re.escape(walked) + r":\d+:\d+: ", said):
        return "no file:line:column"
    if status != 0 and len(said.strip().splitlines()) != 1 and "error:" not in said:
        return "not one line"
    if usage.ru_maxrss * 1024 > MEMORY_BYTES:
        return f"{usage.ru_maxrss // 1024} MB"
    return ""


def walk(program, job):
    name, files, walked, arguments, line, value = job
    folder = tempfile.mkdtemp(prefix="tribolog-walk-")
    try:
        for file, text in files.items():
            with open(os.path.join(folder, file), "w", encoding="utf-8") as out:
                out.write(text)
        status, said, usage = run(program, arguments, folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    fault = fault_of(status, said, usage, walked)
    seconds = usage.ru_utime + usage.ru_stime
    return fault, f"{name}: {line.strip()} <- {value}: {said.strip()[:300]}", status, seconds


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("source")
    parser.add_argument("--share", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    jobs = []
    for name, files, walked, arguments in cases(options.source):
        if options.only not in name:
            continue
        text = files[walked]
        for begin, end in numbers_of(text):
            line_begin = text.rfind("\n", 0, begin) + 1
            line = text[line_begin:text.find("\n", begin)]
            for value in VALUES:
                broken = dict(files)
                broken[walked] = text[:begin] + value + text[end:]
                jobs.append((name, broken, walked, arguments, line, value))
    jobs = jobs[::options.share]
    faults, statuses, longest = 0, {}, (0.0, "")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for fault, words, status, seconds in pool.map(lambda job: walk(program, job), jobs):
            statuses[status] = statuses.get(status, 0) + 1
            longest = max(longest, (seconds, words))
            if fault:
                faults += 1
                print(f"{fault}: {words}", flush=True)
    print(f"{len(jobs)} runs, by status {dict(sorted(statuses.items()))}; longest {longest[0]:.1f} s "
          f"({longest[1][:100]}); {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
