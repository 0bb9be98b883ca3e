"""The loop fit with scipy.optimize.least_squares: the same one-pass model, start and data as ours.

usage: loop_fit.py DATA.csv; prints milliseconds of a fit (median), its cost, its evaluations.

At micro-speed g is one level, and a step of the bristle equation is exact in the way that it goes:
z1 = h + exp(-|way|/g) (z0 - h). The ways are known beforehand (analytic motion, split at each
reversal), so an evaluation is one vectorised exp and a recursion, which scipy.signal.lfilter cannot
carry (its coefficients change from step to step): a plain loop over Python floats, faster than one
over NumPy scalars. Derivatives are least_squares' default, forward differences; so is its method.
"""

import statistics
import sys
import time

import numpy as np
from scipy.optimize import least_squares

t, w, dw, torque = np.loadtxt(sys.argv[1], delimiter=",", unpack=True)
A, W, Q = 0.01, 2 * np.pi, 0.01 / 100

# Nodes: the samples and the reversals between them.
turns = (np.arange(8) + 0.5) / 2
turns = turns[(turns > t[0]) & (turns < t[-1])]
nodes = np.union1d(t, turns)
at_sample = np.isin(nodes, t)
way = np.diff(A * np.sin(W * nodes))
distance, forward = np.abs(way), way > 0
cosine = np.cos(Q * np.sin(W * t))
speed = np.abs(w)


def residual(p):
    s0, ts = np.exp(p[0]), np.exp(p[1])
    g = ts / s0
    decay = np.exp(-distance / g)
    push = np.where(forward, g, -g) * (1 - decay)
    z, path = 0.0, [0.0]
    append = path.append
    for d, h in zip(decay.tolist(), push.tolist()):
        z = d * z + h
        append(z)
    z = np.array(path)[at_sample]
    dz = w - speed * z / g
    return p[5] * cosine + s0 * z + p[2] * dz + p[3] * w + p[4] * dw - torque


start = np.array([np.log(530.0), np.log(0.9), 0.5, 0.0, 0.0, 3.9])
times = []
for _ in range(5):
    begin = time.perf_counter()
    fit = least_squares(residual, start, x_scale="jac", ftol=1e-12, xtol=1e-12, gtol=1e-12)
    times.append(1e3 * (time.perf_counter() - begin))
print(statistics.median(times), fit.cost, fit.nfev)
