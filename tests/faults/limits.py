#!/usr/bin/env python3
"""Every command within limits of memory, file size, open files, processor time, and without a
temporary folder.

  limits.py PROGRAM [--quick]

No crash, a documented status, nothing left behind, and outputs that are all old or all new. Prints a
table; status 1 where a promise is broken.
"""

import os
import resource
import signal
import sys

from workspace import COMMANDS, Table, Workspace, files_in, leftovers, every_case

DOCUMENTED = {0, 1, 2, 3, 4, 5, 6, 70, 128 + signal.SIGXCPU}
NOT_LOADED = 127  # the system's loader had no room for the libraries


def bounded(kind, value, hard=None):
    return lambda: resource.setrlimit(kind, (value, value if hard is None else hard))


def some_of(few, more):
    return few + (more if every_case() else ())


def limits(few):
    """Name, value to show, what to do before the program starts, environment."""
    megabyte = 1 << 20
    for MB in (some_of((100,), (400,)) if few else (20, 50, 100, 150, 200, 300, 400, 600, 1000)):
        yield "memory", f"{MB} MB", bounded(resource.RLIMIT_AS, MB * megabyte), {}
    for kB in (some_of((64,), (0,)) if few else (0, 1, 16, 64, 256, 1024)):
        yield "file size", f"{kB} kB", bounded(resource.RLIMIT_FSIZE, 1024 * kB), {}
    for files in (some_of((12,), (3,)) if few else (0, 3, 4, 5, 6, 8, 10, 12, 16, 24)):
        yield "open files", files, bounded(resource.RLIMIT_NOFILE, files), {}
    for seconds in ((1,) if few else (1, 2, 3)):
        yield "processor", f"{seconds} s", bounded(resource.RLIMIT_CPU, seconds, seconds + 5), {}
    yield "temporary folder", "missing", None, {"TMPDIR": "/no/such/folder"}
    yield "temporary folder", "unwritable", None, {"TMPDIR": "/proc"}


def faults_of(command, done, before, after):
    faults = []
    if done.status == NOT_LOADED and "shared librar" in done.err:
        pass
    elif done.status not in DOCUMENTED:
        faults.append(f"status {done.status}")
    if leftovers(after):
        faults.append(f"left behind: {leftovers(after)}")
    if done.status not in (0, 1) and not done.err and not done.out:
        faults.append("no word")
    changed = {name.split("/")[0] for name in {*before, *after}
               if before.get(name) != after.get(name)}
    if "internal error" in done.err:
        faults.append("calls it a fault of the program")
    kept = "kept: " in done.err
    if done.status not in (0, 1, 5) and changed and not kept:
        faults.append(f"changed: {sorted(changed)}")
    if done.status in (0, 5) and command.writes and changed != set(command.writes):
        faults.append(f"changed alone: {sorted(changed)}")
    return faults


def main():
    quick = "--quick" in sys.argv
    space = Workspace(sys.argv[1])
    table = Table("Limits", ["command", "limit", "of", "status", "words"])
    for command in COMMANDS:
        if quick and (command.slow or command.draws):
            continue
        for name, value, limit, environment in limits(quick or command.slow):
            directory = space.copy()
            before = files_in(directory)
            done = space.run(command.line, directory, preexec_fn=limit, environment=environment)
            faults = faults_of(command, done, before, files_in(directory))
            words = done.words or done.err.strip().rpartition("\n")[2]
            table.add([command, name, value, done.status, words[:160] if done.status else ""],
                      faults)
    return 1 if table.end() else 0


if __name__ == "__main__":
    sys.exit(main())
