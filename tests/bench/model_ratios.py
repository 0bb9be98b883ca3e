"""Every friction model's own method against CVODE at equal error. The rule is in models_bench.cpp."""

import json
import math
import subprocess
import sys
from collections import defaultdict


def measured(build, repetitions):
    """{(model, motion, samples a second): {run: (ns a sample, error), or None where it failed}}"""
    out = subprocess.run([f"{build}/tests/bench/models_bench", "--benchmark_format=json",
                          f"--benchmark_repetitions={repetitions}", "--benchmark_min_time=0.01",
                          "--benchmark_enable_random_interleaving=true"],
                         check=True, capture_output=True, text=True)
    tasks = defaultdict(dict)
    for b in json.loads(out.stdout)["benchmarks"]:
        model, motion, rate, run = b["run_name"].split("/")[:4]
        runs = tasks[model, motion, int(rate)]
        if b.get("error_occurred"):
            runs[run] = None
        elif b.get("aggregate_name") == "median":
            runs[run] = (b["ns_per_sample"], b["error"])
    return tasks


def unbeaten(points):
    """Of (time, error) points those that no other beats in both, the most exact first."""
    front = []
    for time, error in sorted(points, key=lambda p: (p[1], p[0])):
        if not front or time < front[-1][0]:
            front.append((time, error))
    return front


def time_at(error, front):
    """Time on the front at an error, and whether that is only a lower bound of it."""
    if error <= front[0][1]:
        return front[0][0], error < front[0][1]
    for (slow, exact), (fast, rough) in zip(front, front[1:]):
        if error <= rough:
            share = math.log(error / exact) / math.log(rough / exact)
            return slow * (fast / slow) ** share, False
    return front[-1][0], False


def compared(runs):
    """Our time and error, CVODE's time at that error, if that is a lower bound, its least error."""
    ns, error = runs["ours"]
    front = unbeaten([run for name, run in runs.items() if run and name != "ours"])
    peer_ns, at_least = time_at(error, front)
    return ns, error, peer_ns, at_least, front[0][1]


def failures(runs):
    failed = sum(run is None for run in runs.values())
    return f" ({failed} of {len(runs) - 1} CVODE runs failed)" if failed else ""


def print_at_rate(rate, tasks):
    print(f"  {rate:,} samples/s:")
    print(f"  {'model':18}{'motion':13}{'ours':>9}{'error':>8}{'CVODE then':>16}{'times':>10}"
          "  CVODE agrees to")
    ratios = {}
    for (model, motion), runs in sorted(tasks.items()):
        ns, error, peer_ns, at_least, agreed = compared(runs)
        ratios[f"{model}, {motion}"] = peer_ns / ns
        print(f"  {model:18}{motion:13}{ns:6.0f} ns{error:8.0e}{peer_ns:13,.0f} ns"
              f"{'>' if at_least else ' ':>2}{peer_ns / ns:8,.1f}  {agreed:.0e}{failures(runs)}")
    lowest = min(ratios, key=ratios.get)
    print(f"  lowest ratio at {rate:,} samples/s: {ratios[lowest]:.1f} ({lowest})")


def print_model_ratios(build, repetitions=3):
    print("friction models, our method against CVODE at equal error of torque (> is a lower bound):")
    tasks = measured(build, repetitions)
    for rate in sorted({rate for _, _, rate in tasks}):
        print_at_rate(rate, {key[:2]: runs for key, runs in tasks.items() if key[2] == rate})


if __name__ == "__main__":
    print_model_ratios(sys.argv[1])
