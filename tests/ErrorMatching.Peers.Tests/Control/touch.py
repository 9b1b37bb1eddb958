"""A touch probe in a virtual part, as a component of LinuxCNC's HAL: contact is true while the ball touches the wall of a slot. Only
the probe, tool 2, touches: a cutter must not trip it.

The slot is what a shop might have milled: two flanks, each with its own place and direction, and two round ends, each with its own
center and radius. It is open above z = 0.

usage: touch.py SLOT.json
"""
import json
import math
import sys
import time

import hal

with open(sys.argv[1], encoding="utf-8") as file:
    slot = json.load(file)
radius = slot["ballMm"] / 2


def room(x, y):
    """Distance of a place inside the slot from its wall, in mm; negative in the material."""
    if x < -slot["straightMm"] or x > slot["straightMm"]:
        end = slot["left" if x < 0 else "right"]
        return end["radius"] - math.hypot(x - end["x"], y - end["y"])
    return min(side(slot["top"], x, y), side(slot["bottom"], x, y))


def side(flank, x, y):
    angle = math.radians(flank["degrees"])
    return abs(flank["y"]) - math.copysign(1, flank["y"]) * (y * math.cos(angle) - x * math.sin(angle))


component = hal.component("touch")
for name in "xyz":
    component.newpin(name, hal.HAL_FLOAT, hal.HAL_IN)
component.newpin("tool", hal.HAL_S32, hal.HAL_IN)
component.newpin("contact", hal.HAL_BIT, hal.HAL_OUT)
component.ready()
while True:
    is_down = component["tool"] == 2 and component["z"] < 0
    component["contact"] = is_down and room(component["x"], component["y"]) <= radius
    time.sleep(0.0005)
