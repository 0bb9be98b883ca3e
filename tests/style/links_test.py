#!/usr/bin/env python3
"""links.py finds what it is there for, and nothing else."""

import pathlib
import subprocess
import sys
import tempfile

LINKS = pathlib.Path(__file__).with_name("links.py")
OTHER = "# Other\n\n## Two words, `[code]`\n\n## Again\n\n## Again\n"

CASES = [  # README.md, exit status, what is printed
    ("[a](docs/other.md) [b](docs/other.md#two-words-code) [c](#title) [d](https://example.com/x)\n", 0, ""),
    ("[a](docs/other.md#again) [b](docs/other.md#again-1)\n", 0, ""),
    ("[a](docs/other.md#again-2)\n", 1, "README.md:3: docs/other.md#again-2: docs/other.md has no such heading"),
    ("[a](docs/missing.md)\n", 1, "README.md:3: docs/missing.md: there is no such file"),
    ("![a](docs/missing.png)\n", 1, "docs/missing.png: there is no such file"),
    ("[a](#nowhere)\n", 1, "#nowhere: README.md has no such heading"),
    ("[words that go\non](docs/missing.md)\n", 1, "README.md:4: docs/missing.md"),
    ("[a](../outside.md)\n", 1, "there is no such file"),
    ("[a](/etc/hostname)\n", 1, "/etc/hostname: "),
    ("`[a](docs/missing.md)`\n\n```toml\n[a](docs/missing.md)\n# Not a heading\n```\n", 0, ""),
    ("```sh\n# No heading\n```\n[a](#no-heading)\n", 1, "#no-heading: README.md has no such heading"),
]

failed = 0
for text, status, words in CASES:
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch)
        (root / "docs").mkdir()
        (root / "README.md").write_text("# Title\n\n" + text, encoding="utf-8")
        (root / "docs/other.md").write_text(OTHER, encoding="utf-8")
        run = subprocess.run([sys.executable, LINKS, root], capture_output=True, text=True, check=False)
    if run.returncode != status or words not in run.stdout or (status == 0 and run.stdout):
        failed += 1
        print(f"{text!r}: status {run.returncode}, not {status}; {words!r} expected in:\n{run.stdout}{run.stderr}")
sys.exit(1 if failed else 0)
