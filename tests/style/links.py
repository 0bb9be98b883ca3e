#!/usr/bin/env python3
"""Every relative link and picture of the Markdown pages leads to a file, and every anchor to a heading.

  links.py [ROOT]

Looks at the pages at ROOT, in docs/ and in examples/. Prints what is wrong; exit status 1 if anything is.
Links into the network are not followed."""

import pathlib
import re
import sys


def pages_of(root):
    return [page for pattern in ("*.md", "docs/*.md", "examples/*/*.md") for page in sorted(root.glob(pattern))]


def prose_lines(text):
    """Numbered lines outside of code blocks, without code in them."""
    is_code = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            is_code = not is_code
        elif not is_code:
            yield number, re.sub(r"`[^`]*`", lambda code: "`" + "x" * (len(code[0]) - 2) + "`", line)


def anchors_of(text):
    """As GitHub makes them of the headings; of equal ones the second ends in -1."""
    anchors, counts = set(), {}
    is_code = False
    for line in text.splitlines():
        if line.startswith("```"):
            is_code = not is_code
        heading = re.match(r"#{1,6} +(.*)", line)
        if is_code or not heading:
            continue
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).strip().lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        count = counts.get(anchor, 0)
        counts[anchor] = count + 1
        anchors.add(f"{anchor}-{count}" if count else anchor)
    return anchors


def faults_of(page, root):
    # A link's words may go on in the next line: lines are joined, and a fault names the link's.
    lines = list(prose_lines(page.read_text(encoding="utf-8")))
    text = "\n".join(line for _, line in lines)
    for link in re.finditer(r"\]\(([^)\s]+)\)", text):
        number = lines[text.count("\n", 0, link.start())][0]
        target = link[1]
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        where = f"{page.relative_to(root)}:{number}: "
        if not file.exists():
            yield f"{where}{target}: there is no such file"
        elif root not in file.parents:
            yield f"{where}{target}: is outside of the project"
        elif anchor and file.suffix == ".md" and anchor not in anchors_of(file.read_text(encoding="utf-8")):
            yield f"{where}{target}: {path or page.name} has no such heading"


def main(root):
    faults = [fault for page in pages_of(root) for fault in faults_of(page, root)]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults or not pages_of(root) else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()))
