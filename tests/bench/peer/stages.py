"""The stages in NumPy and SciPy, less than ours does: no plateau search, no intervals, no loop fit."""

import numpy as np
from scipy.optimize import least_squares

from joint import GEAR, Q_PEAK, waiboer


def plateau(r, share=0.99):
    v = np.abs(r[:, 2])
    return v > share * v.max()


def fit_sweep(r):
    k = plateau(r)
    q, torque, up = r[k, 1], r[k, 3], r[k, 2] > 0
    x = np.column_stack([np.cos(q), np.sin(q), up, ~up]).astype(float)
    b, c, *_ = np.linalg.lstsq(x, torque, rcond=None)[0]
    return np.arctan2(c, b), np.hypot(b, c)


def loop_points(r):
    z, dz, torque = r[:, 4], r[:, 5], r[:, 3]
    n = 1000
    b = np.flatnonzero((z[:-1] >= 0) & (z[1:] < 0))[0]
    c = np.argmax(z[:b])
    f = c + np.argmin(dz[c:b])
    d = b + np.argmin(z[b : b + n])
    e = d + np.argmax(dz[d : d + n // 2])
    return {name: torque[i] for name, i in zip("ABCDEF", (0, b, c, d, e, f))}


def identify(recordings):
    q_peak, gravity = fit_sweep(recordings["rough_sweep"])
    points = loop_points(recordings["oscillation"])
    loop = recordings["oscillation"]
    candidates = dict(points)
    candidates["midline"] = np.trapz(loop[1000:5001, 3], loop[1000:5001, 0]) / 4.0
    candidates["sweep"] = gravity
    masses = {k: GEAR * t / (9.81 * 0.5) for k, t in candidates.items()}
    speeds, torques, cosines = [], [], []
    for name, r in recordings.items():
        if not name.startswith("constant_speed"):
            continue
        k = plateau(r)
        for sign in (-1, 1):
            part = r[k & (np.sign(r[:, 2]) == sign)]
            speeds.append(GEAR * part[:, 2].mean())
            torques.append(part[:, 3].mean())
            cosines.append(np.cos(part[:, 1] - q_peak).mean())
    order = np.argsort(speeds)
    speeds, torques, cosines = (np.array(x)[order] for x in (speeds, torques, cosines))
    curves = {k: torques - t * cosines for k, t in candidates.items()}
    reference = waiboer(speeds)
    percent = {k: 100 * (c - reference) / torques for k, c in curves.items()}
    rms = {k: float(np.sqrt(np.mean(p**2))) for k, p in percent.items()}

    def residual(p):
        ta, ws, da, cv, ex = np.exp(p)
        w = np.abs(speeds)
        return ta * np.exp(-((w / ws) ** da)) + cv * w**ex - np.abs(curves["midline"])

    fit = least_squares(residual, np.log([0.8, 10, 1, 0.1, 0.5]))
    return dict(q_peak=q_peak, gravity=gravity, points=points, masses=masses, speeds=speeds,
                curves=curves, reference=reference, percent=percent, rms=rms,
                waiboer=np.exp(fit.x), error=abs(q_peak - Q_PEAK))
