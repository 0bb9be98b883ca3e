"""22 figures with matplotlib: the eleven of the paper's joint, twice. usage: draw_22.py DIRECTORY
(of a run of run.py)"""

import sys

from figures import draw
from run import read_logs
from stages import identify

recordings = read_logs(sys.argv[1])
result = identify(recordings)
assert sum(len(draw(recordings, result)) for _ in range(2)) == 22
