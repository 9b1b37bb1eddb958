"""A touch probe in a virtual piece, as a component of LinuxCNC's HAL: contact is true while the ball touches the piece. Only the probe,
tool 2, touches: a cutter must not trip it. The piece is open above z = 0.

Its file is read again when it changes, and has one of two forms:
- a slot as a shop might have milled it: two flanks, each with its own place and direction, and two round ends, each with its own center
  and radius (slot.json);
- a polygon of material, "material", and how much further out the piece ends than the polygon, "allowanceMm".

usage: touch.py PIECE.json
"""
import json
import math
import os
import sys
import time

import hal


def side(flank, x, y):
    angle = math.radians(flank["degrees"])
    return abs(flank["y"]) - math.copysign(1, flank["y"]) * (y * math.cos(angle) - x * math.sin(angle))


class Slot:
    def __init__(self, slot):
        self.slot = slot

    def room(self, x, y):
        """Distance of a place inside the slot from its wall, in mm; negative in the material."""
        slot = self.slot
        if x < -slot["straightMm"] or x > slot["straightMm"]:
            end = slot["left" if x < 0 else "right"]
            return end["radius"] - math.hypot(x - end["x"], y - end["y"])
        return min(side(slot["top"], x, y), side(slot["bottom"], x, y))


class Polygon:
    def __init__(self, piece):
        corners = piece["material"]
        self.allowance = piece["allowanceMm"]
        self.edges = [
            (ax, ay, bx - ax, by - ay, (bx - ax) ** 2 + (by - ay) ** 2)
            for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1])
        ]

    def room(self, x, y):
        """Distance of a place outside of the piece from it, in mm; negative in the material."""
        nearest = math.inf
        inside = False
        for ax, ay, dx, dy, square in self.edges:
            px, py = x - ax, y - ay
            t = (px * dx + py * dy) / square
            if t < 0:
                t = 0
            elif t > 1:
                t = 1
            ex, ey = px - t * dx, py - t * dy
            distance = ex * ex + ey * ey
            if distance < nearest:
                nearest = distance
            if (py < 0) != (py < dy) and px < py / dy * dx:
                inside = not inside
        distance = math.sqrt(nearest)
        return (-distance if inside else distance) - self.allowance


def read(name):
    with open(name, encoding="utf-8") as file:
        piece = json.load(file)
    return piece["ballMm"] / 2, Polygon(piece) if "material" in piece else Slot(piece)


# Before all others: a hundredth of a second late is a micrometer at the slowest feed.
os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(20))
component = hal.component("touch")
for name in "xyz":
    component.newpin(name, hal.HAL_FLOAT, hal.HAL_IN)
component.newpin("tool", hal.HAL_S32, hal.HAL_IN)
component.newpin("contact", hal.HAL_BIT, hal.HAL_OUT)
component.ready()
changed = None
while True:
    now = os.stat(sys.argv[1]).st_mtime_ns
    if now != changed:
        changed = now
        radius, piece = read(sys.argv[1])
    is_down = component["tool"] == 2 and component["z"] < 0
    component["contact"] = is_down and piece.room(component["x"], component["y"]) <= radius
    time.sleep(0.0005)
