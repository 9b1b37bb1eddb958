#!/usr/bin/env python3
"""Prints src/ErrorMatching.Geometry/Numbers/ElementaryTables.cs: the constants and tables of the elementary functions.

Every value is a logarithm, a root, a sine or an arc tangent, calculated here with 480 digits by its Taylor series and rounded to doubles:
a first part of few bits, so that its products are exact, and a second part with the rest.

    tools/elementary.py > src/ErrorMatching.Geometry/Numbers/ElementaryTables.cs
"""
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 480


def arc_tangent(x):
    """x - x^3/3 + ..., after halving the angle until the series is short."""
    halvings = 0
    while abs(x) > Decimal("0.05"):
        x, halvings = x / (1 + (1 + x * x).sqrt()), halvings + 1
    term, total, n = x, Decimal(0), 1
    while abs(term) > Decimal(10) ** -470:
        total, term, n = total + term / n, -term * x * x, n + 2
    return total * 2**halvings


def sine_cosine(x):
    """Both Taylor series."""
    sums, term, n = [Decimal(0), Decimal(0)], Decimal(1), 0
    while abs(term) > Decimal(10) ** -470:
        sums[n % 2] += term if n % 4 < 2 else -term
        n += 1
        term = term * x / n
    return sums[1], sums[0]


def whole(x):
    """The nearest whole number."""
    return int((Fraction(x) + Fraction(1, 2)) // 1)


def multiple(x, places):
    """The nearest multiple of 2^-places, and the rest; both as doubles."""
    first = Fraction(whole(Fraction(x) * 2**places), 2**places)
    return float(first), float(Fraction(x) - first)


def few_bits(x, bits):
    """The nearest number of so many bits, and the rest."""
    if x == 0:
        return 0.0, 0.0
    places = bits
    while abs(Fraction(x)) * 2**places >= 2**bits:
        places -= 1
    while abs(Fraction(x)) * 2**places < 2 ** (bits - 1):
        places += 1
    return multiple(x, places)


def split(x, *places):
    """One part for each number of binary places, and a double with the rest."""
    parts, rest = [], Fraction(x)
    for p in places:
        part = Fraction(whole(rest * 2**p), 2**p)
        parts, rest = [*parts, float(part)], rest - part
    return [*parts, float(rest)]


def constant(name, value, summary):
    print(f"    /// <summary>{summary}</summary>")
    print(f"    public const double {name} = {value!r};\n")


def table(name, values, summary, last=False):
    print(f"    /// <summary>{summary}</summary>")
    print(f"    public static ReadOnlySpan<double> {name} => [")
    line = "       "
    for value in values:
        word = f" {value!r},"
        if len(line) + len(word) > 130:
            print(line)
            line = "       "
        line += word
    print(line)
    print("    ];" if last else "    ];\n")


pi = 4 * arc_tangent(Decimal(1))
ln2, ln10 = Decimal(2).ln(), Decimal(10).ln()

print(
    """namespace ErrorMatching.Geometry;

/// <summary>Constants and tables of the elementary functions, as tools/elementary.py calculates them.</summary>
/// <remarks>A number that needs more digits than a double has is a sum: a first part with few bits, so that its products are exact, and
/// the rest.</remarks>
internal static class ElementaryTables
{"""
)
high, low = multiple(ln2 / 64, 40)
constant("StepHigh", high, "ln 2 / 64, a multiple of 2^-40.")
constant("StepLow", low, "The rest of ln 2 / 64.")
constant("StepsPerUnit", float(64 / ln2), "64 / ln 2.")
high, low = multiple(ln2, 42)
constant("LogOfTwoHigh", high, "ln 2, a multiple of 2^-42.")
constant("LogOfTwoLow", low, "The rest of ln 2.")
high, low = few_bits(1 / ln10, 26)
constant("PerLogOfTenHigh", high, "1 / ln 10 in 26 bits.")
constant("PerLogOfTenLow", low, "The rest of 1 / ln 10.")
half = split(pi / 2, 32, 65, 98)
for name, value in zip(("QuarterTurnFirst", "QuarterTurnSecond", "QuarterTurnThird", "QuarterTurnRest"), half):
    constant(name, value, "A part of pi / 2; all but the rest have at most 33 bits.")
constant("QuarterTurnHigh", float(pi / 2), "pi / 2.")
constant("QuarterTurnLow", float(Fraction(pi / 2) - Fraction(float(pi / 2))), "The rest of pi / 2.")
constant("QuarterTurnsPerUnit", float(2 / pi), "2 / pi.")
digits = f"{whole(2 / pi * 2**1200):x}"
print("    /// <summary>2 / pi times 2^1200 in hexadecimal digits.</summary>")
print("    public const string QuarterTurnsPerUnitDigits =")
lines = [f'        "{digits[i:i + 100]}"' for i in range(0, len(digits), 100)]
print(" +\n".join([lines[0].replace('"', '"0', 1), *lines[1:]]) + ";\n")

powers = []
for j in range(64):
    value = (ln2 * j / 64).exp()
    powers += [float(value), float(Fraction(value) - Fraction(float(value)))]
table("Powers", powers, "2^(j/64) for j from 0 to 63: the nearest double, and the rest.")

logarithms = []
for i in range(91, 182):
    c = whole(Fraction(1024 * 128, i))
    high, low = multiple(-(Decimal(c) / 1024).ln(), 42)
    logarithms += [c / 1024, high, low]
table("Logarithms", logarithms, "For i from 91 to 181: c, which is 128/i in 11 bits; -ln c, a multiple of 2^-42; and the rest.")

sines = []
for j in range(52):
    for value in sine_cosine(Decimal(j) / 64):
        sines += few_bits(value, 26)
table("Sines", sines, "For j from 0 to 51: sine of j/64 in 26 bits, and the rest; its cosine in 26 bits, and the rest.")

arcs = []
for j in range(65):
    value = arc_tangent(Decimal(j) / 64)
    arcs += [float(value), float(Fraction(value) - Fraction(float(value)))]
table("Arcs", arcs, "Arc tangent of j/64 for j from 0 to 64: the nearest double, and the rest.", last=True)
print("}")
