#!/usr/bin/env python3
"""Draws the icon of deploy/icon.svg as Windows and packages want it. Usage: icon.py FILE..., each FILE.ico or FILE.png

Needs no other package. Each pixel is the mean of 8 by 8 samples. In an .ico, small pictures are bitmaps, which every program reads; the largest is a PNG.
"""
import functools
import os
import re
import struct
import sys
import xml.etree.ElementTree
import zlib

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "deploy", "icon.svg")
SAMPLES = 8


def rgb(text):
    return tuple(bytes.fromhex(text.removeprefix("#")))


def corners(path):
    """The corners of a path of straight lines: M and L, H and V, each absolute or relative, and z."""
    found, x, y = [], 0.0, 0.0
    for command, numbers in re.findall(r"([A-Za-z])([^A-Za-z]*)", path):
        values = [float(n) for n in re.findall(r"-?[0-9.]+", numbers)]
        kind, relative = command.upper(), command.islower()
        if kind == "Z":
            continue
        if kind not in "MLHV":
            raise ValueError(f"{command} in {path}; expected M, L, H, V or z")
        while values:
            if kind != "V":
                x = values.pop(0) + (x if relative else 0)
            if kind != "H":
                y = values.pop(0) + (y if relative else 0)
            found.append((x, y))
    return found


def read():
    """Side, radius of the corners, color of the ground, and the polygons with their colors, the topmost first."""
    root = xml.etree.ElementTree.parse(SOURCE).getroot()
    rect, *paths = root
    side = float(rect.get("width"))
    if not rect.tag.endswith("rect") or [float(v) for v in root.get("viewBox").split()] != [0, 0, side, side]:
        raise ValueError(f"{SOURCE}: expected a square that fills the picture, and paths on it")
    return side, float(rect.get("rx")), rgb(rect.get("fill")), [(rgb(p.get("fill")), corners(p.get("d"))) for p in reversed(paths)]


SIDE, ROUND, GROUND, POLYGONS = read()


def inside(polygon, x, y):
    odd = False
    for (x1, y1), (x2, y2) in zip(polygon, polygon[1:] + polygon[:1]):
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            odd = not odd
    return odd


def color(x, y):
    dx = max(ROUND - x, x - (SIDE - ROUND), 0.0)
    dy = max(ROUND - y, y - (SIDE - ROUND), 0.0)
    if dx * dx + dy * dy > ROUND * ROUND:
        return None
    return next((c for c, polygon in POLYGONS if inside(polygon, x, y)), GROUND)


@functools.cache
def picture(size):
    """Rows of (red, green, blue, opacity), from the top."""
    rows = []
    for row in range(size):
        rows.append([])
        for column in range(size):
            total, count = [0, 0, 0], 0
            for i in range(SAMPLES * SAMPLES):
                x = (column + (i % SAMPLES + 0.5) / SAMPLES) * SIDE / size
                y = (row + (i // SAMPLES + 0.5) / SAMPLES) * SIDE / size
                found = color(x, y)
                if found:
                    total = [t + f for t, f in zip(total, found)]
                    count += 1
            mean = [(2 * t + count) // (2 * count) if count else 0 for t in total]
            rows[-1].append((*mean, (255 * count) // (SAMPLES * SAMPLES)))
    return rows


def bitmap(rows):
    size = len(rows)
    header = struct.pack("<IiiHHIIiiII", 40, size, 2 * size, 1, 32, 0, 0, 0, 0, 0, 0)
    pixels = b"".join(bytes((b, g, r, a)) for row in reversed(rows) for r, g, b, a in row)
    mask = bytes(((size + 31) // 32) * 4 * size)
    return header + pixels + mask


def png(rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    size = len(rows)
    raw = b"".join(b"\0" + bytes(v for pixel in row for v in pixel) for row in rows)
    # Stored, not compressed: the bytes are then the same whatever library compresses.
    blocks = [raw[i:i + 65535] for i in range(0, len(raw), 65535)]
    stored = b"".join(
        struct.pack("<BHH", i == len(blocks) - 1, len(b), len(b) ^ 0xFFFF) + b for i, b in enumerate(blocks))
    packed = b"\x78\x01" + stored + struct.pack(">I", zlib.adler32(raw))
    head = struct.pack(">IIBBBBB", size, size, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def icon():
    images = [(size, bitmap(picture(size))) for size in (16, 24, 32, 48)] + [(128, png(picture(128)))]
    at = 6 + 16 * len(images)
    entries = b""
    for size, data in images:
        entries += struct.pack("<BBBBHHII", size, size, 0, 0, 1, 32, len(data), at)
        at += len(data)
    return struct.pack("<HHH", 0, 1, len(images)) + entries + b"".join(data for _, data in images)


if __name__ == "__main__":
    if len(sys.argv) < 2 or any(name[-4:] not in (".ico", ".png") for name in sys.argv[1:]):
        sys.exit(__doc__)
    for name in sys.argv[1:]:
        with open(name, "wb") as file:
            file.write(icon() if name.endswith(".ico") else png(picture(int(SIDE))))
