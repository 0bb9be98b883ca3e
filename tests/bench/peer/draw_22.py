"""22 figures with matplotlib: the eleven of the paper's joint, twice. usage: draw_22.py DIRECTORY
(of a run of run.py)"""

import os
import sys

import numpy as np

from figures import draw
from stages import identify

directory = sys.argv[1]
names = sorted(f[:-4] for f in os.listdir(directory) if f.endswith(".csv"))
recordings = {n: np.loadtxt(f"{directory}/{n}.csv", delimiter=",") for n in names}
result = identify(recordings)
assert sum(len(draw(recordings, result)) for _ in range(2)) == 22
