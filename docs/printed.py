#!/usr/bin/env python3
"""Puts into the pages of docs/ what the program prints of itself.

  python3 docs/printed.py TRIBOLOG            rewrites the parts between `<!-- printed by COMMAND -->`
                                              and `<!-- end of it -->`
  python3 docs/printed.py TRIBOLOG --check    exit status 1 where a page has something else there
"""

import pathlib
import re
import shlex
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parent
PART = re.compile(r"(<!-- printed by (tribolog [^>]*?) -->\n)(.*?)(<!-- end of it -->)", re.DOTALL)


def with_printed_parts(text, program):
    """The page's text with what each command prints now."""
    def printed(part):
        words = [program] + shlex.split(part[2])[1:]
        output = subprocess.run(words, capture_output=True, text=True, check=True).stdout
        return f"{part[1]}\n{output.strip()}\n\n{part[4]}"

    return PART.sub(printed, text)


def main(program, check):
    stale = []
    parts = 0
    for page in sorted(DOCS.glob("*.md")):
        text = page.read_text(encoding="utf-8")
        parts += len(PART.findall(text))
        new = with_printed_parts(text, program)
        if new == text:
            continue
        stale.append(page.name)
        if not check:
            page.write_text(new, encoding="utf-8")
    if parts == 0:
        sys.exit("no page has a printed part")
    if check and stale:
        sys.exit(f"not what the program prints: {', '.join(stale)}; python3 docs/printed.py TRIBOLOG mends it")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    main(sys.argv[1], len(sys.argv) == 3)
