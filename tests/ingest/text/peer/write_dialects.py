"""Text logs of many dialects, written by Python's csv module, each with its values beside it.

usage: write_dialects.py DIRECTORY COUNT
NNNN.csv is the log; NNNN.txt holds its decimal mark, the names, and one row of float.hex() a line.
"""

import csv
import io
import math
import random
import sys


def number(rng, value, comma):
    if math.isnan(value):
        return rng.choice(["nan", "NaN", "", "NULL", "N/A", "-nan(ind)", "inf", "-Inf"])
    form = rng.randrange(4)
    text = [repr(value), f"{value:.17g}", f"{value:.17e}", f"{value:+.17g}"][form]
    return text.replace(".", ",") if comma else text


def write(path, rng):
    comma = rng.random() < 0.2
    delimiter = rng.choice([";", "\t"] if comma else [",", ";", "\t"])
    names = rng.sample(["t_s", "q_rad", "dq", "tau [Nm]", "i (A)", "state.q[0]", "a, b", 'the "q"'],
                       rng.randrange(2, 7))
    rows = [[rng.choice([rng.gauss(0, 1), rng.gauss(0, 1) * 10.0 ** rng.randrange(-300, 300),
                         float(rng.randrange(-1000, 1000)), math.nan])
             for _ in names] for _ in range(rng.randrange(2, 40))]
    for row in rows:
        row[0] = 0.0 if math.isnan(row[0]) else row[0]  # an empty row would be none
    for k in range(len(names)):  # a column of nothing but gaps is another matter
        rows[0][k] = 1.5
    text = io.StringIO(newline="")
    writer = csv.writer(text, delimiter=delimiter, lineterminator=rng.choice(["\n", "\r\n", "\r"]),
                        quoting=rng.choice([csv.QUOTE_MINIMAL, csv.QUOTE_ALL, csv.QUOTE_NONNUMERIC]))
    end = writer.dialect.lineterminator
    trailing = [""] if rng.random() < 0.15 else []
    for _ in range(rng.randrange(3)):
        text.write(rng.choice(["# recorded " + delimiter * 3, ""]) + end)
    writer.writerow(names + trailing)
    for row in rows:
        if rng.random() < 0.05:
            text.write("# note, with; all\tmarks" + end)
        writer.writerow([number(rng, value, comma) for value in row] + trailing)
    content = text.getvalue()
    if rng.random() < 0.2 and not content[: -len(end)].endswith(delimiter):  # or it looks cut off
        content = content[: -len(end)]
    with open(path + ".csv", "wb") as log:
        log.write((b"\xef\xbb\xbf" if rng.random() < 0.2 else b"") + content.encode())
    with open(path + ".txt", "w", encoding="utf-8") as values:
        values.write(("comma" if comma else "point") + "\n")
        values.write("\x1f".join(names) + "\n")
        for row in rows:
            values.write(" ".join(value.hex() for value in row) + "\n")


for index in range(int(sys.argv[2])):
    write(f"{sys.argv[1]}/{index:04d}", random.Random(index))
