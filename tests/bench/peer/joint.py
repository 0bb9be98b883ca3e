"""The paper's joint in Python: the same scenario as examples/paper/scenario.toml, with SciPy's
integrator for the bristle equation."""

import numpy as np
from scipy.integrate import odeint

GEAR = 100.0
Q_PEAK = np.deg2rad(-22.23187)
GRAVITY_MOTOR = 3.88318571
DISTANCE = 0.4
MASS = GRAVITY_MOTOR * GEAR / (9.81 * DISTANCE)
ARM_INERTIA = MASS * DISTANCE**2
MOTOR_INERTIA = 1e-4
LUGRE = dict(s0=465.42, s1=0.77080, s2=0.001, tc=0.60, ts=0.88437633, ws=5.0)
WAIBOER = dict(ta=0.8844, ws=5.0, da=0.7, cv=0.12, dv=0.6, c=1e6)
SPEEDS = [1, 1.5, 2, 3, 4, 5.5, 7.5, 10, 13, 17, 22, 30, 40, 55, 75, 100, 135, 180, 240, 300]


def waiboer(w, p=WAIBOER):
    a = np.abs(w)
    t = p["ta"] * np.exp(-((a / p["ws"]) ** p["da"])) + p["cv"] * a ** (1 - p["dv"])
    return 2 / np.pi * np.arctan(p["c"] * w) * t


def bristle(t, w_of_t, reversals, p=LUGRE, rtol=1e-8):
    """z(t) from z = 0; odeint, started anew at each reversal (it steps over them otherwise)."""

    def rate(z, time):
        w = w_of_t(time)
        g = (p["tc"] + (p["ts"] - p["tc"]) * np.exp(-((w / p["ws"]) ** 2))) / p["s0"]
        return w - abs(w) * z / g

    z = np.zeros_like(t)
    start, z0 = 0, 0.0
    for r in list(reversals) + [t[-1] + 1]:
        stop = np.searchsorted(t, r, side="right")
        times = np.concatenate(([t[start]], t[start + 1 : stop], [min(r, t[-1])]))
        solved = odeint(rate, z0, times, rtol=rtol, atol=rtol * 1e-5, hmax=5e-3, h0=1e-6)[:, 0]
        z[start:stop] = solved[: stop - start]
        if stop >= len(t):
            break
        z0, start = solved[-1], stop - 1
    return z


def travel(start, end, speed, acceleration, rate=1000.0, rest=0.1):
    """There and back with raised-cosine ramps: t, q, dq, ddq."""
    ramp = speed * np.pi / (2 * acceleration)
    cruise = (abs(end - start) - speed * ramp) / speed
    stroke = 2 * ramp + cruise
    t = np.arange(0, 3 * rest + 2 * stroke, 1 / rate)
    sign = np.sign(end - start)

    def one(x):
        x = np.clip(x, 0, stroke)
        tail = np.minimum(x, stroke - x)
        inside = np.minimum(tail, ramp)
        v = speed / 2 * (1 - np.cos(np.pi * inside / ramp))
        a = speed * np.pi / (2 * ramp) * np.sin(np.pi * inside / ramp) * np.sign(stroke / 2 - x)
        s = speed / 2 * (inside - ramp / np.pi * np.sin(np.pi * inside / ramp))
        way = np.where(x < ramp, s, speed * ramp / 2 + speed * (x - ramp))
        way = np.where(x > ramp + cruise, abs(end - start) - s, way)
        return way, v, a

    w1, v1, a1 = one(t - rest)
    w2, v2, a2 = one(t - 2 * rest - stroke)
    return t, start + sign * (w1 - w2), sign * (v1 - v2), sign * (a1 - a2)


def torque(q, ddq, friction):
    load = MASS * 9.81 * DISTANCE * np.cos(q - Q_PEAK)
    return MOTOR_INERTIA * GEAR * ddq + friction + (ARM_INERTIA * ddq + load) / GEAR


def simulate():
    """All recordings as name -> array with columns t, q, dq, torque[, z, dz]."""
    out = {}
    for name, lo, hi, v in (("rough_sweep", -80, 60, 2), ("precise_sweep", -23.2, -21.2, 0.1)):
        t, q, dq, ddq = travel(np.deg2rad(lo), np.deg2rad(hi), np.deg2rad(v), 1.0)
        out[name] = np.column_stack([t, q, dq, torque(q, ddq, waiboer(GEAR * dq))])
    a, w = 1e-4, 2 * np.pi
    t = np.arange(5001) / 1000.0
    q, dq, ddq = Q_PEAK + a * np.sin(w * t), a * w * np.cos(w * t), -a * w * w * np.sin(w * t)
    z = bristle(t, lambda x: GEAR * a * w * np.cos(w * x), np.arange(0.25, 5, 0.5))
    p, m = LUGRE, GEAR * dq
    g = (p["tc"] + (p["ts"] - p["tc"]) * np.exp(-((m / p["ws"]) ** 2))) / p["s0"]
    dz = m - np.abs(m) * z / g
    friction = p["s0"] * z + p["s1"] * dz + p["s2"] * m
    out["oscillation"] = np.column_stack([t, q, dq, torque(q, ddq, friction), z, dz])
    for i, speed in enumerate(SPEEDS):
        v = speed / GEAR
        plateau = min(np.deg2rad(60), v * 5.0)
        half = plateau / 2 + v * v * np.pi / (2 * 20.0) / 2
        t, q, dq, ddq = travel(Q_PEAK - half, Q_PEAK + half, v, 20.0)
        out[f"constant_speed_{i + 1:02}"] = np.column_stack(
            [t, q, dq, torque(q, ddq, waiboer(GEAR * dq))]
        )
    return out
