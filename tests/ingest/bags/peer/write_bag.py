"""Writes one bag of ROS 1 with rosbags, and a CSV file of each topic's numbers.

    write_bag.py OUTPUT none|bz2|lz4 DIRECTORY_OF_CSV
/joint_states and /state hold 200 messages each, at 1.7e18 + 4e6 i ns, recorded 9 us later.
"""

import math
import sys
from pathlib import Path

import numpy as np
from rosbags.rosbag1 import Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

OUTPUT, COMPRESSION, DIRECTORY = sys.argv[1:]
COUNT = 200
JOINTS = ["shoulder", "elbow", "wrist"]
STATE = """
std_msgs/Header header
int8 MOVING=7   # a constant
string UNIT=Nm  # with = and # in it
byte low
char high
bool ready
uint16[3] counts
float32[] bounded
time started
duration since
arm_msgs/Motor[] motors
string note
geometry_msgs/Vector3 force
int64 large
"""
MOTOR = "float64 current\nuint8[] raw\n"

store = get_typestore(Stores.ROS1_NOETIC)
store.register(get_types_from_msg(STATE, "arm_msgs/msg/State"))
store.register(get_types_from_msg(MOTOR, "arm_msgs/msg/Motor"))


def made(name, *values):
    return store.types[name](*values)


def header(i, stamp):
    time = made("builtin_interfaces/msg/Time", stamp // 10**9, stamp % 10**9)
    return made("std_msgs/msg/Header", i, time, "arm")


def position(i, k):
    return math.sin(i / 7 + k)


def velocity(i, k):
    return math.cos(i / 7 + k) / 7


def effort(i, k):
    return math.sqrt(i + k) * (k - 1)


def joint_state(i, stamp):
    order = [(k + i) % 3 for k in range(3)]
    lists = [np.array([signal(i, k) for k in order]) for signal in (position, velocity, effort)]
    return made("sensor_msgs/msg/JointState", header(i, stamp), [JOINTS[k] for k in order], *lists)


def joint_state_row(i):
    row = {}
    for k, joint in enumerate(JOINTS):
        row |= {f"{joint}.position": position(i, k), f"{joint}.velocity": velocity(i, k),
                f"{joint}.effort": effort(i, k)}
    return row


def state(i, stamp):
    motors = [made("arm_msgs/msg/Motor", i / 3 + k, np.zeros(70, np.uint8)) for k in range(2)]
    return made("arm_msgs/msg/State", header(i, stamp), -(i % 100), 200, i % 2 == 0,
                np.array([i, 1, 65535], np.uint16), np.array([i / 4], np.float32),
                made("builtin_interfaces/msg/Time", 5, i), made("builtin_interfaces/msg/Duration", -6, i),
                motors, "n" * (i % 5), made("geometry_msgs/msg/Vector3", i / 9, -i, 0.5), -i)


def state_row(i):
    return {"low": -(i % 100), "high": 200, "ready": int(i % 2 == 0), "counts[0]": i, "counts[1]": 1,
            "counts[2]": 65535, "bounded[0]": i / 4, "started.sec": 5, "started.nsec": i,
            "since.sec": -6, "since.nsec": i, "motors[0].current": i / 3,
            "motors[1].current": i / 3 + 1, "force.x": i / 9, "force.y": -i, "force.z": 0.5,
            "large": -i}


TOPICS = {
    "joint_states": ("sensor_msgs/msg/JointState", joint_state, joint_state_row),
    "state": ("arm_msgs/msg/State", state, state_row),
}

writer = Writer(OUTPUT)
if COMPRESSION != "none":
    writer.set_compression(Writer.CompressionFormat[COMPRESSION.upper()])
writer.chunk_threshold = 1 << 14
with writer:
    connections = {name: writer.add_connection(f"/{name}", kind, typestore=store)
                   for name, (kind, _, _) in TOPICS.items()}
    for i in range(COUNT):
        stamp = 1_700_000_000_000_000_000 + i * 4_000_000
        for name, (kind, message, _) in TOPICS.items():
            writer.write(connections[name], stamp + 9_000, store.serialize_ros1(message(i, stamp), kind))

for name, (_, _, row) in TOPICS.items():
    rows = [{"time": i * 0.004, "log_time": i * 0.004} | row(i) for i in range(COUNT)]
    lines = [",".join(rows[0])] + [",".join(repr(value) for value in row.values()) for row in rows]
    Path(DIRECTORY, f"{name}.csv").write_text("\n".join(lines) + "\n")
