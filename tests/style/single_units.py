#!/usr/bin/env python3
"""How each source file would be compiled by itself, of a build that compiles several at once.

  single_units.py BUILD     writes BUILD/single_units/compile_commands.json for what reads such a file,
                            and prints its folder"""

import json
import pathlib
import re
import sys


OF_SEVERAL = r" -Wno-(?:shadow|subobject-linkage)\b"  # what only a unit of several files needs
OF_GCC = r" --param=\S+"  # what other compilers do not know


def single(unit):
    """The unit; or one for each file that it includes, where CMake made it of several."""
    path = pathlib.Path(unit["directory"], unit["file"])
    files = [unit["file"]]
    if path.parent.name == "Unity":
        files = re.findall(r'^#include "(.+)"$', path.read_text(), flags=re.M)
    command = re.sub(OF_GCC, "", re.sub(OF_SEVERAL, "", unit["command"]))
    return [{**unit, "file": file, "command": command.replace(unit["file"], file)} for file in files]


def units_of(build):
    """All of the build's units, as compile_commands.json has them."""
    units = json.loads((build / "compile_commands.json").read_text())
    return [one for unit in units for one in single(unit)]


def main():
    build = pathlib.Path(sys.argv[1])
    made = build / "single_units"
    made.mkdir(exist_ok=True)
    (made / "compile_commands.json").write_text(json.dumps(units_of(build), indent=1))
    print(made)


if __name__ == "__main__":
    main()
