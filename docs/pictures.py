#!/usr/bin/env python3
"""Draws the pictures of docs/pictures, from simulated examples.

  python3 docs/pictures.py TRIBOLOG              the motions to run, from the plan of examples/plan/joint.toml
  python3 docs/pictures.py TRIBOLOG --report     page one of the noisy paper example's report, by chromium
"""

import csv
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import tomllib
import zlib

DOCS = pathlib.Path(__file__).resolve().parent
EXAMPLES = DOCS.parent / "examples"
WIDTH, HEIGHT = 640, 190
LEFT, RIGHT, TOP, BOTTOM = 62, 12, 12, 36
STYLE = ("text{font:12px sans-serif;fill:#222}.axis{stroke:#999;fill:none}"
         ".curve{stroke:#0b5a94;stroke-width:1.6;fill:none;stroke-linejoin:round}")


def ticks(low, high):
    """Three to six round numbers within the range."""
    step = 10 ** math.floor(math.log10((high - low) / 3))
    for factor in (5, 2, 1):
        if (high - low) / (factor * step) >= 2.5:
            step *= factor
            break
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, math.floor(high / step + 1e-9) + 1)]


def label(value):
    return f"{value:g}".replace("-", "−")


def thinned(points, count=400):
    """Each bin's lowest and highest point, in their order."""
    if len(points) <= 2 * count:
        return points
    kept = []
    size = len(points) / count
    for k in range(count):
        part = points[int(k * size):int((k + 1) * size)]
        kept += sorted({min(part, key=lambda p: p[1]), max(part, key=lambda p: p[1])})
    return [points[0]] + kept + [points[-1]]


def drawing(title, points, y_name):
    """An SVG of one curve over time in seconds."""
    start = points[0][0]
    points = [(x - start, y) for x, y in points]
    x_high = points[-1][0]
    low, high = min(y for _, y in points), max(y for _, y in points)
    margin = 0.06 * (high - low)
    low, high = low - margin, high + margin

    def at(x, y):
        return (LEFT + (WIDTH - LEFT - RIGHT) * x / x_high,
                TOP + (HEIGHT - TOP - BOTTOM) * (high - y) / (high - low))

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
             f'height="{HEIGHT}" role="img"><title>{title}</title><style>{STYLE}</style>'
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
             f'<path class="axis" d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}"/>']
    for value in ticks(0, x_high):
        x, _ = at(value, low)
        parts.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 15}" text-anchor="middle">{label(value)}</text>')
    for value in ticks(low, high):
        _, y = at(0, value)
        parts.append(f'<text x="{LEFT - 5}" y="{y + 4:.1f}" text-anchor="end">{label(value)}</text>')
    parts.append(f'<text x="{(LEFT + WIDTH) / 2}" y="{HEIGHT - 5}" text-anchor="middle">time [s]</text>')
    parts.append(f'<text transform="translate(13 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" '
                 f'text-anchor="middle">{y_name}</text>')
    curve = "L".join(f"{x:.1f} {y:.1f}" for x, y in (at(*p) for p in thinned(points)))
    parts.append(f'<path class="curve" d="M{curve}"/></svg>\n')
    return "\n".join(parts)


def draw_motions(program, folder):
    subprocess.run([program, "plan", "-q", EXAMPLES / "plan/joint.toml", "-o", folder, "--runs", "2"],
                   check=True)
    with open(folder / "setpoints.csv", encoding="utf-8") as file:
        rows = [{key: float(value or 0) for key, value in row.items()} for row in csv.DictReader(file)]
    manifest = tomllib.loads((folder / "dataset.toml").read_text(encoding="utf-8"))

    def window(role):
        """From the begin of the first recording of the role to the end of the last."""
        of_role = [r for r in manifest["recording"] if r["role"] == role]
        first, last = of_role[0]["from_s"], of_role[-1]["to_s"]
        return [row for row in rows if first <= row["t_s"] <= last]

    def angles(part, factor=math.degrees(1), zero=0.0):
        return [(row["t_s"], factor * (row["q_rad"] - zero)) for row in part]

    loops = window("oscillation")
    one = [row for row in loops if row["t_s"] <= loops[0]["t_s"] + 10]
    middle = (max(r["q_rad"] for r in one) + min(r["q_rad"] for r in one)) / 2
    ramps = window("break_away")
    pictures = {
        "sweep": ("Rough sweep: the joint's angle over time", angles(window("rough_sweep")), "angle [°]"),
        "oscillation": ("Micro-oscillation at one motor position: the joint's angle from its middle",
                        angles(one, 1e6, middle), "angle [µrad]"),
        "runs": ("Runs at constant speed, each speed in both directions: the joint's angle over time",
                 angles(window("constant_speed")), "angle [°]"),
        "ramps": ("Break-away ramps: motor torque from what holds the arm",
                  [(row["t_s"], row["ramp_torque_Nm"]) for row in ramps], "torque [N·m]"),
    }
    for name, (title, points, y_name) in pictures.items():
        (DOCS / "pictures" / f"{name}.svg").write_text(drawing(title, points, y_name), encoding="utf-8")


# A PNG of 256 colours, by the standard library alone.

def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def pixel_rows(png):
    """Rows of bytes and the bytes of a pixel, of an 8-bit PNG that is not interlaced."""
    at, data = 8, b""
    width = height = channels = 0
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
            channels = {2: 3, 6: 4}[colour]
        if kind == b"IDAT":
            data += body
        at += 12 + length
    raw = zlib.decompress(data)
    rows, above = [], bytearray(width * channels)
    for y in range(height):
        start = y * (width * channels + 1)
        rule, row = raw[start], bytearray(raw[start + 1:start + 1 + width * channels])
        for k in range(len(row)):
            left = row[k - channels] if k >= channels else 0
            corner = above[k - channels] if k >= channels else 0
            if rule == 1:
                row[k] = (row[k] + left) & 255
            elif rule == 2:
                row[k] = (row[k] + above[k]) & 255
            elif rule == 3:
                row[k] = (row[k] + (left + above[k]) // 2) & 255
            elif rule == 4:
                distances = [abs(above[k] - corner), abs(left - corner), abs(left + above[k] - 2 * corner)]
                row[k] = (row[k] + (left, above[k], corner)[distances.index(min(distances))]) & 255
        rows.append(row)
        above = row
    return rows, channels


def with_palette(png):
    rows, channels = pixel_rows(png)
    counts = {}
    pixels = [[bytes(row[k:k + 3]) for k in range(0, len(row), channels)] for row in rows]
    for row in pixels:
        for colour in row:
            counts[colour] = counts.get(colour, 0) + 1
    palette = sorted(counts, key=lambda c: (-counts[c], c))[:256]
    index = {colour: k for k, colour in enumerate(palette)}
    for colour in counts:
        if colour not in index:
            index[colour] = min(range(len(palette)),
                                key=lambda k: sum((a - b) ** 2 for a, b in zip(colour, palette[k])))
    data = b"".join(b"\0" + bytes(index[c] for c in row) for row in pixels)
    header = struct.pack(">IIBBBBB", len(pixels[0]), len(pixels), 8, 3, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", b"".join(palette)) +
            chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b""))


def draw_report(program, folder):
    subprocess.run([program, "simulate", "-q", EXAMPLES / "paper/scenario_noise.toml", "-o", folder], check=True)
    subprocess.run([program, "report", "-q", folder / "dataset.toml", "-o", folder / "report.html"], check=True)
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--hide-scrollbars", "--window-size=1000,1334",
                    f"--screenshot={folder / 'page.png'}", folder / "report.html"],
                   check=True, stderr=subprocess.DEVNULL)
    picture = with_palette((folder / "page.png").read_bytes())
    (DOCS / "pictures/report.png").write_bytes(picture)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--report"]):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as scratch:
        draw = draw_report if len(sys.argv) == 3 else draw_motions
        draw(sys.argv[1], pathlib.Path(scratch))
