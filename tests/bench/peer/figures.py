"""Figures 11 and 13 to 22 with matplotlib, 1600 px wide, antialiased, the same content as ours."""

import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from joint import Q_PEAK


def png(fig):
    out = io.BytesIO()
    fig.savefig(out, dpi=100, format="png")
    plt.close(fig)
    return out.getvalue()


def axes(rows=1, height=10):
    fig, ax = plt.subplots(rows, 1, figsize=(16, height))
    return fig, np.atleast_1d(ax)


def motion(r):
    fig, ax = axes(3, 12)
    for a, column, label in zip(ax, (1, 2, 3), ("q [rad]", "dφ/dt [rad/s]", "T [N·m]")):
        a.plot(r[:, 0], r[:, column])
        a.set_ylabel(label)
        a.grid(True)
    ax[-1].set_xlabel("t [s]")
    return png(fig)


def torque_of_angle(r, q_peak):
    fig, (a,) = axes()
    for up in (True, False):
        k = (r[:, 2] > 0) == up
        a.plot(np.rad2deg(r[k, 1]), r[k, 3], label="rising" if up else "falling")
    a.axvline(np.rad2deg(q_peak), ls="--")
    a.set_xlabel("q [°]")
    a.set_ylabel("T [N·m]")
    a.legend()
    a.grid(True)
    return png(fig)


def loop(r, column, label, points):
    fig, ax = axes(2, 14)
    x = 1e6 * (r[:, 1] - Q_PEAK)
    ax[0].plot(x, r[:, column])
    ax[1].plot(r[:, 0], r[:, column])
    for name, value in points.items():
        i = int(np.argmin(np.abs(r[:, 3] - value)))
        ax[0].annotate(name, (x[i], r[i, column]))
        ax[1].annotate(name, (r[i, 0], r[i, column]))
    ax[0].set_xlabel("q - q_peak [µrad]")
    ax[1].set_xlabel("t [s]")
    for a in ax:
        a.set_ylabel(label)
        a.grid(True)
    return png(fig)


def curves(speeds, many, label, extra=None):
    fig, (a,) = axes()
    for name, y in many.items():
        a.plot(speeds, y, marker="o", label=name)
    if extra is not None:
        a.plot(speeds, extra, "k--", label="reference")
    a.set_xlabel("dφ/dt [rad/s]")
    a.set_ylabel(label)
    a.legend()
    a.grid(True)
    return png(fig)


def draw(recordings, result):
    rough, precise, osc = (recordings[k] for k in ("rough_sweep", "precise_sweep", "oscillation"))
    s, p = result["speeds"], result["points"]
    chosen = {k: result["curves"][k] for k in ("B", "midline")}
    return {
        "fig-11": motion(rough),
        "fig-13": torque_of_angle(rough, result["q_peak"]),
        "fig-14": torque_of_angle(precise, result["q_peak"]),
        "fig-15": loop(osc, 3, "T [N·m]", p),
        "fig-16": loop(osc, 4, "z [rad]", p),
        "fig-17": loop(osc, 5, "dz/dt [rad/s]", p),
        "fig-18": curves(s, result["curves"], "Tf [N·m]"),
        "fig-19": curves(s, result["curves"], "Tf [N·m]", result["reference"]),
        "fig-20": curves(s, result["percent"], "error [%]"),
        "fig-21": curves(s, chosen, "Tf [N·m]", result["reference"]),
        "fig-22": loop(osc, 3, "T [N·m]", {"B": p["B"]}),
    }
