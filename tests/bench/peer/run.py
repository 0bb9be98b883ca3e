"""The whole run in Python: simulate, write CSV, read CSV, identify, draw, one HTML file.
usage: run.py DIRECTORY [simulate|identify|report]    one part of it; identify and report read logs"""

import base64
import json
import os
import sys

import numpy as np

from joint import simulate
from stages import identify


def write_logs(directory):
    os.makedirs(directory, exist_ok=True)
    for name, r in simulate().items():
        np.savetxt(f"{directory}/{name}.csv", r, delimiter=",", fmt="%.17g",
                   header="t_s,q_rad,dq_rad_s,torque_Nm" + (",z,dz" if r.shape[1] > 4 else ""))


def read_logs(directory):
    names = sorted(f[:-4] for f in os.listdir(directory) if f.endswith(".csv"))
    return {n: np.loadtxt(f"{directory}/{n}.csv", delimiter=",") for n in names}


def write_numbers(directory, result):
    with open(f"{directory}/calibration.json", "w") as f:
        json.dump({"masses": result["masses"], "rms": result["rms"]}, f, indent=2)
    print("midline", result["masses"]["midline"], "kg; q_peak error", result["error"], "rad")


def write_report(directory, pictures):
    with open(f"{directory}/report.html", "w") as f:
        f.write("<!doctype html><title>peer</title>")
        for name, data in pictures.items():
            f.write(f'<img alt="{name}" src="data:image/png;base64,'
                    f'{base64.b64encode(data).decode()}">')


def main(directory, part="all"):
    if part in ("all", "simulate"):
        write_logs(directory)
    if part == "simulate":
        return
    recordings = read_logs(directory)
    result = identify(recordings)
    write_numbers(directory, result)
    if part != "identify":
        from figures import draw  # matplotlib, which the other parts do not wait for
        write_report(directory, draw(recordings, result))


if __name__ == "__main__":
    main(*sys.argv[1:])
