#!/usr/bin/env python3
"""rooms.py finds what it is there for, in a small tree that is broken in one way after another."""

import os
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).with_name("rooms.py")
WHOLE = {
    "src/base/error.h": "#pragma once\n",
    "src/base/CMakeLists.txt": "tribolog_room(base\n  SOURCES error.cpp)\n",
    "src/base/error.cpp": '#include "base/error.h"\n',
    "src/joint/drive.h": '#pragma once\n#include "base/error.h"\n',
    "src/joint/drive.cpp": '#include "joint/drive.h"\n',
    "src/joint/CMakeLists.txt": "tribolog_room(joint\n  SOURCES drive.cpp\n  PUBLIC base)\n",
    "src/method/gravity/sweep.cpp": '#include "base/error.h"\n#include "joint/drive.h"\n',
    "src/method/gravity/CMakeLists.txt":
        "tribolog_room(method/gravity\n  SOURCES sweep.cpp\n  PRIVATE base joint)\n",
    "render/text/font.h": "#pragma once\n",
    "render/text/font.cpp": '#include "render/text/font.h"\n',
    "render/text/CMakeLists.txt": "tribolog_room(render/text\n  SOURCES font.cpp)\n",
}


def run(check, changes):
    with tempfile.TemporaryDirectory() as place:
        for name, text in {**WHOLE, **changes}.items():
            path = pathlib.Path(place, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([sys.executable, str(SCRIPT), check], text=True, capture_output=True,
                              env={**os.environ, "TRIBOLOG_ROOMS": place})
        return done.returncode, done.stdout


CASES = [
    ("circles", {}, 0, ""),
    ("lists", {}, 0, ""),
    # One room needs another that needs it; over three rooms; over render.
    ("circles", {"src/base/error.cpp": '#include "joint/drive.h"\n'}, 1, "base -> joint -> base"),
    ("circles", {"src/base/error.cpp": '#include "method/gravity/other.h"\n',
                 "src/method/gravity/other.h": ""}, 1, "a circle: base -> method/gravity -> base"),
    ("circles", {"src/base/error.cpp": '#include "render/text/font.h"\n',
                 "render/text/font.cpp": '#include "joint/drive.h"\n'}, 1, "render/text -> joint"),
    # What is not named, what is named in vain or in the wrong list, a source that is not listed.
    ("lists", {"src/joint/drive.cpp": '#include "render/text/font.h"\n'}, 1,
     "joint: includes render/text, which is not in its PRIVATE"),
    ("lists", {"src/joint/drive.h": "#pragma once\n"}, 1, "joint: names base in its PUBLIC"),
    ("lists", {"src/joint/gear.cpp": "\n"}, 1, "joint: gear.cpp is not among its SOURCES"),
    ("lists", {"src/other/gear.cpp": "\n"}, 1, "without a CMakeLists.txt"),
    ("lists", {"src/joint/drive.cpp": '#include "joint/drive.h"\nnamespace tribolog::gear {\n'}, 1,
     "stands in namespace tribolog::gear, not tribolog::joint"),
    # What another room defines may be named beforehand.
    ("lists", {"src/joint/drive.cpp": '#include "joint/drive.h"\n'
               "namespace tribolog::robot {\nstruct Arm;\n}\nnamespace tribolog::joint {\n"}, 0, ""),
    ("lists", {"src/joint/CMakeLists.txt": "add_library(joint drive.cpp)\n"}, 1, "makes no room"),
]
# The drawing of the small tree, as it should be, and where a box or an arrow is missing.
SVG = "".join(f"<title>{title}</title>" for title in (
    "house", "base", "joint", "method", "render", "joint&#45;&gt;base", "method&#45;&gt;joint"))


def drawing():
    return run("drawing", {})[1]


CASES += [
    ("drawn", {"docs/rooms.dot": drawing(), "docs/rooms.svg": SVG}, 0, ""),
    ("drawn", {"docs/rooms.dot": drawing(), "docs/rooms.svg": SVG.replace("method", "")}, 1,
     "rooms.svg does not show"),
    ("drawn", {"docs/rooms.dot": drawing().replace("joint ->", "method ->"),
               "docs/rooms.svg": SVG}, 1, "rooms.dot is not the house"),
    ("drawn", {}, 1, "rooms.dot is not the house"),
    # What needs base through joint already has no arrow of its own to it.
    ("drawing", {}, 0, "method -> joint;\n}"),
]

failed = 0
for check, changes, status, words in CASES:
    got, text = run(check, changes)
    if got != status or words not in text:
        failed += 1
        print(f"{check} {changes}: status {got}, not {status}; '{words}' expected in:\n{text}")
sys.exit(1 if failed else 0)
