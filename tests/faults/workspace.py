"""What the fault tests have in common: files to work on, every command, and how a run is judged."""

import atexit
import hashlib
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

MANIFEST = """schema = "tribolog-dataset-1"
[robot]
name = "test robot"
[joint]
name = "J1"
gear_ratio = 100
[effort]
kind = "motor_torque"
side = "motor"
[columns]
time = { name = "t", unit = "s" }
angle = { name = "q", unit = "rad" }
effort = { name = "tau", unit = "Nm" }
[[recording]]
role = "rough_sweep"
file = "log.csv"
"""

EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "..", "examples")


def every_case():
    """Whether what a change sees in part is looked at whole (tests/nightly.sh cases)."""
    return bool(os.environ.get("TRIBOLOG_EVERY_CASE"))


def sweep_log(offset):
    """There and back over a gravity peak at 0.2 rad."""
    lines = ["t,q,tau"]
    rows = 400
    for k in range(2 * rows):
        there = k < rows
        x = k if there else 2 * rows - 1 - k
        q = -1 + 2.4 * x / rows
        friction = 0.05 if there else -0.05
        tau = offset + 0.4 * math.cos(q - 0.2) + friction + 0.002 * math.sin(37 * k)
        lines.append(f"{0.01 * k:.2f},{q:.6f},{tau:.6f}")
    return "\n".join(lines) + "\n"


class Command:
    """One way to call the program, in a directory that Workspace made.

    prints: does it say anything on standard output? writes: its output files and directories.
    `{id}` and `{other}` are calibrations of the archive; `{out}` is where its outputs go.
    """

    def __init__(self, line, prints=True, writes=(), slow=False, draws=False):
        self.line, self.prints, self.writes = line, prints, writes
        self.slow, self.draws = slow, draws

    def __str__(self):
        return self.line.replace(" --truth-runs 0", "").replace("{out}/", "")


ARCHIVED = " --archive {out}/a.tribolog"
FEW = " --truth-runs 0"
COMMANDS = [
    Command("--help"),
    Command("--version", draws=True),
    Command("report --help"),
    Command("archive --help"),
    Command(""),
    Command("models"),
    Command("models --compare -o {out}/models.html", writes=["models.html"], slow=True, draws=True),
    Command("inspect log.csv"),
    Command("inspect log.csv --json {out}/survey.json", writes=["survey.json"]),
    Command("init log.csv --force -o {out}/made.toml", writes=["made.toml"]),
    Command("simulate scenario.toml -o {out}/sim", writes=["sim"]),
    Command("identify dataset.toml -o {out}/cal.json" + FEW, writes=["cal.json"]),
    Command("identify dataset.toml -o {out}/cal.json" + FEW + ARCHIVED + " --archive-again",
            writes=["cal.json", "a.tribolog"]),
    Command("identify dataset.toml -o {out}/cal.json" + FEW + " --archive {out}/new.tribolog",
            writes=["cal.json", "new.tribolog"]),
    Command("figures dataset.toml -o {out}/figures --format svg --truth-runs 0",
            writes=["figures"]),
    Command("figures dataset.toml -o {out}/figures --truth-runs 0", writes=["figures"],
            draws=True),
    Command("report dataset.toml -o {out}/r.html --no-figures" + FEW,
            writes=["r.html", "r.calibration.json"]),
    Command("report dataset.toml -o {out}/r.html" + FEW, writes=["r.html", "r.calibration.json"],
            draws=True),
    Command("report dataset.toml -o {out}/r.html" + FEW + ARCHIVED + " --archive-again",
            writes=["r.html", "r.calibration.json", "a.tribolog"], draws=True),
    Command("plan joint.toml -o {out}/plan --runs 0", writes=["plan"], draws=True),
    Command("study --runs 2 --factor torque_step -o {out}/study.html --json {out}/study.json",
            writes=["study.html", "study.json"], slow=True, draws=True),
    Command("paper -o {out}/paper.html", writes=["paper.html"], slow=True, draws=True),
    Command("show cal.json"),
    Command("show cal.json --json"),
    Command("show r.html --json"),
    Command("archive add cal.json --again" + ARCHIVED, writes=["a.tribolog"]),
    Command("archive add cal.json --again --json" + ARCHIVED, writes=["a.tribolog"]),
    Command("archive list" + ARCHIVED),
    Command("archive list --json" + ARCHIVED),
    Command("archive show {id}" + ARCHIVED),
    Command("archive show {id} --json" + ARCHIVED),
    Command("archive report {id} -o {out}/kept.html --calibration {out}/kept.json" + ARCHIVED,
            writes=["kept.html", "kept.json"]),
    Command("archive diff {id} {other}" + ARCHIVED),
    Command("archive diff {id} {other} --json" + ARCHIVED),
    Command("archive diff {id} {other} -o {out}/diff.html" + ARCHIVED, writes=["diff.html"],
            draws=True),
    Command("archive trend" + ARCHIVED),
    Command("archive trend --json" + ARCHIVED),
    Command("archive trend -o {out}/trend.html" + ARCHIVED, writes=["trend.html"], draws=True),
    Command("archive fleet --json" + ARCHIVED),
    Command("archive fleet -o {out}/fleet.html --reports {out}/reports" + ARCHIVED,
            writes=["fleet.html", "reports"]),
    *[Command(f"archive export {{id}} --doubtful-too --format {form}" + ARCHIVED)
      for form in ("csv", "json", "latex")],
    Command("archive export {id} --format csv -o {out}/joint.csv" + ARCHIVED,
            writes=["joint.csv"]),
    Command("archive verify" + ARCHIVED),
    Command("archive verify --json" + ARCHIVED),
    Command("archive backup -o {out}/copy.tribolog" + ARCHIVED, writes=["copy.tribolog"]),
    Command("archive remove {id} --yes" + ARCHIVED, writes=["a.tribolog"]),
    Command("archive remove {id} --yes --json" + ARCHIVED, writes=["a.tribolog"]),
    Command("review {id} --approve --reviewer Jo -o {out}/r2.html" + ARCHIVED,
            writes=["r2.html", "a.tribolog"]),
]


class Outcome:
    def __init__(self, status, out, err):
        self.status, self.out, self.err = status, out, err

    @property
    def words(self):
        """The line that a user reads first: the error, or how it ended."""
        lines = [line for line in self.err.splitlines() if re.search(r"error:|ended by", line)]
        return lines[0] if lines else ""


class Workspace:
    """Inputs, an archive of two calibrations, and copies of them to run commands in."""

    def __init__(self, program):
        self.program = os.path.abspath(program)
        self.scratch = tempfile.mkdtemp(prefix="tribolog-faults-")
        atexit.register(shutil.rmtree, self.scratch, ignore_errors=True)
        self.ids = ("", "")
        self.base = os.path.join(self.scratch, "base")
        os.mkdir(self.base)
        self._write("dataset.toml", MANIFEST)
        for name in ("paper/scenario.toml", "paper/am100ib.toml", "plan/joint.toml"):
            shutil.copy(os.path.join(EXAMPLES, name), self.base)
        for offset in (0.01, 0.0):
            self._write("log.csv", sweep_log(offset))
            self.call("report dataset.toml -o r.html --no-figures --calibration cal.json" + FEW +
                      " --archive a.tribolog")
        listed = self.call("archive list --json --archive a.tribolog").out
        self.ids = re.findall(r'"id": *"([0-9a-f]+)"', listed)
        if len(self.ids) != 2:
            sys.exit(f"the archive should have two calibrations: {listed}")

    def _write(self, name, text):
        with open(os.path.join(self.base, name), "w", encoding="utf-8") as file:
            file.write(text)

    def call(self, line):
        done = self.run(line, self.base)
        if done.status != 0:
            sys.exit(f"tribolog {line}: status {done.status}\n{done.err}")
        return done

    def copy(self, name="run"):
        """A fresh copy of the inputs, in which a command may do what it likes."""
        path = os.path.join(self.scratch, name)
        shutil.rmtree(path, ignore_errors=True)
        shutil.copytree(self.base, path)
        return path

    def arguments(self, line, out="."):
        return line.format(id=self.ids[0], other=self.ids[1], out=out).split()

    def run(self, line, directory, out=".", stdout=subprocess.PIPE, environment=None, **how):
        done = subprocess.run([self.program, *self.arguments(line, out)], cwd=directory,
                              stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.PIPE,
                              env={**os.environ, **(environment or {})}, timeout=600, check=False,
                              **how)
        # As a shell says it.
        status = done.returncode if done.returncode >= 0 else 128 - done.returncode
        text = (done.stdout or b"").decode(errors="replace")
        return Outcome(status, text, done.stderr.decode(errors="replace"))


def files_in(directory):
    """Every file, hidden ones too, with its SHA-256; empty directories with none."""
    found = {}
    for path, folders, names in os.walk(directory):
        for name in names:
            full = os.path.join(path, name)
            with open(full, "rb") as file:
                found[os.path.relpath(full, directory)] = hashlib.sha256(file.read()).hexdigest()
        if not folders and not names and path != directory:
            found[os.path.relpath(path, directory) + "/"] = ""
    return found


def leftovers(files):
    """Temporary files and journals."""
    return [name for name in files if ".tmp-" in name or name.endswith("-journal")]


class Table:
    """Prints its rows as they come; knows how many of them broke a promise."""

    def __init__(self, title, heading):
        self.faults = self.rows = 0
        print(f"\n## {title}\n\n| {' | '.join(heading)} | |\n|{'---|' * (len(heading) + 1)}")

    def add(self, cells, faults):
        self.rows += 1
        self.faults += bool(faults)
        print("| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " | " +
              ("; ".join(faults) if faults else "ok") + " |", flush=True)

    def end(self):
        print(f"\n{self.rows} rows, {self.faults} with faults", flush=True)
        return self.faults
