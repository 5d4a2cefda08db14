#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Writes funnel.stl (binary, mm): an outlet tube, 6 wide and 6 high, under a cone that opens to 24 at z = 20. 32 sides.
import math
import struct

SIDES = 32
RINGS = [(3.0, 0.0), (3.0, 6.0), (12.0, 20.0)]  # radius, z


def point(ring, side):
    radius, z = RINGS[ring]
    angle = 2.0 * math.pi * (side % SIDES) / SIDES
    return (radius * math.cos(angle), radius * math.sin(angle), z)


triangles = []
for ring in range(len(RINGS) - 1):
    for side in range(SIDES):
        a, b = point(ring, side), point(ring, side + 1)
        c, d = point(ring + 1, side), point(ring + 1, side + 1)
        triangles += [(a, b, c), (b, d, c)]

with open("funnel.stl", "wb") as file:
    file.write(b"funnel of make_funnel.py, mm".ljust(80))
    file.write(struct.pack("<I", len(triangles)))
    for corners in triangles:
        file.write(struct.pack("<3f", 0.0, 0.0, 0.0))  # no normal: nobody needs it
        for corner in corners:
            file.write(struct.pack("<3f", *corner))
        file.write(b"\0\0")
