"""A log by another reader, in a process of its own: all columns into memory.

usage: read_csv.py pandas|polars|pyarrow LOG.csv; prints seconds of the reading alone, rows, the sum
of all values, and the peak memory in MB. How many threads it takes is up to the environment
(POLARS_MAX_THREADS, OMP_NUM_THREADS).
"""

import resource
import sys
import time


def with_pandas(log):
    import pandas
    return lambda: pandas.read_csv(log, engine="c"), lambda table: table.to_numpy()


def with_polars(log):
    import polars
    return lambda: polars.read_csv(log), lambda table: table.to_numpy()


def with_pyarrow(log):
    from pyarrow import csv
    return lambda: csv.read_csv(log), lambda table: table.to_pandas().to_numpy()


read, values_of = {"pandas": with_pandas, "polars": with_polars, "pyarrow": with_pyarrow}[
    sys.argv[1]](sys.argv[2])
begin = time.perf_counter()
table = read()
seconds = time.perf_counter() - begin
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
print(f"{seconds:.6f} {len(table)} {values_of(table).sum():.17g} {peak:.1f}")
