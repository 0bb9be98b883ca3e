#!/usr/bin/env python3
"""Manifests beside a simulated dataset in which something is absent or wrong, so that its report says
what it says only then.

usage: vary_dataset.py DIRECTORY      writes DIRECTORY/<what>_variant.toml
"""
import pathlib
import re
import sys

directory = pathlib.Path(sys.argv[1])
head, *recordings = (directory / "dataset.toml").read_text(encoding="utf-8").split("[[recording]]")
recordings = ["[[recording]]" + one for one in recordings]
head = head[:head.index("# The friction that was simulated")]


def of(*roles):
    return [one for one in recordings if re.search(r'role = "(\w+)"', one).group(1) in roles]


def write(name, text, kept):
    (directory / f"{name}_variant.toml").write_text(text + "".join(kept), encoding="utf-8")


def with_change(old, new):
    assert old in head, old
    return head.replace(old, new, 1)


limits = """
[[limit]]
quantity = "coulomb_joint_Nm"
max = 15
[[limit]]
quantity = "surrogate_mass_kg"
min = 70
max = 90
half_width = 1
[[limit]]
quantity = "viscous_motor_Nms_rad"
half_width_percent = 1
[known_gravity]
amplitude_Nm = 350
q_peak_deg = -22
"""
write("sweep", head, of("rough_sweep"))
write("oscillation", head, of("oscillation"))
write("runs", head, of("constant_speed"))
write("one_direction", head, of("constant_speed")[:10] + of("oscillation"))
write("no_runs", head, of("rough_sweep", "oscillation"))
write("no_sweep", head, of("oscillation", "constant_speed"))
write("limits", head + limits, recordings)
without_torque = with_change('kind = "motor_torque"\nside = "motor"', 'kind = "none"')
write("no_torque", re.sub(r"effort = \{.*\n", "", without_torque), recordings)
write("sign", with_change('side = "motor"\n', 'side = "motor"\nsign = -1\n'), recordings)
write("degrees", with_change('unit = "rad", side = "joint"', 'unit = "deg", side = "joint"'), recordings)
write("target", with_change('kind = "motor_torque"', 'kind = "target_torque"'), recordings)
