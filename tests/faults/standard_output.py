#!/usr/bin/env python3
"""Every command that prints, with a standard output that takes nothing.

  standard_output.py PROGRAM [--quick]

Prints a table; status 1 where a promise is broken.
"""

import os
import subprocess
import sys

from disks import SmallDisk, cannot_mount
from workspace import COMMANDS, Table, Workspace, files_in, leftovers, every_case

FAILED = "standard output: cannot write: "


def to_full_device(space, line, directory):
    with open("/dev/full", "wb") as full:
        return space.run(line, directory, stdout=full)


def to_closed_pipe(space, line, directory):
    reading, writing = os.pipe()
    os.close(reading)
    try:
        return space.run(line, directory, stdout=writing)
    finally:
        os.close(writing)


def to_full_disk(space, line, directory):
    with SmallDisk(space, 0) as disk, open(os.path.join(disk.path, "out"), "wb") as file:
        return space.run(line, directory, stdout=file)


def to_nothing(space, line, directory):
    return space.run(line, directory, preexec_fn=lambda: os.close(1))


def faults_of(done, usual, reason, files):
    faults = []
    if reason is None:
        if done.status != usual.status or done.words != usual.words:
            faults.append(f"status {done.status} instead of {usual.status}")
    else:
        if done.status != 4:
            faults.append("not status 4")
        if done.err.count("error:") - usual.err.count("error:") != 1 or FAILED + reason not in done.err:
            faults.append("not one clear line")
    if leftovers(files):
        faults.append(f"left behind: {leftovers(files)}")
    return faults


def main():
    quick = "--quick" in sys.argv
    space = Workspace(sys.argv[1])
    streams = [("/dev/full", to_full_device, "No space left on device"),
               ("closed pipe", to_closed_pipe, None), (">&-", to_nothing, "it is closed")]
    if quick and not every_case():
        del streams[1:]
    if cannot_mount():
        print(f"full tmpfs left out: {cannot_mount()}")
    else:
        streams.append(("full tmpfs", to_full_disk, "No space left on device"))
    table = Table("Standard output that takes nothing",
                  ["command", "usual"] + [name for name, _, _ in streams] + ["words"])
    for command in COMMANDS:
        if quick and (command.slow or command.draws):
            continue
        usual = space.run(command.line, space.copy())
        statuses, faults, words = [], [], ""
        if not usual.out:
            faults.append("prints nothing")
        for name, run, reason in streams:
            directory = space.copy()
            done = run(space, command.line, directory)
            statuses.append(done.status)
            words = words or done.words
            faults += [f"{name}: {one}" for one in
                       faults_of(done, usual, reason, files_in(directory))]
        table.add([command, usual.status, *statuses, words], faults)
    return 1 if table.end() else 0


if __name__ == "__main__":
    sys.exit(main())
