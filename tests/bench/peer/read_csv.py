"""pandas' C reader on a log, in a process of its own.

usage: read_csv.py LOG.csv; prints seconds of the reading alone, rows, the sum of all values, and the
peak memory in MB.
"""

import resource
import sys
import time

import pandas

begin = time.perf_counter()
table = pandas.read_csv(sys.argv[1], engine="c")
seconds = time.perf_counter() - begin
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(f"{seconds:.6f} {len(table)} {table.to_numpy().sum():.17g} {peak:.1f}")
