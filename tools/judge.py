#!/usr/bin/env python3
"""A second judge of displaced NC programs.

    judge.py BASE RESULT CERTIFICATE

It answers whether RESULT differs from BASE only as CERTIFICATE says: "yes" (exit 0), "no" with block and reason (exit 1), or
"cannot judge" (exit 2) where the programs leave the plain subset: G0 to G3, G90 and G91, G17 to G19, I, J, K, R and CR, modal words.
It shares no code with ErrorMatching: its tokenizer, its interpreter (exact decimals) and its geometry (34 digits) are its own.
docs/prove-a-program.md describes the certificate and what is checked. Lengths are in mm.
"""
import hashlib
import json
import re
import sys
from collections import namedtuple
from decimal import Context, Decimal, Inexact, InvalidOperation, localcontext
from itertools import groupby

SCHEMA = "errormatch/certificate/1"
EXACT, ROUNDED = Context(prec=60, traps=[Inexact, InvalidOperation]), Context(prec=34, traps=[InvalidOperation])
ZERO, ONE, SMALLEST = Decimal(0), Decimal(1), Decimal("0.001")  # the last: a difference of radii that every control accepts
NOISE, SAME = Decimal("1e-6"), Decimal("1e-9")  # what a certificate's binary numbers may be off; places closer than this are one
TANGENT, CORNER = Decimal("0.099"), Decimal("0.0089")  # sines: below, two cuts are tangent; above, they fix a joint if they move apart
STEP, FURTHEST = Decimal("0.0004"), 13  # displacements that differ by no more are equal; how far a corner may go, in displacements
MM, COARSEST = {"mm": ONE, "inch": Decimal("25.4")}, {"mm": Decimal("0.001"), "inch": Decimal("0.00254")}

class No(Exception): """The result is not what the certificate says."""
class Beyond(Exception): """The programs leave the plain subset."""

def need(condition, reason, block=""):
    if not condition:
        raise No(f"{block}: {reason}" if block else reason)
def beyond(condition, reason, line=0):
    if condition:
        raise Beyond(f"line {line}: {reason}" if line else reason)

# Text: tokens that together are the line, byte for byte.
DIGITS = rb"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)"
NUMBER = re.compile(DIGITS)
PLAIN = rb"(?P<space>[ \t]+)|(?P<percent>%)|(?P<letter>[A-Za-z])(?P<value>" + DIGITS + rb")|"
ASSIGNED = rb"(?P<name>CR|[XYZIJKFS])=(?:(?P<how>AC|IC)\((?P<inner>" + DIGITS + rb")\)|(?P<set>" + DIGITS + rb"))|"
TOKENS = {
    "iso": re.compile(PLAIN + rb"(?P<comment>\([^()]*\))"),
    "linux-cnc": re.compile(PLAIN + rb"(?P<comment>\([^()]*\)|;.*)"),
    "siemens": re.compile(PLAIN + ASSIGNED + rb"(?P<comment>;.*)"),
}
HEAD = re.compile(rb"[ \t]*(?:%|[Oo:][0-9]+)?[ \t]*(?:\([^()]*\)|;.*)?[ \t]*\Z")

Token = namedtuple("Token", "text letter value how")  # the letter is X, CR, %, or empty for blanks and comments; how is IC or AC

def tokenize(line, syntax, number):
    tokens, at = [], 0
    while at < len(line):
        found = TOKENS[syntax].match(line, at)
        beyond(found is None, f"{ascii(line[at:at + 12].decode('latin-1'))} is not a plain word", number)
        part = found.groupdict()
        letter, value = part.get("name") or part["letter"], part["value"] or part.get("inner") or part.get("set")
        letter = letter.decode().upper() if letter else "%" if part["percent"] else ""
        tokens.append(Token(found.group(), letter, Decimal((value or b"0").decode()), part.get("how") or b""))
        at = found.end()
    return tokens

def split(program):
    """The lines of a program, each as its text and its end."""
    lines = [re.fullmatch(rb"(.*?)(\r?\n|)", line, re.DOTALL).groups() for line in re.findall(rb"[^\n]*\n|[^\n]+\Z", program)]
    need(b"".join(text + end for text, end in lines) == program, "a program that cannot be split into lines")
    for number, (text, _) in enumerate(lines, 1):
        beyond(re.search(rb"[\x00-\x08\x0a-\x1f\x7f]", text), "a control character", number)
    return lines

# Meaning: the dialect, as the certificate states it, must say what is written here.
MOVES = {"G0": "rapid", "G1": "line", "G2": "arc-clockwise", "G3": "arc-counter-clockwise"}
PLANES = {"G17": (0, 1, 2), "G18": (2, 0, 1), "G19": (1, 2, 0)}  # first and second axis, height
UNITS = {"G20": "inch", "G70": "inch", "G700": "inch", "G21": "metric", "G71": "metric", "G710": "metric"}
DISTANCES = {"G90": "absolute", "G91": "incremental"}
CENTERS = {"G90.1": "absolute-centers", "G91.1": "incremental-centers"}
OFFSETS = {f"G{n}": "work-offset" for n in range(54, 60)}
GROUPS = {"move": MOVES, "plane": PLANES, "unit": UNITS, "distance": DISTANCES, "centers": CENTERS, "offset": OFFSETS}
KNOWN = {
    **MOVES, **UNITS, **DISTANCES, **CENTERS, **OFFSETS, "G17": "plane-xy", "G18": "plane-zx", "G19": "plane-yz", "G4": "dwell",
    "G28": "reference-return", "G40": "compensation-off", "G43": "length-offset", "G49": "length-offset-off", "G80": "cycle-off",
    "G94": "feed-per-minute", "G95": "feed-per-revolution", "G98": "retract-to-initial", "G99": "retract-to-r", "G15": "polar-off",
    "G50": "scaling-off", "G69": "rotation-off", **{f"G{n}": "harmless" for n in (9, 61, 62, 64, 96, 97)},
}
WORDS = {"X", "Y", "Z", "I", "J", "K", "R", "CR", "N", "F", "S", "T", "H", "D"}
CALLS, ENDS = {"M17", "M96", "M97", "M98", "M99", "M198", "M199"}, {"M2", "M30"}

class Motion(namedtuple("Motion", "line block kind plane unit upright start end center radius", defaults=(None, None))):
    """Places are None where the program does not say them; the radius is the programmed one. An upright arc leads to contours in XY."""
    def at(self, place): return V(place[self.plane[0]], place[self.plane[1]])
    def ends(self): return self.at(self.start), self.at(self.end)
    def is_known(self): return None not in (*self.at(self.start), *self.at(self.end))
    def is_arc(self): return self.kind in ("G2", "G3")
    def in_plane(self): return self.is_arc() or self.at(self.start) != self.at(self.end)
    def cuts(self): return self.kind in ("G1", "G2", "G3") and self.in_plane() and not self.upright
    def goes_along(self): return self.upright or not self.in_plane()

def interpret(blocks, facts):
    """The motions of a program, the joints at which a tool was changed, and the codes and functions that ran."""
    mode = {"move": None, "plane": "G17", "distance": "G90", "unit": "G21", "centers": "G91.1", "offset": None}
    place, motions, changes, codes = [None] * 3, [], [], set()
    flat = fresh = False  # contours are in XY, though another plane came with an arc; such a plane was stated and nothing moved since
    for number, tokens in blocks:
        words, run = {}, []
        for token in tokens:
            code = token.letter + format(token.value.normalize(), "f")
            if token.letter in ("G", "M"):
                run.append(code)
                beyond(token.letter == "G" and code not in KNOWN or code in CALLS, f"{code} is not in the plain subset", number)
            elif token.letter in ("O", "%"):
                beyond(motions or codes or sum(bool(t.letter) for t in tokens) > 1, "a name among the blocks", number)
            elif token.letter:
                beyond(token.letter in words or token.letter not in WORDS, f"the word {token.text.decode()}", number)
                words[token.letter] = token
        before = mode["offset"]
        for name, table in GROUPS.items():
            chosen = [code for code in run if code in table]
            beyond(len(chosen) > 1, "two codes of one group", number)
            mode[name] = chosen[0] if chosen else mode[name]
        unit = "inch" if UNITS[mode["unit"]] == "inch" else "mm"
        place = place if mode["offset"] == before or not motions else [None] * 3
        codes |= set(run)
        if set(run) & set(PLANES):
            flat, fresh = flat or mode["plane"] == "G17", mode["plane"] != "G17"
        changes += [len(motions)] if "M6" in run else []
        axes, center = [w for w in "XYZ" if w in words], [w for w in ("I", "J", "K", "R", "CR") if w in words]
        beyond((axes or center) and "G4" in run or "R" in words and facts["syntax"] == "siemens", "words that move nothing", number)
        beyond(center and (not axes or mode["move"] not in ("G2", "G3")), "center words without an arc", number)
        if axes:
            beyond(mode["move"] is None, "a motion before the first of G0 to G3", number)
            start, kind = tuple(place), "G28" if "G28" in run else mode["move"]
            for axis, letter in enumerate("XYZ"):
                if letter in words:
                    word, length = words[letter], length_of(words[letter], unit, facts)
                    absolute = word.how == b"AC" or not word.how and mode["distance"] == "G90"
                    length = length if absolute else None if place[axis] is None else place[axis] + length
                    place[axis] = None if kind == "G28" else length
            name = words["N"].text.decode() if "N" in words else ""
            flat, fresh, turns = flat and (kind in ("G2", "G3") or not fresh), False, kind in ("G2", "G3")
            upright = flat and turns and mode["plane"] != "G17"
            plane = PLANES[mode["plane"] if turns or not flat else "G17"]
            motion = Motion(number, name, kind, plane, unit, upright, start, tuple(place))
            motions.append(arc(motion, words, center, mode, facts) if motion.is_arc() else motion)
        if ENDS & set(run):
            break
    return motions, changes, codes

def length_of(word, unit, facts):
    counts = facts["integersAreIncrements"] and b"." not in word.text
    return (word.value.scaleb(-facts["decimals"][unit]) if counts else word.value) * MM[unit]

def arc(motion, words, letters, mode, facts):
    """The motion with its center."""
    beyond(not motion.is_known(), "an arc from or to an unknown place", motion.line)
    own, (start, end) = ["IJK"[axis] for axis in motion.plane[:2]], motion.ends()
    if letters in (["R"], ["CR"]):
        radius = length_of(words[letters[0]], motion.unit, facts)
        with localcontext(ROUNDED):
            center = center_by_radius(start, end, radius, motion.kind == "G3", facts["arcMismatchMm"])
    else:
        beyond(not letters or not set(letters) <= set(own), "an arc with other words than its center or its radius", motion.line)
        radius, center = None, []
        for letter, begin in zip(own, start):
            word = words.get(letter, Token(b"0.", letter, ZERO, b""))
            absolute = word.how == b"AC" or not word.how and mode["centers"] == "G90.1"
            beyond(letter not in words and absolute, "half of an absolute center", motion.line)
            center.append((ZERO if absolute else begin) + length_of(word, motion.unit, facts))
        center = V(*center)
    beyond(center in (None, start, end), "words that describe no arc", motion.line)
    return motion._replace(center=center, radius=radius)
def center_by_radius(start, end, radius, left_turn, mismatch):
    length = (end - start).norm()
    if length == 0 or radius == 0 or length > 2 * abs(radius) + mismatch:
        return None
    height = max(ZERO, radius * radius - length * length / 4).sqrt() / length
    return start.mix(end) + (end - start).left() * (height if left_turn == (radius > 0) else -height)

# Geometry of the plane.
class V(namedtuple("V", "x y")):
    def __add__(self, o): return V(self.x + o.x, self.y + o.y)
    def __sub__(self, o): return V(self.x - o.x, self.y - o.y)
    def __mul__(self, k): return V(self.x * k, self.y * k)
    def dot(self, o): return self.x * o.x + self.y * o.y
    def cross(self, o): return self.x * o.y - self.y * o.x
    def left(self): return V(-self.y, self.x)
    def mix(self, o): return V((self.x + o.x) / 2, (self.y + o.y) / 2)
    def norm(self): return self.dot(self).sqrt()
    def unit(self):
        need(any(self), "a direction without a length")
        return self * (1 / self.norm())
class Line(namedtuple("Line", "through direction")):
    def distance(self, point): return abs(self.direction.cross(point - self.through))
    def parallel(self, left): return Line(self.through + self.direction.left() * left, self.direction)
    def meet(self, o, sine): return self.through + self.direction * ((o.through - self.through).cross(o.direction) / sine)
    def foot(self, point): return self.through + self.direction * self.direction.dot(point - self.through)
class Circle(namedtuple("Circle", "center radius")):
    def distance(self, point): return abs((point - self.center).norm() - self.radius)
def circle_through(a, b, c):
    ab, ac = b - a, c - a
    twice, to = 2 * ab.cross(ac), (ab * ac.dot(ac) - ac * ab.dot(ab)).left()
    return Circle(a + to * (1 / twice), to.norm() / abs(twice)) if twice else None
def halfway(u, v, left_turn):
    """The unit vector halfway from one to another in the direction of the turn; equal ones are a full turn apart."""
    along, across = u + v, (v - u).left() * (-1 if left_turn else 1)
    if u == v or along.dot(along) > across.dot(across):
        return (along if (u.cross(v) > 0) == left_turn and u != v else along * -1).unit()
    return across.unit()
class Arc:
    """An arc about its center with the radius of its start, known at its quarters."""
    def __init__(self, motion):
        (start, end), self.center, self.is_left = motion.ends(), motion.center, motion.kind == "G3"
        self.radius, self.is_full, self.ends = (start - self.center).norm(), start == end, (start, end)
        self.circle, self.mismatch = Circle(self.center, self.radius), abs(self.radius - (end - self.center).norm())
        middle = halfway(u := (start - self.center).unit(), v := (end - self.center).unit(), self.is_left)
        self.out = [u, halfway(u, middle, self.is_left), middle, halfway(middle, v, self.is_left), v]
        self.middle = self.center + middle * self.radius
    def furthest(self, circle):  # the largest distance from a circle: at an end, or where the line of both centers crosses a quarter
        line, turn = (self.center - circle.center).unit() if self.center != circle.center else None, 1 if self.is_left else -1
        outs = [out for out in (line, line * -1) for u, v in zip(self.out, self.out[1:])
                if min(u.cross(out) * turn, out.cross(v) * turn, out.dot(u + v)) >= 0] if line else []
        return max(circle.distance(place) for place in (*self.ends, *(self.center + out * self.radius for out in outs)))

# The certificate.
SEAL = re.compile(rb'  "seal": "([0-9a-f]{64})"\n\}\n\Z')
MEMBERS = ["schema", "baseSha256", "resultSha256", "dialect", "codes", "functions", "unit", "leastIncrementMm", "toleranceMm", "marker",
           "wish", "moved", "fixed", "motions", "seal"]
FACTS = ["name", "syntax", "integersAreIncrements", "decimals", "arcMismatchMm"]
ROLES = {
    "line": {"start", "end", "shift", "tilt", "rest", "startBy", "endBy"},
    "arc": {"start", "middle", "end", "center", "growth", "rest", "startBy", "endBy"},
    "fillet": {"start", "middle", "end", "rest"}, "shrunk": {"start", "end", "rest"}, "point": {"by", "rest"},
    "slides": {"moved"}, "follows": {"moved"}, "followed-fillet": {"moved"}, "positioning": {"moved"},
}
NAMED = {"line", "arc", "fillet", "shrunk", "point"}

def once(pairs):
    need(len(dict(pairs)) == len(pairs), "the certificate has a member twice")
    return dict(pairs)

def read_certificate(data):
    seal = SEAL.search(data)
    need(seal, "the certificate does not end with its seal")
    need(hashlib.sha256(data[:seal.start()]).hexdigest().encode() == seal.group(1), "the certificate's seal is broken")
    document = json.loads(data.decode("utf-8"), parse_float=Decimal, parse_int=Decimal, object_pairs_hook=once)
    need(document["schema"] == SCHEMA, f"this is not a certificate of the schema {SCHEMA}")
    need(list(document) == MEMBERS and list(document["dialect"]) == FACTS, "the certificate's members are not those of its schema")
    for entry in document["moved"]:
        members = set(entry) - ({"center"} if entry["as"] == "point" else set())
        need(members == ROLES[entry["as"]] | {"line", "block", "as"}, "a motion's members are not those of the schema", entry["block"])
    return document

def vector(values, size=2):
    need(len(values) == size and all(isinstance(v, Decimal) and v.is_finite() for v in values), "the certificate has a damaged vector")
    return V(*values) if size == 2 else tuple(values)
def near(a, b, within=NOISE):
    return all(abs(x - y) <= within for x, y in zip(a, b))

# The comparison of two programs. A joint is where a motion begins and the one before it ends.
class Comparison:
    def __init__(self, base, result, document, facts):
        (self.was, self.changes, codes), self.now, self.facts, self.document = base, result[0], facts, document
        need(len(self.was) == len(self.now) and result[1:] == base[1:], "codes, functions, tool changes or the number of motions differ")
        for i, (was, now) in enumerate(zip(self.was, self.now)):
            self.need(i, (was.line, *was[2:6]) == (now.line, *now[2:6]), "its kind differs")
        self.check_facts(codes)
        index, last, self.entries, self.arcs = {m.line: i for i, m in enumerate(self.was)}, 0, {}, {}
        for entry in document["moved"]:
            need(entry["line"] > last and self.was[index[entry["line"]]].block == entry["block"], "the certificate's blocks are others")
            last = entry["line"]
            self.entries[index[last]] = entry
        self.named = {i: e for i, e in self.entries.items() if e["as"] in NAMED}
        self.points = document["wish"] == "points"
        kinds = {"points" if entry["as"] == "point" else "elements" for entry in self.named.values()} | {document["wish"]}
        need(kinds in ({"points"}, {"elements"}), "the certificate's wish is of another kind")
        sizes = [vector(e[end]).norm() for e in self.named.values() if not self.points for end in ("start", "end")]
        self.reach = FURTHEST * max(sizes, default=ZERO) + 2 * self.increment
        was, now = ([motions[0].start, *(m.end for m in motions)] if motions else [] for motions in (self.was, self.now))
        need([[c is None for c in p] for p in was] == [[c is None for c in p] for p in now], "a coordinate is known in one program only")
        self.places = was
        self.moves = [tuple(ZERO if a is None else b - a for a, b in zip(p, q)) for p, q in zip(was, now)]
    def need(self, i, condition, reason): need(condition, reason, self.was[i].block or f"line {self.was[i].line}")
    def check_facts(self, codes):
        document, unit, self.increment = self.document, self.document["unit"], self.document["leastIncrementMm"]
        stated = document["codes"] | document["functions"]
        need(set(stated) == codes, "the certificate's codes are not the base's")
        for code, meaning in stated.items():
            own = KNOWN[code] if code[0] == "G" else "program-end" if code in ENDS else "harmless"
            beyond(own != meaning, f"{code} means {meaning} in this dialect")
        power = (self.increment / MM[unit]).normalize()
        self.decimals = -power.adjusted()
        need(power.as_tuple()[:2] == (0, (1,)) and self.decimals >= self.facts["decimals"][unit], "the increment is none of the dialect's")
        beyond(self.increment > COARSEST[unit], "an increment coarser than 0.001 mm or 0.0001 inch")
        # Both coordinates of an end are rounded, and so are those of a center.
        self.on_line, self.on_circle = Decimal("0.75") * self.increment + NOISE, Decimal("1.6") * self.increment + NOISE
        self.at_place, stated = self.increment + NOISE, document["toleranceMm"]  # an end that goes by the wish
        own = {"line": self.on_line, "arc": self.on_circle, "end": self.at_place}
        need(list(stated) == list(own) and near(stated.values(), own.values(), SAME), "the tolerances do not follow from the increment")
    def run(self, blocks, result_blocks):
        changed = {i for i, m in enumerate(self.was) if any(self.moves[i] + self.moves[i + 1]) or m.center != self.now[i].center}
        for i in range(len(self.was)):
            self.need(i, i in self.entries or i not in changed, "it moved, and the certificate does not say so")
            self.need(i, i in changed or i in self.named or i not in self.entries, "the certificate says that it moved, and it did not")
        runs = [list(run) for fixed, run in groupby(range(len(self.was)), lambda i: i not in self.entries) if fixed]
        fixed = [[self.was[run[0]].line, self.was[run[-1]].line] for run in runs]
        need(self.document["fixed"] == fixed, "the certificate's fixed motions are not those that stay")
        need(self.document["motions"] == len(self.was), "the certificate counts other motions")
        lines = {self.was[i].line: i for i in changed}
        for (line, before), (_, after) in zip(blocks, result_blocks):
            if before is not after:
                need(line in lines, "its bytes differ, and it did not move", f"line {line}")
                self.check_words(lines[line], before, after)
        self.allow_joints()
        for joint, move in enumerate(self.moves):
            self.need(joint - 1, not any(move) or joint in self.allowed, "an end moved, and nothing named is beside it")
        for i, entry in sorted(self.entries.items()):
            motion = self.was[i]
            beyond(motion.kind == "G28" and i in changed, "a way to a place of the machine moved", motion.line)
            beyond(not motion.is_known() and (i in self.named or motion.kind != "G0"), "a moved cut at an unknown place", motion.line)
            beyond(motion.unit != self.document["unit"], "motions that moved in another unit", motion.line)
            self.check_sense(i)
            getattr(self, "check_" + entry["as"].replace("-", "_"))(i, entry)
    def check_words(self, i, before, after):
        """Two blocks are the same but for values, words that are needed now, and a radius that became a center."""
        was, now = self.was[i], self.now[i]
        centers = {"IJK"[axis] for axis in was.plane[:2]} if was.is_arc() else set()
        changeable = {"X", "Y", "Z"} | centers | ({"R", "CR"} if was.is_arc() else set())
        olds, news = ({t.letter: t for t in tokens if t.letter in changeable} for tokens in (before, after))
        radius_gone = was.radius is not None and now.radius is None
        gone = {"R", "CR"} & set(olds) if radius_gone else set()
        self.need(i, set(olds) - set(news) == gone, "words are gone")
        lone, changed = set(olds) ^ set(news), {w for w in set(olds) & set(news) if olds[w].value != news[w].value}
        rests = [b"".join(self.rest_of(tokens, lone, changed)) for tokens in (before, after)]
        self.need(i, rests[0] == rests[1], "something other than the words of its new place changed")
        for letter in (lone | changed) - gone:
            token, old, axis = news[letter], olds.get(letter), "XYZ".find(letter)
            needed = now.start[axis] != now.end[axis] if axis >= 0 else letter in centers and (radius_gone or token.value)
            self.need(i, old or needed, "a word was inserted that nothing needs")
            finest = min(-self.decimals, old.value.as_tuple().exponent if old else 0)
            self.need(i, token.value.as_tuple().exponent >= finest, "a word is finer than the increment")
    @staticmethod
    def rest_of(tokens, lone, changed):
        """The text without the values that changed and the words that only one has, each with the one blank that separates it."""
        for k, token in enumerate(tokens):
            beside = tokens[k + 1].letter if k + 1 < len(tokens) else ""
            if not (token.letter in lone or token.text == b" " and beside in lone):
                yield NUMBER.sub(b"", token.text, count=1) if token.letter in changed else token.text

    # Joints that may move: ends of named motions, of fillets, of positioning that shares them, and where their contour closes.
    def allow_joints(self):
        self.allowed, self.partner = {i + 1 for i in self.named}, {}
        if not self.points:
            fillets = [self.fillet_of(i) for i, entry in self.entries.items() if entry["as"] == "followed-fillet"]
            self.allowed |= set(self.named) | {joint for first, last in fillets for joint in range(first, last + 2)}
            for i in self.named:
                if i - 1 not in self.named:
                    self.close(i, i, 1)
                if i + 1 not in self.named:
                    self.close(i, i + 1, -1)
        for step in (1,) if self.points else (1, -1):
            for joint in range(len(self.was))[::step]:
                at, to = (joint, joint + 1)[::step]
                if at in self.allowed and (self.is_vertical(joint) or self.was[joint].upright) and not self.is_lifted(to, -step):
                    self.allowed.add(to)
        for joint in (i for i in self.named if self.points and self.was[i].upright):
            while joint >= 0 and self.was[joint].goes_along() and not self.is_lifted(joint, 1):
                self.allowed.add(joint)
                joint -= 1
    def close(self, i, joint, step):
        """Where the contour of a motion returns to its outer joint, both joints move alike."""
        place, plane = self.was[i].start if step > 0 else self.was[i].end, self.was[i].plane
        while 0 <= i < len(self.was) and self.was[i].cuts() and self.was[i].plane == plane:
            other = i + (step > 0)
            if (self.was[i].end if step > 0 else self.was[i].start) == place:
                self.need(i, self.moves[joint] == self.moves[other], "the contour no longer closes")
                self.partner.update({joint: other, other: self.partner.get(other, joint)})
                self.allowed.add(other)
                return
            i += step
    def is_vertical(self, i): return self.was[i].kind in ("G0", "G1") and not self.was[i].in_plane()
    def is_lifted(self, joint, step):
        """True for the joint of an unnamed cut if the tool was lifted or changed on the way to it from the named one. A cut above, from
        which an upright arc leads down, goes along."""
        cut, i = (joint, joint - 1) if step < 0 else (joint - 1, joint)
        if not 0 <= cut < len(self.was) or not self.was[cut].cuts() or cut in self.named:
            return False
        lifted, upright = joint in self.changes, False
        while 0 <= i < len(self.was) and self.was[i].goes_along():
            lifted, upright = lifted or self.was[i].kind != "G1" or i + (step > 0) in self.changes, upright or self.was[i].upright
            i += step
        return lifted and not (upright and self.places[joint][2] > self.places[i + (step < 0)][2])

    def move(self, i, at_end): return self.was[i].at(self.moves[i + at_end])
    def tolerance(self, i): return self.on_circle + self.arc(i).mismatch if self.was[i].is_arc() else self.on_line
    def role(self, i): return self.entries[i]["as"] if i in self.entries else ""
    def arc(self, i, now=False):
        if (i, now) not in self.arcs:
            self.arcs[i, now] = Arc((self.now if now else self.was)[i])
        return self.arcs[i, now]
    def own(self, i):
        start, end = self.was[i].ends()
        return self.arc(i).circle if self.was[i].is_arc() else Line(start, (end - start).unit())
    def carrier(self, i):
        """The line or circle of a named motion as wished, of any other as it was."""
        if self.role(i) == "line":
            start, end = (place + vector(self.entries[i][n]) for place, n in zip(self.was[i].ends(), ("start", "end")))
            return Line(start, (end - start).unit())
        return self.wished_circle(i) if self.role(i) == "arc" else self.own(i)
    def wished_circle(self, i):
        arc, by = self.arc(i), [vector(self.entries[i][n]) for n in ("start", "middle", "end")]
        outward = [out.dot(b) for out, b in zip(arc.out[::2], by)]
        a, b, c = (place + b for place, b in zip((self.was[i].ends()[0], arc.middle, self.was[i].ends()[1]), by))
        is_offset = max(abs(outward[0] - outward[1]), abs(outward[2] - outward[1])) < SAME
        circle = Circle(a.mix(b), (a - b).norm() / 2) if arc.is_full else circle_through(a, b, c) if not is_offset else None
        circle = Circle(arc.center, arc.radius + outward[1]) if is_offset else circle
        self.need(i, circle and circle.radius > 0, "no circle runs where it was wanted")
        return circle
    def tangent(self, i, at_end):
        arc = self.arc(i) if self.was[i].is_arc() else None
        return arc.out[4 * at_end].left() * (1 if arc.is_left else -1) if arc else self.own(i).direction
    def beside(self, i, step):
        """The next cut, over pieces that shrank to the joint and feeds along the tool axis."""
        while 0 <= i < len(self.was) and (self.role(i) == "shrunk" or self.was[i].kind == "G1" and self.is_vertical(i)):
            i += step
        return i if 0 <= i < len(self.was) and self.was[i].cuts() and self.was[i].is_known() else None

    # What the certificate says of a motion.
    def check_sense(self, i):
        if self.was[i].is_arc():
            was, now = self.arc(i), self.arc(i, True)
            self.need(i, was.is_full == now.is_full, "a full circle was created or lost")
            self.need(i, was.out[2].dot(now.out[2]) > 0, "the arc turned around")
            self.need(i, now.mismatch <= max(was.mismatch, SMALLEST, Decimal("1.5") * self.increment) + SAME, "its radii differ")
        elif self.role(i) in ("line", "slides", "follows") and not self.points:
            (a, b), (c, d) = self.was[i].ends(), self.now[i].ends()
            self.need(i, (b - a).dot(d - c) > 0, "it turned around")
    def check_line(self, i, entry):
        (start, end), line = self.was[i].ends(), self.carrier(i)
        self.need(i, self.was[i].kind == "G1" and start != end, "it is no line")
        self.need(i, all(line.distance(place) <= self.on_line for place in self.now[i].ends()), "it does not lie on its displaced line")
        a, b = ((end - start).unit().left().dot(vector(entry[n])) for n in ("start", "end"))
        own = (a + b) / 2, (b - a) / (end - start).norm()
        self.need(i, near((entry["shift"], entry["tilt"]), own), "shift or tilt is not that of its wish")
        self.check_ends(i, entry)
    def check_arc(self, i, entry):
        self.need(i, self.was[i].is_arc(), "it is no arc")
        circle, was = self.wished_circle(i), self.arc(i)
        self.need(i, self.arc(i, True).furthest(circle) <= self.tolerance(i), "it does not lie on its displaced circle")
        own = *(circle.center - was.center), circle.radius - was.radius
        self.need(i, near((*vector(entry["center"]), entry["growth"]), own, 10 * NOISE), "center or growth is not that of its wish")
        self.check_ends(i, entry)
    def check_ends(self, i, entry):
        """Wish and rest of a named element are how it moved, and wish or neighbor fix its ends."""
        rests = []
        for n, at_end in (("start", False), ("end", True)):
            moved, by = self.move(i, at_end), entry.get(n + "By")
            self.need(i, self.moves[i + at_end][self.was[i].plane[2]] == 0, "an end moved along the tool axis")
            self.need(i, moved.norm() <= self.reach, "an end went further than any displacement explains")
            rests.append((n, moved))
            near_wish = (moved - vector(entry[n])).norm() <= self.at_place
            fixed = None if self.role(i) in ("fillet", "shrunk") else "wish" if near_wish else "meets"
            self.need(i, fixed != "meets" or self.meets(i, at_end), "an end is neither where the wish nor where a neighbor puts it")
            self.need(i, by == fixed, "the certificate says that something else fixes an end")
        if self.was[i].is_arc():
            rests.append(("middle", self.arc(i, True).middle - self.arc(i).middle))
        self.need(i, set(entry["rest"]) == set(dict(rests)), "the certificate measured other places")
        met = all(near(vector(entry[n]) + vector(entry["rest"][n]), moved) for n, moved in rests)
        self.need(i, met, "wish and rest are not how it moved")
    def meets(self, i, at_end):
        joints = i + at_end, self.partner.get(i + at_end, i + at_end)
        sides = [side for j in joints for side in ((self.beside(j - 1, -1), True), (self.beside(j, 1), False))]
        return any(self.holds(i, at_end, k, k_at_end) for k, k_at_end in sides if k not in (None, i))
    def holds(self, i, at_end, k, k_at_end):
        """A neighbor on which an end lies as well holds it at an angle; one that goes on straight lets it hardly go along both."""
        if self.was[k].plane != self.was[i].plane or self.role(k) in ("fillet", "followed-fillet"):
            return self.was[k].plane == self.was[i].plane
        if self.carrier(k).distance(self.now[i].ends()[at_end]) > self.tolerance(k):
            return False
        mine, other = self.tangent(i, at_end) * (-1 if at_end else 1), self.tangent(k, k_at_end) * (1 if k_at_end else -1)
        sine = abs(mine.cross(other))
        if sine >= TANGENT or k not in self.named:
            return sine >= TANGENT
        wish, theirs = vector(self.entries[i][("start", "end")[at_end]]), vector(self.entries[k][("start", "end")[k_at_end]])
        if mine.dot(other) < 0 or sine > CORNER and abs(wish.dot(mine.left()) - theirs.dot(other.left())) > STEP:
            return True
        along, moved = (mine + other).unit(), self.move(i, at_end)
        slipped = min(abs(moved.dot(along)), abs((moved - wish.mix(theirs)).dot(along)))
        return slipped <= TANGENT * wish.norm() + self.at_place
    def check_shrunk(self, i, entry):
        (start, end), (now_start, now_end) = self.was[i].ends(), self.now[i].ends()
        self.need(i, self.was[i].kind == "G1" and start != end and now_start == now_end, "it did not shrink to a point")
        self.need(i, (end - start).norm() <= self.reach, "it is too long to vanish")
        sides = {self.beside(i - 1, -1), self.beside(i + 1, 1)}
        self.need(i, None not in sides and sides & set(self.named), "it is not between two cuts, of which one is named")
        self.check_ends(i, entry)
    def fillet_of(self, i):
        """The arcs of one fillet, between two named lines that it touches."""
        self.need(i, self.was[i].is_arc(), "it is no fillet")
        first = next(k for k in range(i, -1, -1) if not self.is_piece(k - 1, i))
        last = next(k for k in range(i, len(self.was)) if not self.is_piece(k + 1, i))
        for k, arc, place in ((first - 1, first, self.was[first].start), (last + 1, last, self.was[last].end)):
            self.need(i, self.role(k) == "line" and self.was[k].plane == self.was[i].plane, "it is not between named lines")
            direction, to = self.tangent(k, True), self.was[arc].center - self.was[arc].at(place)
            touches = abs(direction.dot(to)) < to.norm() / 20 and (direction.cross(to) > 0) == self.arc(arc).is_left
            self.need(i, touches, "it does not touch the lines beside it")
        return first, last
    def is_piece(self, k, i):
        same = 0 <= k < len(self.was) and (self.was[k].kind, self.was[k].plane) == (self.was[i].kind, self.was[i].plane)
        return same and near((*self.arc(k).center, self.arc(k).radius), (*self.arc(i).center, self.arc(i).radius), 10 * SMALLEST)
    def check_fillet(self, i, entry):
        """Its center is where parallels of the displaced lines cross, and its radius grew by what they moved away from it."""
        (first, last), was, now, (start, end) = self.fillet_of(i), self.arc(i), self.arc(i, True), self.now[i].ends()
        before, behind, sign = self.carrier(first - 1), self.carrier(last + 1), 1 if was.is_left else -1
        left_before = before.direction.left().dot(vector(self.entries[first - 1]["end"]))
        left_behind = behind.direction.left().dot(vector(self.entries[last + 1]["start"]))
        radius = self.arc(first).radius - sign * (left_before + left_behind) / 2
        sine = before.direction.cross(behind.direction)
        self.need(i, radius > 0 and sine, "no arc of its radius touches the lines beside it")
        center = before.parallel(sign * radius).meet(behind.parallel(sign * radius), sine)
        allowed, places = self.tolerance(i) + abs(was.radius - self.arc(first).radius), (start, now.middle, end)
        self.need(i, all(Circle(center, radius).distance(p) <= allowed for p in places), "it does not lie on its fillet")
        for place, line, out, is_outer in ((start, before, was.out[0], i == first), (end, behind, was.out[4], i == last)):
            off = (place - (line.foot(center) if is_outer else center + out * radius)).norm()
            self.need(i, off <= (self.on_line if is_outer else 5 * self.increment + NOISE), "it does not end where it touches")
        (self.check_ends if entry["as"] == "fillet" else self.check_moved)(i, entry)
    check_followed_fillet = check_fillet
    def check_point(self, i, entry):
        by, rest, moved = vector(entry["by"], 3), vector(entry["rest"], 3), self.moves[i + 1]
        self.need(i, near([b + r for b, r in zip(by, rest)], moved), "wish and rest are not how it moved")
        self.need(i, near(by, moved, self.increment / 2 + NOISE), "its end is not where it was wished")
        self.check_center(i, entry)
        self.check_following(i)
    def check_center(self, i, entry):
        self.need(i, ("center" in entry) == self.was[i].is_arc(), "the certificate measured other places")
        moved = self.now[i].center - self.was[i].center if self.was[i].is_arc() else None
        self.need(i, moved is None or near(vector(entry["center"]), moved), "its center moved otherwise than the certificate says")
    def check_moved(self, i, entry):
        was = self.was[i]
        self.need(i, set(entry["moved"]) - {"center"} == {"start", "end"}, "the certificate measured other places")
        self.check_center(i, entry["moved"])
        for n, joint in (("start", i), ("end", i + 1)):
            self.need(i, near(vector(entry["moved"][n], 3), self.moves[joint], SAME), "it moved otherwise than the certificate says")
            behind = joint < len(self.was) and self.was[joint].upright
            level = was.upright or not self.moves[joint][was.plane[2]] or self.points and (joint == i or behind)
            self.need(i, level, "it moved along the tool axis")
        stays = not was.in_plane() and self.move(i, False) == self.move(i, True)
        slides = was.cuts() and self.tolerance(i) >= (self.arc(i, True).furthest(self.own(i)) if was.is_arc() else max(
            self.own(i).distance(place) for place in self.now[i].ends()))
        if entry["as"] == "positioning":
            self.need(i, was.kind == "G0" or stays, "it cuts elsewhere")
        elif entry["as"] == "slides":
            self.need(i, slides, "it left its own place, or its center moved")
        elif entry["as"] == "follows":
            self.need(i, self.points or was.upright or was.cuts() and not slides, "it does not follow: it does not cut, or it slides")
            self.check_following(i)
    check_slides = check_follows = check_positioning = check_moved
    def check_following(self, i):
        """An arc lies on the circle through its displaced ends and its old middle, moved by their mean, and moves nowhere further."""
        if self.was[i].is_arc():
            other = self.was[i].upright and not near(self.moves[i], self.moves[i + 1], SAME)
            beyond(other, "an upright arc became another one", self.was[i].line)
            was, now, start, end = self.arc(i), self.arc(i, True), self.move(i, False), self.move(i, True)
            if near(start, end, SAME):
                return self.need(i, near(now.center - was.center, start), "it does not follow its ends")
            start, end = self.unrounded(i, False, start), self.unrounded(i, True, end)
            circle = circle_through(was.ends[0] + start, was.middle + start.mix(end), was.ends[1] + end)
            self.need(i, circle and now.furthest(circle) <= self.tolerance(i), "it does not follow its ends")
            furthest = now.furthest(was.circle) - max(start.norm(), end.norm())
            self.need(i, furthest <= self.tolerance(i), "it moves further between its ends than they do")
    def unrounded(self, i, at_end, moved):  # the wish of an end that is where it puts it
        k = i - 1 + at_end if self.points else self.beside(i + 1, 1) if at_end else self.beside(i - 1, -1)
        by = self.named[k].get("by" if self.points else "start" if at_end else "end") if k in self.named else None
        wish = by and (self.was[i].at(by) if self.points else V(*by))
        return wish if wish and (moved - wish).norm() <= self.at_place else moved

def take_out_marker(lines, document):
    """The lines of a result without the marker, which is a line of its own before the first block that acts."""
    if document["marker"] is None:
        return lines
    at, text = int(document["marker"]["line"]) - 1, document["marker"]["text"].encode()
    words = rb"ERRORMATCH MEASUREMENT=[0-9A-F]{64} BASE=" + document["baseSha256"].upper().encode()
    form = rb"; " + words if document["dialect"]["syntax"] == "siemens" else rb"\(" + words + rb"\)"
    need(set(document["marker"]) == {"line", "text"} and re.fullmatch(form, text), "the marker is no marker of this base")
    need(0 <= at < len(lines) and lines[at][0] == text, "the marker is not where the certificate says")
    need(lines[at][1] == lines[at - 1 if at else min(1, len(lines) - 1)][1], "the marker has another line end")
    need(all(HEAD.match(line) for line, _ in lines[:at]), "the marker is among the blocks")
    return lines[:at] + lines[at + 1:]

def compare(base, result, certificate):
    facts = (document := read_certificate(certificate))["dialect"]
    for name, data in (("base", base), ("result", result)):
        need(hashlib.sha256(data).hexdigest() == document[name + "Sha256"], f"the {name} is another file")
    beyond(facts["syntax"] not in TOKENS, f"programs of the syntax {facts['syntax']}")
    need(set(facts["decimals"]) == set(MM) and isinstance(facts["integersAreIncrements"], bool), "the certificate's facts are damaged")
    old, new = split(base), take_out_marker(split(result), document)
    need([end for _, end in old] == [end for _, end in new], "lines or line ends differ")
    with localcontext(EXACT):
        before = [(n, tokenize(line, facts["syntax"], n)) for n, (line, _) in enumerate(old, 1)]
        after = [block if line == was else (block[0], tokenize(line, facts["syntax"], block[0]))
                 for block, (was, _), (line, _) in zip(before, old, new)]
        was, now = interpret(before, facts), interpret(after, facts)
    with localcontext(ROUNDED):
        Comparison(was, now, document, facts).run(before, after)

def judge(base, result, certificate):
    """The answer for three files, as bytes: "yes", "no" or "cannot judge", and the reason."""
    try:
        compare(base, result, certificate)
    except (No, Beyond) as reason:
        return "no" if isinstance(reason, No) else "cannot judge", str(reason)
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, ArithmeticError, RecursionError) as error:
        return "no", f"the certificate or a program is damaged: {type(error).__name__}: {error}"
    return "yes", ""

if __name__ == "__main__":
    sys.exit(print(__doc__) or 2) if len(sys.argv) != 4 else None
    answer, reason = judge(*(open(name, "rb").read() for name in sys.argv[1:]))
    print(f"{answer}: {reason}" if reason else answer)
    sys.exit({"yes": 0, "no": 1, "cannot judge": 2}[answer])
