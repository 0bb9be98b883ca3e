"""SciPy's odeint on the micro-oscillation: one line each of rate, -log10(rtol), ns a sample, error."""

import time

import numpy as np

from joint import bristle

W = 2 * np.pi


def run(rate, rtol):
    t = np.arange(int(2 * rate) + 1) / rate
    start = time.perf_counter()
    z = bristle(t, lambda x: 0.01 * W * np.cos(W * x), np.arange(0.25, 2, 0.5), rtol=rtol)
    return z, 1e9 * (time.perf_counter() - start) / len(t)


for rate in (10_000, 100_000):
    reference, _ = run(rate, 1e-12)
    for digits in (6, 8, 10):
        z, ns = run(rate, 10.0**-digits)
        print(rate, digits, ns, np.max(np.abs(z - reference)) / np.max(np.abs(reference)))
