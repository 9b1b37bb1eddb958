#!/usr/bin/env python3
"""Attacks tools/judge.py: true results must be accepted, and mutants rejected.

    attack.py FOLDER [--mutants N] [--seed N]

FOLDER holds NAME.base, NAME.result and NAME.json (a certificate) for each true result. Three kinds of mutants, N of each:

    kept       one increment, sign, byte, word or block of one of the three files differs; nothing else is touched
    hashed     the same, and the attacker repairs all hashes: of the files, of the marker, and the seal
    measured   one coordinate of a result differs, by 1 to 200 increments or its sign, and the attacker also repairs everything that the
               certificate measured, so that only the wish speaks against it

Every mutant of the first kind must be rejected. Of the second, only what the dialect says may change unnoticed, because nothing in the
three files repeats it. Of the third, a mutant must be rejected if it moves an element across by more than two tolerances: the true
result is within one, and the judge accepts one. This file measures that with binary numbers of its own.
"""
import argparse
import hashlib
import importlib.util
import json
import math
import pathlib
import random
import re
import sys
import time
from collections import Counter
from decimal import Decimal, localcontext

sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("judge", pathlib.Path(__file__).parents[2] / "tools" / "judge.py")
judge = importlib.util.module_from_spec(spec)
spec.loader.exec_module(judge)

COORDINATE = re.compile(rb"(?<![A-Za-z])([XYZIJKR]|CR=|[XYZIJK]=(?:AC|IC)\()(=?)([+-]?[0-9]*\.?[0-9]+\.?)")
JSON_NUMBER = re.compile(rb"(?<=[\[:,])-?[0-9]+(?:\.[0-9]+)?(?:E-?[0-9]+)?(?=[\],}])")
WORD = re.compile(rb"[A-Za-z][+-]?[0-9.]+ ?")
JSON_WORD = re.compile(rb'"[A-Za-z0-9.-]+"')


def replaced(data, start, end, new):
    return data[:start] + new + data[end:]


def any_of(pattern, data, dice):
    found = list(pattern.finditer(data))
    return dice.choice(found) if found else None


def stepped(text, steps, dice):
    """A number of a program, some increments of 0.001 larger."""
    value = Decimal(text.decode()) + steps * Decimal("0.001")
    return format(value, "f").encode()


def mutate(data, kind, dice, is_json):
    """One mutant of a file; None if the file has nothing of this kind."""
    if kind == "byte":
        at = dice.randrange(len(data))
        return replaced(data, at, at + 1, bytes([dice.choice([b for b in range(32, 127) if b != data[at]])]))
    if kind == "block":
        lines = data.splitlines(keepends=True)
        at = dice.randrange(len(lines))
        how = dice.randrange(3)
        if how == 0:
            del lines[at]
        elif how == 1:
            lines.insert(at, lines[at])
        else:
            to = dice.randrange(len(lines))
            lines[at], lines[to] = lines[to], lines[at]
        return b"".join(lines)
    if kind == "word":
        found = any_of(JSON_WORD if is_json else WORD, data, dice)
        if found is None:
            return None
        if is_json:
            other = any_of(JSON_WORD, data, dice).group()
            return replaced(data, *found.span(), other if dice.random() < 0.7 else b'"' + other[1:-1][::-1] + b'"')
        if dice.random() < 0.5:
            return replaced(data, *found.span(), b"")
        return replaced(data, found.start(), found.start() + 1, dice.choice([b"X", b"Y", b"Z", b"G", b"M", b"F", b"I"]))
    found = any_of(JSON_NUMBER if is_json else COORDINATE, data, dice)
    if found is None:
        return None
    start, end = found.span() if is_json else found.span(3)
    text = data[start:end]
    if kind == "sign":
        if Decimal(text.decode()) == 0:
            return None
        return replaced(data, start, end, text[1:] if text.startswith(b"-") else b"-" + text)
    step = dice.choice((1, -1))
    if is_json and b"." not in text and text != b"0":
        return replaced(data, start, end, str(int(Decimal(text.decode())) + step).encode())
    return replaced(data, start, end, stepped(text, step, dice))


def sealed(certificate):
    at = certificate.rfind(b'  "seal": "')
    if at < 0:
        return certificate
    return certificate[:at] + b'  "seal": "' + hashlib.sha256(certificate[:at]).hexdigest().encode() + b'"\n}\n'


def hashed(base, result, certificate, true):
    """The attacker repairs the hashes of the files, of the marker and the seal."""
    old, new = (hashlib.sha256(data).hexdigest().encode() for data in (true[0], base))
    result, certificate = (data.replace(old.upper(), new.upper()).replace(old, new) for data in (result, certificate))
    old, new = (hashlib.sha256(data).hexdigest().encode() for data in (true[1], result))
    return base, result, sealed(certificate.replace(old, new))


def interpreted(program, document, is_base=False):
    lines = judge.split(program)
    if document["marker"] is not None and not is_base:
        del lines[int(document["marker"]["line"]) - 1]
    with localcontext(judge.EXACT):
        blocks = [(n, judge.tokenize(line, document["dialect"]["syntax"], n)) for n, (line, _) in enumerate(lines, 1)]
        return judge.interpret(blocks, document["dialect"])[0]


class Numbers(json.JSONEncoder):
    def default(self, value):
        return float(value)


def slides(was, now, increment):
    """Whether a neighbor is where it was, so that the attacker has to call it so."""
    if was.is_arc():
        arc = judge.Arc(was)
        on_it = all(arc.circle.distance(p) <= Decimal("1.6") * increment + judge.NOISE + arc.mismatch for p in now.ends())
        return on_it and (now.center - was.center).norm() <= 3 * increment
    start, end = was.ends()
    line = judge.Line(start, (end - start).unit())
    return all(line.distance(p) <= Decimal("0.75") * increment + judge.NOISE for p in now.ends())


def measured(was, now, result, certificate):
    """The attacker repairs all that the certificate measured: rest, what fixes the ends, and how neighbors moved."""
    document = judge.read_certificate(certificate)
    index = {m.line: i for i, m in enumerate(was)}
    with localcontext(judge.ROUNDED):
        def by(i, end, size):
            a, b = ((m.end if end else m.start) for m in (was[i], now[i]))
            move = [judge.ZERO if q is None or p is None else q - p for p, q in zip(a, b)]
            return list(move if size == 3 else was[i].at(move))
        known = {e["line"] for e in document["moved"]}
        for i, motion in enumerate(was):
            moved = any(by(i, False, 3)) or any(by(i, True, 3)) or motion.center != now[i].center
            if moved and motion.line not in known:
                document["moved"].append({"line": motion.line, "block": motion.block, "moved": {},
                                          "as": "follows" if motion.cuts() or motion.upright else "positioning"})
        document["moved"].sort(key=lambda e: e["line"])
        for e in list(document["moved"]):
            i = index[e["line"]]
            if "moved" in e:
                if e["as"] in ("slides", "follows") and document["wish"] == "elements":
                    e["as"] = "slides" if slides(was[i], now[i], document["leastIncrementMm"]) else "follows"
                e["moved"] = {"start": by(i, False, 3), "end": by(i, True, 3)}
                if was[i].is_arc():
                    e["moved"]["center"] = list(now[i].center - was[i].center)
                if not any(e["moved"]["start"] + e["moved"]["end"]) and was[i].center == now[i].center:
                    document["moved"].remove(e)
            elif e["as"] == "point":
                e["rest"] = [m - w for m, w in zip(by(i, True, 3), e["by"])]
                if was[i].is_arc():
                    e["center"] = list(now[i].center - was[i].center)
            elif "rest" in e:
                moves = {"start": by(i, False, 2), "end": by(i, True, 2)}
                if was[i].is_arc():
                    moves["middle"] = list(judge.Arc(now[i]).middle - judge.Arc(was[i]).middle)
                e["rest"] = {n: [m - w for m, w in zip(moves[n], e[n])] for n in moves}
                for n in ("start", "end"):
                    if n + "By" in e:
                        near = judge.V(*e["rest"][n]).norm() <= document["leastIncrementMm"] + judge.NOISE
                        e[n + "By"] = "wish" if near else "meets"
        named = {e["line"] for e in document["moved"]}
        runs = []
        for i, motion in enumerate(was):
            if motion.line not in named:
                if runs and runs[-1][2] == i - 1:
                    runs[-1][1:] = [motion.line, i]
                else:
                    runs.append([motion.line, motion.line, i])
        document["fixed"] = [run[:2] for run in runs]
    document["resultSha256"] = hashlib.sha256(result).hexdigest()
    text = "{\n" + "".join(f'  "{n}": {json.dumps(v, cls=Numbers)},\n' for n, v in document.items() if n != "seal")
    return sealed(text.encode() + b'  "seal": ""\n}\n')


def plane(motion, place):
    return complex(*(float(c) for c in motion.at(place)))


def circle_points(motion):
    """Start, middle and end of an arc, by angles."""
    start, end, center = plane(motion, motion.start), plane(motion, motion.end), complex(*map(float, motion.center))
    turn = 1 if motion.kind == "G3" else -1
    sweep = (turn * (math.atan2((end - center).imag, (end - center).real) - math.atan2((start - center).imag, (start - center).real)))
    sweep = sweep % (2 * math.pi) or 2 * math.pi
    middle = center + (start - center) * complex(math.cos(sweep / 2), turn * math.sin(sweep / 2))
    return start, middle, end


def across(true, mutant, document):
    """How far a mutant moved named elements across, in multiples of two tolerances; infinite where something unnamed moved."""
    named = {int(e["line"]): e["as"] for e in document["moved"] if e["as"] in judge.NAMED}
    increment, worst = float(document["leastIncrementMm"]), 0.0
    for index, (a, b) in enumerate(zip(true, mutant)):
        if (a.start, a.end, a.center) == (b.start, b.end, b.center):
            continue
        role = named.get(a.line)
        if a.kind != b.kind:
            return math.inf
        if None in (*a.start, *a.end):
            continue
        height = 2 if a.upright else a.plane[2]
        if role != "point" and (a.start[height], a.end[height]) != (b.start[height], b.end[height]):
            return math.inf
        if role == "line" or role == "point" and not a.is_arc():
            start, end = plane(a, a.start), plane(a, a.end)
            if role == "point":
                off = max(abs(float(p - q)) for p, q in zip(a.end, b.end))
                worst = max(worst, off / (2 * (0.5 * increment + 1e-6)))
                continue
            direction = (end - start) / abs(end - start)
            for place, at in ((plane(b, b.start), start), (plane(b, b.end), end)):
                worst = max(worst, abs(((place - at) * direction.conjugate()).imag) / (2 * (0.75 * increment + 1e-6)))
        elif role in ("arc", "fillet"):
            center = complex(*map(float, a.center))
            start, middle, end = circle_points(a)
            radius, mismatch = abs(start - center), abs(abs(start - center) - abs(end - center))
            for place in circle_points(b):
                off = abs(abs(place - center) - radius)
                worst = max(worst, off / (2 * (1.6 * increment + 1e-6 + 2 * mismatch)))
        elif role is None:
            # An upright arc that leads to a contour goes along as one.
            shift = [q - p for p, q in zip(a.start, b.start)]
            if a.upright and (shift != [q - p for p, q in zip(a.end, b.end)] or b.center - a.center != a.at(shift)):
                return math.inf
            # An unnamed motion may follow at an end that it shares with a named one, over moves along the tool axis.
            held = []
            for step in (-1, 1):
                beside = index + step
                while 0 <= beside < len(true) and true[beside].goes_along():
                    beside += step
                held.append(0 <= beside < len(true) and true[beside].line in named)
            moved = a.start != b.start, a.end != b.end
            if any(m and not h for m, h in zip(moved, held)) if not a.goes_along() else not any(held):
                return math.inf
    return worst


def load(folder):
    cases = []
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        cases.append((path.stem, tuple(path.with_suffix(end).read_bytes() for end in (".base", ".result", ".json"))))
    return cases


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--mutants", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    dice, wrong, cases = random.Random(options.seed), [], load(options.folder)
    clock = time.monotonic()
    unsure = Counter()
    for name, files in cases:
        answer, reason = judge.judge(*files)
        unsure[answer] += 1
        if answer != "yes":
            wrong.append(f"{name}: a true result was not accepted: {answer}: {reason}")
    print(f"true: {len(cases)}, accepted {unsure['yes']} ({time.monotonic() - clock:.1f} s)", flush=True)
    moving = [case for case in cases if case[1][0] != case[1][1]]

    clock, answers = time.monotonic(), Counter()
    kinds = [(kind, file) for kind in ("increment", "sign", "byte", "word", "block") for file in range(3)]
    for mode in ("kept", "hashed"):
        clock, answers, done = time.monotonic(), Counter(), 0
        while done < options.mutants:
            (name, true), (kind, file) = dice.choice(moving), kinds[done % len(kinds)]
            mutant = mutate(true[file], kind, dice, file == 2)
            if mutant is None or mutant == true[file]:
                continue
            files = tuple(mutant if i == file else data for i, data in enumerate(true))
            if mode == "hashed":
                files = hashed(*files, true)
                if files == true:
                    continue
            done += 1
            answer, _ = judge.judge(*files)
            answers[answer] += 1
            if answer == "yes":
                fact = None if mode == "kept" else harmless(files[2], true[2]) if file == 2 else spelling(files[file], true[file])
                answers[fact] += 1
                if fact is None:
                    wrong.append(f"{name}: {mode}, {kind} of {('base', 'result', 'certificate')[file]} was accepted: "
                                 f"{difference(files[file], true[file])}")
        print(*wrong[:20], sep="\n", end="\n" if wrong else "")
        print(f"{mode}: {done} mutants, rejected {answers['no'] + answers['cannot judge']} (no {answers['no']}, cannot judge "
              f"{answers['cannot judge']}); accepted with another fact of the dialect {answers['fact']}, other digits below 0.00001 "
              f"{answers['digit']}, other true words {answers['word']}, other blanks {answers['blank']}, same numbers spelled otherwise "
              f"{answers['spelling']} "
              f"({time.monotonic() - clock:.1f} s)", flush=True)

    clock, done, found, missed, inside, largest, cache = time.monotonic(), 0, 0, 0, 0, 0.0, {}
    while done < options.mutants:
        name, true = dice.choice(moving)
        at = any_of(COORDINATE, true[1], dice)
        start, end = at.span(3)
        size = dice.choice((1, 1, 1, 2, 3, 5, 10, 20, 50, 200, 0))
        text = true[1][start:end]
        new = stepped(text, dice.choice((size, -size)), dice) if size else text[1:] if text[:1] == b"-" else b"-" + text
        result = replaced(true[1], start, end, new)
        if name not in cache:
            document = judge.read_certificate(true[2])
            cache[name] = document, interpreted(true[0], document, is_base=True), interpreted(true[1], document)
        document, base, was = cache[name]
        try:
            now = interpreted(result, document)
            certificate = measured(base, now, result, true[2])
        except (judge.No, judge.Beyond):
            done, found = done + 1, found + 1
            continue
        if all((a.start, a.end, a.center) == (b.start, b.end, b.center) for a, b in zip(was, now)):
            continue
        done += 1
        answer, reason = judge.judge(true[0], result, certificate)
        off = across(was, now, document)
        if answer == "yes":
            inside += 1
            largest = max(largest, off)
            if off > 1:
                missed += 1
                wrong.append(f"{name}: measured, {off:.2f} times two tolerances were accepted: {difference(result, true[1])}")
        else:
            found += 1
    print(f"measured: {done} mutants, rejected {found}, accepted inside the tolerance {inside}, accepted beyond it {missed}; the largest "
          f"accepted {largest:.3f} of two tolerances ({time.monotonic() - clock:.1f} s)", flush=True)
    for line in wrong[:20]:
        print(line)
    print(f"{len(wrong)} wrong")
    return 1 if wrong or not cases else 0


def difference(a, b):
    lines = [(x, y) for x, y in zip(a.splitlines(), b.splitlines()) if x != y]
    return " instead of ".join(ascii(line.decode("latin-1")) for line in lines[0]) if lines else "another length"


def spelling(program, true):
    """The word for a mutant of a program in which all numbers are the same, only spelled otherwise: +.404 for 0.404."""
    texts = [re.sub(judge.DIGITS, lambda n: b"%.9f" % float(n.group()), data) for data in (program, true)]
    return "spelling" if texts[0] == texts[1] else None


def harmless(certificate, true):
    """Why a sealed mutant of a certificate may stay: only blanks, a fact of the dialect, a word for a neighbor that is true as well, or
    numbers below the noise differ."""
    if json.loads(certificate) | {"seal": ""} == json.loads(true) | {"seal": ""}:
        return "blank"
    lines = [(a, b) for a, b in zip(certificate.splitlines(), true.splitlines()) if a != b and not b.startswith(b'  "seal"')]
    if all(b.startswith(b'  "dialect"') for _, b in lines):
        return "fact"
    words = re.compile(rb'"(slides|follows|followed-fillet|positioning)"')
    if all(words.sub(b"", a) == words.sub(b"", b) for a, b in lines):
        return "word"
    for a, b in lines:
        numbers = [[Decimal(n.decode()) for n in JSON_NUMBER.findall(line)] for line in (a, b)]
        rest = [JSON_NUMBER.sub(b"", line) for line in (a, b)]
        if rest[0] != rest[1] or any(abs(x - y) > judge.NOISE * 10 for x, y in zip(*numbers)):
            return None
    return "digit"


if __name__ == "__main__":
    sys.exit(main())
