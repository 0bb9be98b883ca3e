# Writes one TDMS file with npTDMS, and the same numbers as CSV beside it.
#   python write_tdms.py OUTPUT.tdms SEGMENTS
# Group "joint": 1000 rows in that many segments, clock by the waveform's properties. Group "drive":
# all types of numbers with a channel of timestamps.
import sys

import numpy as np
from nptdms import ChannelObject, GroupObject, RootObject, TdmsFile, TdmsWriter


def joint_channels(rows):
    t = rows / 1000
    q = 1.2 * np.sin(2 * np.pi * 0.5 * t)
    clock = {"wf_start_time": np.datetime64("2026-03-01T08:15:00"), "wf_start_offset": 0.0,
             "wf_increment": 0.001, "wf_samples": len(rows)}
    scale = {"NI_Number_Of_Scales": 1, "NI_Scale[0]_Scale_Type": "Linear",
             "NI_Scale[0]_Linear_Slope": 0.01, "NI_Scale[0]_Linear_Y_Intercept": -0.5,
             "NI_Scaling_Status": "unscaled"}
    polynomial = {"NI_Number_Of_Scales": 2, "NI_Scale[0]_Scale_Type": "Polynomial",
                  "NI_Scale[0]_Polynomial_Coefficients_Size": 3,
                  "NI_Scale[0]_Polynomial_Coefficients[0]": 1.0,
                  "NI_Scale[0]_Polynomial_Coefficients[1]": 0.5,
                  "NI_Scale[0]_Polynomial_Coefficients[2]": 0.25,
                  "NI_Scale[1]_Scale_Type": "Linear", "NI_Scale[1]_Linear_Input_Source": 0,
                  "NI_Scale[1]_Linear_Slope": 2.0, "NI_Scale[1]_Linear_Y_Intercept": 1.0}
    return [
        ChannelObject("joint", "Position", q, dict(clock, unit_string="rad")),
        ChannelObject("joint", "Torque", (10 * q).astype("f4"), dict(clock, unit_string="Nm")),
        ChannelObject("joint", "Current", (q * 1000).astype("i2"), dict(clock, unit_string="A", **scale)),
        ChannelObject("joint", "Curve", (q * 10).astype("i4"), dict(clock, **polynomial)),
    ]


def drive_channels():
    n = np.arange(200)
    channels = [ChannelObject("drive", "Stamp", np.datetime64("2026-03-01T08:15:00") + n * np.timedelta64(4000, "us"))]
    for name in ("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f4", "f8"):
        values = (n * 7 % 100 - (0 if name.startswith("u") else 50)).astype(name)
        channels.append(ChannelObject("drive", "as " + name, values))
    channels.append(ChannelObject("drive", "enabled", n % 2 == 0))
    channels.append(ChannelObject("drive", "remark", ["note %d" % i for i in n]))
    return channels


def write_csv(path, group, first_column):
    names, columns = list(first_column), list(first_column.values())
    for channel in group.channels():
        if channel.name in ("Stamp", "remark"):
            continue
        names.append(channel.name)
        columns.append(np.asarray(channel[:]).astype("f8").tolist())
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(names) + "\n")
        for row in zip(*columns):
            file.write(",".join(repr(value) for value in row) + "\n")


def main():
    output, segments = sys.argv[1], int(sys.argv[2])
    with TdmsWriter(output) as writer:
        for rows in np.array_split(np.arange(1000), segments):
            writer.write_segment([RootObject({"name": "run"}), GroupObject("joint", {"robot": "R"})]
                                 + joint_channels(rows))
        writer.write_segment(drive_channels())
    written = TdmsFile.read(output)
    write_csv(output + ".joint.csv", written["joint"], {"time": [i * 0.001 for i in range(1000)]})
    write_csv(output + ".drive.csv", written["drive"], {"Stamp": [i * 0.004 for i in range(200)]})


main()
