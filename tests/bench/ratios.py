"""Whether the program has become slower, as ratios to a peer doing the same work in the same run.

usage: ratios.py PROGRAM [--rounds N] [--tolerance SHARE] [--write]

Each row is the peer's time over ours (medians of interleaved rounds). Exit status 1 where one is
below (1 - SHARE) of that in ratios.json; 77 without the peer's libraries. --write keeps what was
measured there."""

import argparse
import importlib.util
import json
import os
import statistics
import subprocess
import sys
import tempfile

from measure import timed

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
KEPT = f"{HERE}/ratios.json"


def rows_of(program, scratch):
    """Name of each row: our command and the peer's."""
    run = [sys.executable, f"{HERE}/peer/run.py", f"{scratch}/peer"]
    dataset = f"{scratch}/ours/dataset.toml"
    return {
        "simulate": ([program, "simulate", f"{ROOT}/examples/paper/scenario.toml", "-o",
                      f"{scratch}/ours"], [*run, "simulate"]),
        "inspect": ([program, "inspect", f"{scratch}/ours/rough_sweep.csv"],
                    [sys.executable, "-c", "import numpy, sys; numpy.loadtxt(sys.argv[1], delimiter=',')",
                     f"{scratch}/peer/rough_sweep.csv"]),
        "identify": ([program, "identify", dataset, "-o", f"{scratch}/c.json"], [*run, "identify"]),
        "report": ([program, "report", dataset, "-o", f"{scratch}/r.html"], [*run, "report"]),
    }


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--tolerance", type=float, default=0.5)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    missing = [name for name in ("numpy", "scipy", "matplotlib") if not importlib.util.find_spec(name)]
    if missing:
        print(f"SKIPPED: no {', '.join(missing)}, which the peer needs")
        sys.exit(77)
    with open(KEPT) as kept:
        before = json.load(kept)
    measured, slower = {}, []
    with tempfile.TemporaryDirectory() as scratch:
        rows = rows_of(os.path.abspath(options.program), scratch)
        for name, (ours, peer) in rows.items():
            timed(ours), timed(peer)  # and they write what the next row reads
            pairs = [(timed(ours), timed(peer)) for _ in range(options.rounds)]
            ratios = sorted(b / a for a, b in pairs)
            measured[name] = round(statistics.median(ratios), 2)
            least = (1 - options.tolerance) * before.get(name, 0)
            print(f"{name}: {measured[name]:.2f} times the peer's speed ({ratios[0]:.2f} to "
                  f"{ratios[-1]:.2f}; {statistics.median(a for a, _ in pairs):.2f} s against "
                  f"{statistics.median(b for _, b in pairs):.2f} s); before {before.get(name, 0):.2f}")
            if measured[name] < least:
                slower.append(f"{name}: {measured[name]:.2f}, and {least:.2f} is the least")
    if options.write:
        with open(KEPT, "w") as kept:
            json.dump(measured, kept, indent=2)
            kept.write("\n")
    elif slower:
        sys.exit("slower than before:\n  " + "\n  ".join(slower))


if __name__ == "__main__":
    main()
