#!/usr/bin/env python3
"""docs/site.py makes one page of all pages that loads nothing and whose links lead somewhere.

Skips, saying so, where no Python has python3-markdown."""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def python_with_markdown():
    for python in (sys.executable, "/usr/bin/python3"):
        run = subprocess.run([python, "-c", "import markdown"], capture_output=True, check=False)
        if run.returncode == 0:
            return python
    return None


python = python_with_markdown()
if python is None:
    print("SKIPPED: python3-markdown is not installed")
    sys.exit(0)
with tempfile.TemporaryDirectory() as scratch:
    output = pathlib.Path(scratch) / "tribolog.html"
    subprocess.run([python, ROOT / "docs/site.py", "-o", output], check=True)
    page = output.read_text(encoding="utf-8")

faults = []
sections = set(re.findall(r'<section id="([^"]*)">', page))
faults += [f"{file.name} is not in it" for file in (ROOT / "docs").glob("*.md")
           if file.name != "README.md" and file.stem not in sections]
faults += [f"it loads {source[:60]}" for source in re.findall(r'(?:src|data)="([^"]*)"', page)
           if not source.startswith("data:")]
faults += [f"it has <{tag}>" for tag in ("script", "link", "iframe") if f"<{tag}" in page]
faults += [f"a link leads to {target}" for target in re.findall(r'href="([^"]*)"', page)
           if not target.startswith(("#", "https:"))]
if page.count("<table>") != page.count('<div class="wide"><table>') or page.count("<table>") < 40:
    faults.append("tables are not what they should be")
if re.search(r"<p>[^<]*\|[^<]*\|", page):
    faults.append("a table was not understood")
print("\n".join(faults))
sys.exit(1 if faults else 0)
