#!/usr/bin/python3
"""Makes the station's fonts. Usage: tools/fonts.py, on Debian after: apt-get install python3-fonttools fonts-noto-cjk fonts-dejavu-core

Of Noto Sans CJK in the forms of Taiwan, regular and bold, it keeps the characters of the station's texts, the 5,401 common characters of
Big5 (its level 1) for names of people and parts, Latin, and symbols; and nothing that lays out lines from top to bottom. The family gets
a name of its own, so that it is never mistaken for an installed one that has all characters. DejaVu Sans Mono, which shows programs, is
taken as it is. The same fonts and texts make the same bytes.
"""
import pathlib
import shutil

from fontTools import subset
from fontTools.ttLib import TTCollection

ROOT = pathlib.Path(__file__).resolve().parent.parent
FONTS = ROOT / "src/ErrorMatching.Hmi.Platform/Text/Fonts"
NOTO = pathlib.Path("/usr/share/fonts/opentype/noto")
MONO = pathlib.Path("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf")
SOURCE, FAMILY = "Noto Sans CJK TC", "Station Sans TC"

# Latin and its signs; punctuation, superscripts, currencies and signs like letters; arrows and signs of mathematics; marks; punctuation of
# East Asia, Bopomofo, and wide forms.
RANGES = [
    (0x20, 0x17F), (0x2000, 0x214F), (0x2190, 0x22FF), (0x2500, 0x27BF),
    (0x3000, 0x303F), (0x3100, 0x312F), (0xFE30, 0xFE4F), (0xFF00, 0xFFEF)]
KEPT_NAMES = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14]
LINE_LAYOUT = ["BASE", "GDEF", "GPOS", "GSUB", "VORG", "vhea", "vmtx"]


def characters():
    wanted = {c for first, last in RANGES for c in range(first, last + 1)}
    for high in range(0xA4, 0xC7):
        for low in [*range(0x40, 0x7F), *range(0xA1, 0xFF)]:
            if (high, low) <= (0xC6, 0x7E):
                wanted.add(ord(bytes([high, low]).decode("big5")))
    for texts in (ROOT / "src/ErrorMatching.Hmi/Texts").glob("*.json"):
        wanted.update(ord(c) for c in texts.read_text("utf-8") if c >= " ")
    return wanted


def rename(font):
    names = font["name"]
    for record in names.names:
        if record.nameID in (1, 3, 4, 6):
            text = record.toUnicode().replace(SOURCE, FAMILY).replace("NotoSansCJKtc", FAMILY.replace(" ", ""))
            names.setName(text, record.nameID, record.platformID, record.platEncID, record.langID)
    outlines = font["CFF "].cff
    outlines.fontNames = [names.getDebugName(6)]
    outlines.topDictIndex[0].FamilyName = FAMILY
    outlines.topDictIndex[0].FullName = names.getDebugName(4)


def make(weight, wanted):
    collection = TTCollection(NOTO / f"NotoSansCJK-{weight}.ttc")
    font = next(f for f in collection.fonts if f["name"].getDebugName(1) == SOURCE)
    font.recalcTimestamp = False
    options = subset.Options(
        hinting=False, layout_features=[], drop_tables=[*subset.Options().drop_tables, *LINE_LAYOUT], name_IDs=KEPT_NAMES,
        name_languages=["*"], notdef_outline=True)
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=wanted)
    subsetter.subset(font)
    rename(font)
    target = FONTS / f"{FAMILY.replace(' ', '')}-{weight}.otf"
    subset.save_font(font, target, options)
    print(f"{target.relative_to(ROOT)}: {len(font.getBestCmap())} characters, {target.stat().st_size} bytes")


if __name__ == "__main__":
    FONTS.mkdir(exist_ok=True)
    all_wanted = characters()
    make("Regular", all_wanted)
    make("Bold", all_wanted)
    shutil.copyfile(MONO, FONTS / MONO.name)
