#!/usr/bin/env python3
"""Every chart of a report beside matplotlib's drawing of the same data.

usage: sheet.py REPORT.html SHEET.png [--rows N]
Ours on the left, as it stands in the report; on the right the figure's CSV as matplotlib draws it
out of the box, equally wide in print. With --rows N several sheets, SHEET-1.png and so on, of N
figures each.
"""

import argparse
import io
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.image
import matplotlib.pyplot as plt
import numpy

from drawn_csv import picture_of
from report_figures import ReportFigures

SHRINK = 2
GAP_PX = 24


def pixels_of(png):
    return matplotlib.image.imread(io.BytesIO(png), format="png")[:, :, :3]


def shrunk(pixels):
    """Each block of pixels as its mean."""
    height, width = (size // SHRINK * SHRINK for size in pixels.shape[:2])
    blocks = pixels[:height, :width].reshape(height // SHRINK, SHRINK, width // SHRINK, SHRINK, 3)
    return blocks.mean(axis=(1, 3))


def padded(pixels, height, width):
    out = numpy.ones((height, width, 3))
    out[:pixels.shape[0], :pixels.shape[1]] = pixels
    return out


def side_by_side(left, right):
    height = max(left.shape[0], right.shape[0])
    gap = numpy.ones((height, GAP_PX, 3))
    return numpy.hstack([padded(left, height, left.shape[1]), gap,
                         padded(right, height, right.shape[1])])


def heading(width_px):
    dpi = 100
    figure = plt.figure(figsize=(width_px / dpi, 0.5), dpi=dpi)
    figure.text(0.25, 0.5, "tribolog", ha="center", va="center", weight="bold")
    figure.text(0.75, 0.5, f"matplotlib {matplotlib.__version__}, defaults, the same data",
                ha="center", va="center", weight="bold")
    out = io.BytesIO()
    figure.savefig(out, format="png")
    plt.close(figure)
    return pixels_of(out.getvalue())


def row_of(name, png, csv_text):
    ours = pixels_of(png)
    theirs = pixels_of(picture_of(csv_text, ours.shape[1], ours.shape[0]))
    print(name)
    return side_by_side(shrunk(ours), shrunk(theirs))


def write_sheet(rows, file):
    width = max(row.shape[1] for row in rows)
    rule = numpy.full((2, width, 3), 0.7)
    parts = [padded(heading(width), 50, width)]
    for row in rows:
        parts += [rule, padded(row, row.shape[0], width)]
    matplotlib.image.imsave(file, numpy.clip(numpy.vstack(parts), 0, 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("sheet", type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=0, help="figures of one sheet; 0: all")
    options = parser.parse_args()
    figures = ReportFigures(options.report.read_text(encoding="utf-8")).found
    if not figures:
        raise SystemExit(f"{options.report}: no figure with data in it")
    rows = [row_of(*figure) for figure in figures]
    if options.rows <= 0:
        write_sheet(rows, options.sheet)
        return
    for number, first in enumerate(range(0, len(rows), options.rows), 1):
        write_sheet(rows[first:first + options.rows],
                    options.sheet.with_stem(f"{options.sheet.stem}-{number}"))


if __name__ == "__main__":
    main()
