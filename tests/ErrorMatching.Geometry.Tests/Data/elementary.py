#!/usr/bin/env python3
"""Prints elementary.csv: arguments of elementary functions and distributions, and their values to 40 digits by mpmath.

Half of the arguments are at random. The others are the hardest of many: their values are the nearest to the middle of two doubles.

    tests/ErrorMatching.Geometry.Tests/Data/elementary.py > tests/ErrorMatching.Geometry.Tests/Data/elementary.csv
"""
import math
import random

import mpmath
from mpmath import mp, mpf

mp.prec = 1300
random.seed(20)


def spread(low, high):
    return random.choice((1, -1)) * math.exp(random.uniform(math.log(low), math.log(high)))


def power():
    x = math.exp(random.uniform(-300, 300))
    near = 1 + spread(1e-10, 0.5)
    x = random.choice((x, near, random.uniform(0, 200)))
    return x, random.uniform(-600, 600) / math.log(x)


def turns():
    k = random.randint(1, 600000)
    return random.choice((random.uniform(-10, 10), spread(1e-12, 1e6), spread(1e6, 1e308), float(k * mpmath.pi / 2))), 0.0


def share():
    return random.choice((random.uniform(-1, 1), spread(1e-16, 0.99), 1 - abs(spread(1e-16, 1)))), 0.0


def point():
    a = spread(1e-150, 1e150)
    near = (random.uniform(-10, 10), random.uniform(-10, 10))
    return random.choice((near, (a, a * random.uniform(0.01, 100)), (a, -spread(1e-150, 1e150))))


def positive():
    return random.choice((math.exp(random.uniform(-700, 700)), 1 + spread(1e-16, 0.5))), 0.0


FUNCTIONS = {
    "Exp": (lambda x, y: mpmath.exp(x), lambda: (random.choice((random.uniform(-600, 700), spread(1e-20, 1))), 0.0)),
    "Log": (lambda x, y: mpmath.log(x), positive),
    "Log10": (lambda x, y: mpmath.log(x) / mpmath.log(10), positive),
    "Pow": (mpmath.power, power),
    "Sin": (lambda x, y: mpmath.sin(x), turns),
    "Cos": (lambda x, y: mpmath.cos(x), turns),
    "Tan": (lambda x, y: mpmath.tan(x), turns),
    "Asin": (lambda x, y: mpmath.asin(x), share),
    "Acos": (lambda x, y: mpmath.acos(x), share),
    "Atan": (lambda x, y: mpmath.atan(x), lambda: (random.choice((random.uniform(-3, 3), spread(1e-200, 1e200))), 0.0)),
    "Atan2": (mpmath.atan2, point),
}

# The double that is nearest to a multiple of pi/2 (W. Kahan).
NEAREST = float(6381956970095103 * 2**797)


def from_middle(value):
    """How far a value is from the middle of two doubles, in units of the last place."""
    mantissa, _ = mpmath.frexp(abs(value))
    scaled = mantissa * 2**53
    return abs(scaled - mpmath.floor(scaled) - 0.5)


def row(name, x, y, value):
    print(f"{name},{x!r},{y!r},{mpmath.nstr(value, 40, min_fixed=0, max_fixed=0)}")


for name, (function, draw) in FUNCTIONS.items():
    tried = []
    for _ in range(1500):
        x, y = draw()
        value = function(mpf(x), mpf(y))
        if value != 0 and 1e-280 < abs(value) < 1e300:
            tried.append((x, y, value))
    extra = [(NEAREST, 0.0, function(mpf(NEAREST), mpf(0)))] if name in ("Sin", "Cos", "Tan") else []
    for x, y, value in extra + tried[:20] + sorted(tried[20:], key=lambda t: from_middle(t[2]))[:20]:
        row(name, x, y, value)

for z in (-30.0, -8.3, -5.0, -2.0, -1.51, -1.49, -0.7, -1e-9, 0.3, 1.4, 1.6, 2.5, 4.0):
    row("NormalBelow", z, 0.0, mpmath.erfc(-mpf(z) / mpmath.sqrt(2)) / 2)
for p in (1e-12, 0.0001, 0.01, 0.05, 0.2, 0.4999, 0.6, 0.75, 0.95, 0.999):
    row("NormalQuantile", p, 0.0, mpmath.sqrt(2) * mpmath.erfinv(2 * mpf(p) - 1))
mp.prec = 200
for x, values in ((0.5, 1), (3.84, 1), (40.0, 1), (1.0, 2), (5.99, 2), (0.1, 3), (7.81, 3), (18.3, 10), (1.0, 10), (67.5, 50), (31.0, 51),
                  (1074.0, 1000), (2000.0, 1999), (5000.0, 4801), (90.0, 7)):
    row("ChiSquaredAbove", x, float(values), mpmath.gammainc(mpf(values) / 2, mpf(x) / 2, mpmath.inf, regularized=True))
