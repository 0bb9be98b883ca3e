"""Runs ours and the peers in turn and prints ratios. usage: compare.py BUILD [--rounds N]"""

import argparse
import importlib
import json
import os
import statistics
import subprocess
import sys
import tempfile

from measure import peak_memory_mb, timed
from model_ratios import print_model_ratios

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def pair(name, ours, peer, rounds):
    """Median of peer/ours over interleaved rounds, after one warm-up of each."""
    for warm_up in (ours, peer):
        warm_up()
    pairs = [(ours(), peer()) for _ in range(rounds)]
    ratios = sorted(b / a for a, b in pairs)
    print(f"{name}: {statistics.median(ratios):.1f} times faster than the peer "
          f"(lowest {ratios[0]:.1f}, highest {ratios[-1]:.1f} of {rounds} rounds; medians "
          f"{statistics.median(a for a, _ in pairs):.2f} s and "
          f"{statistics.median(b for _, b in pairs):.2f} s)")


def integrator(build):
    out = subprocess.run([f"{build}/tests/bench/integrator_bench", "--benchmark_format=json",
                          "--benchmark_repetitions=5", "--benchmark_min_time=0.1",
                          "--benchmark_enable_random_interleaving=true"],
                         check=True, capture_output=True, text=True)
    rows = {}
    for b in json.loads(out.stdout)["benchmarks"]:
        if b.get("aggregate_name") == "median":
            rows[b["run_name"].split("/repeats")[0]] = (b["ns_per_sample"], b["error"])
    scipy = subprocess.run([sys.executable, f"{HERE}/peer/time_bristle.py"], check=True,
                           capture_output=True, text=True)
    for line in scipy.stdout.splitlines():
        rate, rtol, ns, error = line.split()
        rows[f"scipy/{rate}/{rtol}"] = (float(ns), float(error))
    print("prescribed-motion LuGre, the paper's micro-oscillation:")
    for rate in ("10000", "100000"):
        ns, error = rows[f"ours/{rate}"]
        print(f"  {int(rate):,} samples/s, ours: {ns:.1f} ns a sample, relative error {error:.1e}")
        for name, (peer_ns, peer_error) in sorted(rows.items()):
            if name.startswith(("cvode", "scipy")) and name.split("/")[1] == rate:
                print(f"    {name.split('/')[0]}, tolerance 1e-{name.split('/')[2]}: "
                      f"{peer_ns:.0f} ns, error {peer_error:.1e}; ours is {peer_ns / ns:.1f} times faster")


def loop_fit(build, scratch, rounds):
    """LuGre on 2,000 samples of a loop, six parameters: ours against scipy.optimize.least_squares."""
    data = f"{scratch}/loop.csv"

    def row(command):
        out = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        return [float(x) for x in out.split()]

    pairs = [(row([f"{build}/tests/bench/loop_fit_bench", data]),
              row([sys.executable, f"{HERE}/peer/loop_fit.py", data])) for _ in range(rounds)]
    ratios = sorted(peer[0] / ours[0] for ours, peer in pairs)
    ours, peer = pairs[-1]
    print(f"loop fit, 2,000 samples, six parameters: {statistics.median(ratios):.0f} times faster than "
          f"scipy.optimize.least_squares (lowest {ratios[0]:.0f}, highest {ratios[-1]:.0f}; "
          f"{ours[0]:.2f} ms in {ours[2]:.0f} evaluations against {peer[0]:.1f} ms in {peer[2]:.0f})")
    print(f"  cost: ours {ours[1]:.9g}, peer {peer[1]:.9g}, relative difference "
          f"{abs(ours[1] - peer[1]) / peer[1]:.1e}")
    if abs(ours[1] - peer[1]) > 1e-6 * peer[1]:
        sys.exit("the two did not fit the same: their costs differ before the sixth digit")


def csv_reader(build, scratch, rounds, rows=5_000_000):
    """A long log, all columns into memory: ours against others' readers, a process each and in turn."""
    log = f"{scratch}/log.csv"
    subprocess.run([f"{build}/tests/bench/csv_bench", "write", log, str(rows)], check=True)
    one_core = dict(os.environ, POLARS_MAX_THREADS="1", OMP_NUM_THREADS="1")
    peers = {}
    for name in ("pandas", "polars", "pyarrow"):
        try:
            importlib.import_module(name)
        except ImportError as reason:
            print(f"{name} is left out: {reason}")
            continue
        command = [sys.executable, f"{HERE}/peer/read_csv.py", name, log]
        peers[name] = command, None
        if name != "pandas":  # which has one thread
            peers[f"{name} on one core"] = command, one_core

    def row(command, environment=None):
        pinned = ["taskset", "-c", "0"] if environment else []
        out = subprocess.run(pinned + command, check=True, capture_output=True, text=True, env=environment)
        return [float(x) for x in out.stdout.split()]

    ours = [f"{build}/tests/bench/csv_bench", "read", log]
    read = {"ours": [], "ours on one core": [], **{name: [] for name in peers}}
    for _ in range(rounds):
        read["ours"].append(row(ours))
        read["ours on one core"].append(row(ours, one_core))
        for name, peer in peers.items():
            read[name].append(row(*peer))
    os.remove(log)
    megabytes = read["ours"][0][4]
    print(f"CSV of {rows:,} rows and 4 columns, {megabytes:.0f} MB, all into memory:")
    for name, runs in read.items():
        seconds = sorted(r[0] for r in runs)
        basis = read["ours on one core" if name.endswith("one core") else "ours"]
        ratio = statistics.median(r[0] for r in runs) / statistics.median(r[0] for r in basis)
        print(f"  {name}: {megabytes / statistics.median(seconds):.0f} MB/s ({seconds[0]:.2f} to "
              f"{seconds[-1]:.2f} s), peak memory {runs[0][3]:.0f} MB"
              + ("" if name.startswith("ours") else f"; ours is {ratio:.1f} times faster"))
        if runs[0][1] != read["ours"][0][1] or abs(runs[0][2] / read["ours"][0][2] - 1) > 1e-9:
            sys.exit(f"{name} did not read the same")


def without_drawings(scenario, scratch):
    """A copy that names no robot description: the peer draws no scenes."""
    with open(scenario) as lines:
        kept = [line for line in lines if not line.startswith("description")]
    copy = f"{scratch}/scenario.toml"
    with open(copy, "w") as out:
        out.writelines(kept)
    return copy


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build")
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    build = os.path.abspath(options.build)
    program = f"{build}/src/tribolog"
    peer = [sys.executable, "run.py"]
    integrator(build)
    print_model_ratios(build)
    with tempfile.TemporaryDirectory() as scratch:
        csv_reader(build, scratch, options.rounds)
        loop_fit(build, scratch, options.rounds)
        scenario = without_drawings(f"{ROOT}/examples/paper/scenario.toml", scratch)

        def ours_whole():
            a = timed([program, "simulate", scenario, "-o", f"{scratch}/ours"])
            return a + timed([program, "report", f"{scratch}/ours/dataset.toml", "-o",
                              f"{scratch}/ours/report.html"])

        def peer_whole():
            return timed(peer + [f"{scratch}/peer"], cwd=f"{HERE}/peer")

        pair("whole run, simulate to report", ours_whole, peer_whole, options.rounds)
        pair("22 figures", lambda: timed([f"{build}/tests/bench/figures_bench"]),
             lambda: timed([sys.executable, "draw_22.py", f"{scratch}/peer"], cwd=f"{HERE}/peer"),
             options.rounds)
        peaks = [peak_memory_mb([program, "report", f"{scratch}/ours/dataset.toml", "-o",
                                 f"{scratch}/ours/report.html"]) for _ in range(3)]
    print(f"peak memory of a report, all its processes together: {max(peaks):.0f} MB")


if __name__ == "__main__":
    main()
