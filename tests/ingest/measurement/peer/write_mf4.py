# Writes one MDF 4 file with asammdf, and the same numbers as CSV beside it.
#   python write_mf4.py OUTPUT.mf4 COMPRESSION FRAGMENT_BYTES VERSION
# Group "joint": 2000 rows at 1 kHz. Group "drive": 300 rows at 100 Hz, in integers with conversions.
# OUTPUT.joint.csv, OUTPUT.drive.csv: the values as asammdf itself reads them; a gap is empty.
# "Formula" and "Remark" are there to be left out.
import sys

import numpy as np
from asammdf import MDF, Signal


def joint_signals():
    t = np.arange(2000) / 1000
    q = 1.2 * np.sin(2 * np.pi * 0.5 * t)
    signals = [
        Signal(q, t, name="Position", unit="rad"),
        Signal((10 * q + 2 * np.sign(np.cos(t))).astype("f4"), t, name="Torque", unit="Nm"),
        Signal((q * 100).astype("f2"), t, name="Half", unit="%"),
        Signal(np.arange(2000, dtype="u1"), t, name="Counter"),
        Signal((q * 1e4).astype("i8"), t, name="Wide"),
    ]
    gaps = np.zeros(2000, dtype=bool)
    gaps[10:20] = True
    signals.append(Signal(q * 2, t, name="Speed", unit="rad/s", invalidation_bits=gaps))
    return signals


def drive_signals():
    t = np.arange(300) / 100
    n = np.arange(300)
    table = {f"raw_{i}": float(10 * i) for i in range(4)} | {f"phys_{i}": float(i * i) for i in range(4)}
    ranges = {"lower_0": 0.0, "upper_0": 9.0, "phys_0": 1.5, "lower_1": 10.0, "upper_1": 29.0,
              "phys_1": -2.5, "default": 0.25}
    rational = {"P1": 0.0, "P2": 2.0, "P3": 1.0, "P4": 0.0, "P5": 0.0, "P6": 4.0}
    return [
        Signal((n - 150).astype("i2"), t, name="Current", unit="A", conversion={"a": 0.01, "b": -0.5}),
        Signal((n % 40).astype("u1"), t, name="Interpolated",
               conversion=dict(table, interpolation=True)),
        Signal((n % 40).astype("u1"), t, name="Nearest", conversion=dict(table, interpolation=False)),
        Signal((n % 40).astype("u1"), t, name="Ranges", conversion=ranges),
        Signal((n % 7).astype("u4"), t, name="Rational", conversion=rational),
        Signal((n % 3).astype("u1"), t, name="State",
               conversion={"val_0": 0, "text_0": "off", "val_1": 1, "text_1": "on",
                           "default_addr": b"fault"}),
        Signal(n.astype("u1"), t, name="Formula", conversion={"formula": "X1 * 2 + 1"}),
        Signal(np.array([b"x"] * 300), t, name="Remark", encoding="utf-8"),
    ]


def write_csv(path, mdf, group, names):
    columns = []
    for name in names:
        if name == "Ranges":
            # asammdf 8 takes the last integer of a range alone to be in it; by the standard all are.
            raw = mdf.get(name, group=group, raw=True).samples.tolist()
            columns.append([1.5 if n < 10 else -2.5 if n < 30 else 0.25 for n in raw])
            continue
        signal = mdf.get(name, group=group, ignore_invalidation_bits=True)
        columns.append(signal.samples.tolist() if signal.samples.dtype.kind not in "SU" else
                       [value.decode() for value in signal.samples.tolist()])
        bits = getattr(signal, "invalidation_bits", None)
        if bits is not None:
            bits = np.asarray(bits).astype(bool)
            columns[-1] = ["" if bad else value for value, bad in zip(columns[-1], bits.tolist())]
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(names) + "\n")
        for row in zip(*columns):
            file.write(",".join(value if isinstance(value, str) else repr(value) for value in row) + "\n")


def main():
    output, compression, fragment, version = sys.argv[1:5]
    mdf = MDF(version=version)
    mdf.configure(write_fragment_size=int(fragment))
    mdf.append(joint_signals(), acq_name="joint", common_timebase=True)
    mdf.append(drive_signals(), acq_name="drive", common_timebase=True)
    mdf.save(output, overwrite=True, compression=int(compression))
    mdf.close()
    with MDF(output) as written:
        write_csv(output + ".joint.csv", written, 0,
                  ["time", "Position", "Torque", "Half", "Counter", "Wide", "Speed"])
        write_csv(output + ".drive.csv", written, 1,
                  ["time", "Current", "Interpolated", "Nearest", "Ranges", "Rational", "State"])


main()
