#!/usr/bin/env python3
"""Writes a robot's log as a rosbag2 folder of JointState messages: metadata.yaml and two SQLite files.

  write_rosbag2.py CSV FOLDER     the CSV: t_s, then an angle and a current of each joint
"""

import csv
import os
import sqlite3
import struct
import sys

START_NS = 1_700_000_000_000_000_000


def numbers(at, values):
    """A sequence of doubles in CDR, at this place behind the encapsulation."""
    out = struct.pack("<I", len(values))
    if not values:
        return out
    padding = -(at + len(out)) % 8
    return out + bytes(padding) + struct.pack(f"<{len(values)}d", *values)


def joint_state(stamp, names, positions, efforts):
    body = struct.pack("<iI", stamp // 10**9, stamp % 10**9)
    for text in ["base"]:
        body += struct.pack("<I", len(text) + 1) + text.encode() + b"\0"
    body += bytes(-len(body) % 4) + struct.pack("<I", len(names))
    for name in names:
        body += bytes(-len(body) % 4) + struct.pack("<I", len(name) + 1) + name.encode() + b"\0"
    for values in (positions, [], efforts):
        body += bytes(-len(body) % 4)
        body += numbers(len(body), values)
    return b"\0\1\0\0" + body


def write_part(path, rows, names):
    bag = sqlite3.connect(path)
    bag.executescript(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
        " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
        " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
        "INSERT INTO topics VALUES(1, '/joint_states', 'sensor_msgs/msg/JointState', 'cdr', '');")
    with bag:
        for row in rows:
            stamp = START_NS + round(row[0] * 1e9)
            bag.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(1, ?, ?)",
                        (stamp + 50_000, joint_state(stamp, names, row[1::2], row[2::2])))
    bag.close()


def main(log, folder):
    with open(log, newline="", encoding="utf8") as file:
        rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
    names = [f"J{k + 1}" for k in range((len(rows[0]) - 1) // 2)]
    os.makedirs(folder, exist_ok=True)
    half = len(rows) // 2
    files = []
    for k, part in enumerate((rows[:half], rows[half:])):
        files.append(f"robot_{k}.db3")
        write_part(os.path.join(folder, files[-1]), part, names)
    with open(os.path.join(folder, "metadata.yaml"), "w", encoding="utf8") as file:
        file.write("rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
                   "  relative_file_paths:\n" + "".join(f"    - {name}\n" for name in files))


main(*sys.argv[1:])
