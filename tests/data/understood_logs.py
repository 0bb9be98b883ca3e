#!/usr/bin/env python3
"""How many raw logs of real robots `tribolog init` understands, and what is left to edit.

  python3 tests/data/understood_logs.py build/src/tribolog SETS

SETS has a folder for each robot with `expected.json` (an engineer's call of init: `files`, `arguments`) and `case_1.toml`, the
right manifest. Options are given behind the logs and in front of them. An edit: a key of [joint], [effort] or [columns]
that differs, or a role whose number of recordings does.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib


def keys_of(manifest):
    """What has to be right: {place: value}."""
    joint = manifest.get("joint", (manifest.get("joints") or [{}])[0])
    keys = {("joint", key): joint.get(key) for key in ("gear_ratio", "gravity")}
    effort = manifest.get("effort", {})
    keys.update({("effort", key): effort.get(key) for key in ("kind", "side", "torque_constant_Nm_A", "sign")})
    columns = dict(manifest.get("columns", {}))
    for recording in manifest.get("recording", []):
        for name, column in recording.get("columns", {}).items():
            columns.setdefault(name, column)
    for name in ("time", "angle", "effort"):
        for key in ("name", "unit", "side", "sign", "rate_Hz"):
            keys[(name, key)] = columns.get(name, {}).get(key)
    return keys


def edits(proposed, right):
    mine, wanted = keys_of(proposed), keys_of(right)
    count = sum(mine[key] != wanted[key] for key in wanted if wanted[key] is not None or mine[key] not in (None, 1, "joint"))
    roles = [collections.Counter(one.get("role") for one in m.get("recording", [])) for m in (proposed, right)]
    return count + sum(1 for role in set(roles[0]) | set(roles[1]) if roles[0][role] != roles[1][role])


def main():
    program, sets = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    understood = collections.Counter()
    total = 0
    print("| set | options behind | options in front | edits | first words of a refusal |\n|---|---|---|---|---|")
    for folder in sorted(p for p in sets.iterdir() if (p / "expected.json").exists()):
        call = json.loads((folder / "expected.json").read_text())["init"]
        right = tomllib.loads((folder / "case_1.toml").read_text())
        row, words, count = [], "", None
        for order in ("behind", "in front"):
            with tempfile.TemporaryDirectory() as scratch:
                made = pathlib.Path(scratch) / "m.toml"
                logs, options = call["files"], call["arguments"]
                parts = [*logs, *options] if order == "behind" else [*options, *logs]
                done = subprocess.run([program, "-q", "init", *parts, "-o", made], cwd=folder, capture_output=True, text=True)
                row.append("understood" if made.exists() else f"exit {done.returncode}")
                understood[order] += made.exists()
                if made.exists():
                    count = edits(tomllib.loads(made.read_text()), right)
                else:
                    words = " ".join(done.stderr.split())[:120]
        total += count or 0
        print(f"| {folder.name} | {row[0]} | {row[1]} | {'–' if count is None else count} | {words} |")
    print(f"\nunderstood with options behind the logs {understood['behind']}, in front {understood['in front']}; edits {total}")


main()
