#!/usr/bin/env python3
"""Every command that writes, onto file systems with 0, 100, ... 1000 kB of room.

  full_disk.py PROGRAM [--quick]

Status 0 or 4; with 4 every file is, byte for byte, what it was before, or the message says which are
kept. Prints a table; status 1 where a promise is broken, SKIPPED where nothing can be mounted.
"""

import os
import sys

from disks import SmallDisk, cannot_mount
from workspace import ARCHIVED, COMMANDS, Table, Workspace, files_in, leftovers

OLD = b"what was there before\n"


def old_files(space, command):
    """What the command would replace."""
    files = [(name, OLD) for name in command.writes if "." in name and not name.endswith(".tribolog")]
    if ARCHIVED in command.line:
        with open(os.path.join(space.base, "a.tribolog"), "rb") as archive:
            files.append(("a.tribolog", archive.read()))
    return files


def faults_of(command, done, before, after):
    faults = []
    changed = sorted(name for name in {*before, *after} if before.get(name) != after.get(name))
    if done.status not in (0, 4):
        faults.append(f"status {done.status}")
    if leftovers(after):
        faults.append(f"left behind: {leftovers(after)}")
    if done.status == 0 and not changed:
        faults.append("nothing was written")
    if done.status != 0 and done.err.count("error:") != 1:
        faults.append("not one clear line")
    kept = done.words.partition("; kept: ")[2]
    if done.status != 0 and changed and not (changed[0].endswith(".tribolog") and
                                             len(changed) == 1 and "archive" in kept):
        faults.append(f"changed: {changed}")
    if done.status != 0 and kept and not changed:
        faults.append("nothing is kept")
    return faults


def verified(space, disk):
    done = space.run("archive verify --archive a.tribolog", disk.path)
    return [] if done.status == 0 else [f"the archive: {done.err.strip()}"]


def main():
    if cannot_mount():
        print(f"SKIPPED: {cannot_mount()}")
        return 0
    quick = "--quick" in sys.argv
    sizes_kB = (0, 100, 700) if quick else range(0, 1001, 100)
    space = Workspace(sys.argv[1])
    table = Table("Disks without room", ["command", "free kB", "status", "files before",
                                         "files after", "words"])
    for command in COMMANDS:
        if not command.writes or quick and (command.slow or command.draws):
            continue
        for free_kB in sizes_kB:
            with SmallDisk(space, free_kB, old_files(space, command)) as disk:
                before = files_in(disk.path)
                done = space.run(command.line, space.copy(), out=disk.path)
                after = files_in(disk.path)
                faults = faults_of(command, done, before, after)
                if ARCHIVED in command.line:
                    faults += verified(space, disk)
            same = sum(before.get(name) == after.get(name) for name in before)
            table.add([command, free_kB, done.status, len(before) - 1,
                       f"{len(after) - 1}, {same - 1} unchanged",
                       done.words.replace(disk.path + "/", "")], faults)
    return 1 if table.end() else 0


if __name__ == "__main__":
    sys.exit(main())
