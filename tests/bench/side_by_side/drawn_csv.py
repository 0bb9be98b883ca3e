"""A figure's CSV drawn by matplotlib as it comes out of the box: no colour, size, range, tick or
place of a legend is chosen here. Only the picture's size is ours: as wide in print as our own."""

import csv
import io
import math
import re

import matplotlib.pyplot as plt

PRINT_WIDTH_IN = 160 / 25.4


class Panel:
    def __init__(self, title, x, y):
        self.title, self.x, self.y = title, x, y
        self.curves, self.bands, self.bars, self.points, self.lines, self.names = [], [], [], [], [], []


def panels_of(text):
    """The figure's title and its panels; a curve is (name, x, y)."""
    comments = [line[2:] for line in text.splitlines() if line.startswith("# ")]
    title = comments[0].split(": ", 1)[1]
    panels = {}
    for line in comments[1:]:
        found = re.match(r"panel (\d+)(?: \((.*)\))?: x = (.*); y = (.*)$", line)
        if found:
            panels[found[1]] = Panel(found[2] or "", found[3], found[4])
    rows = csv.DictReader(io.StringIO("\n".join(l for l in text.splitlines() if not l.startswith("#"))))
    last = None
    for row in rows:
        panel, kind, name = panels[row["panel"]], row["what"], row["name"]
        x, y, low, high = (float(row[k]) if row[k] else math.nan for k in ("x", "y", "low", "high"))
        goes_on = last == (row["panel"], kind, name)
        last = (row["panel"], kind, name)
        if kind == "curve":
            if not goes_on:
                panel.curves.append((name, [], []))
            panel.curves[-1][1].append(x)
            panel.curves[-1][2].append(y)
        elif kind == "interval" and name:
            if not goes_on:
                panel.bands.append((name, [], [], []))
            for values, value in zip(panel.bands[-1][1:], (x, low, high)):
                values.append(value)
        elif kind == "interval":
            panel.bars.append((x, low, high))
        elif kind == "point":
            panel.points.append((name, x, y))
        elif kind == "line":
            panel.lines.append((name, x, y))
        elif kind == "name":
            panel.names.append((name, x, y))
    return title, [panels[key] for key in sorted(panels, key=int)]


def draw(axes, panel):
    for name, x, y in panel.curves:
        axes.plot(x, y, label=name or None)
    for name, x, low, high in panel.bands:
        axes.fill_between(x, low, high, alpha=0.3, label=name)
    for x, low, high in panel.bars:
        axes.errorbar([x], [(low + high) / 2], yerr=[[(high - low) / 2]] * 2)
    for name, x, y in panel.points:
        axes.plot([x], [y], "o")
        axes.annotate(name, (x, y))
    for name, x, y in panel.lines:
        if math.isnan(x):
            axes.axhline(y, linestyle="--", label=name or None)
        else:
            axes.axvline(x, linestyle="--", label=name or None)
    for turned, place in ((False, 1), (True, 2)):
        named = [one for one in panel.names if not math.isnan(one[place])]
        if named:
            (axes.set_yticks if turned else axes.set_xticks)([one[place] for one in named],
                                                             [one[0] for one in named])
    axes.set_xlabel(panel.x)
    axes.set_ylabel(panel.y)
    axes.set_title(panel.title)
    if axes.get_legend_handles_labels()[1]:
        axes.legend()


def picture_of(text, width_px, height_px):
    """PNG bytes, of that many pixels."""
    title, panels = panels_of(text)
    dpi = width_px / PRINT_WIDTH_IN
    figure, all_axes = plt.subplots(len(panels), squeeze=False, layout="constrained", dpi=dpi,
                                    figsize=(PRINT_WIDTH_IN, height_px / dpi))
    figure.suptitle(title)
    for axes, panel in zip(all_axes[:, 0], panels):
        draw(axes, panel)
    out = io.BytesIO()
    figure.savefig(out, format="png")
    plt.close(figure)
    return out.getvalue()
