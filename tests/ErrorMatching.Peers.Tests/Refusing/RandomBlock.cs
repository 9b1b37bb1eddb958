using System.Globalization;

namespace ErrorMatching.Peers.Tests;

/// <summary>A block of LinuxCNC with the blocks that it needs before it, random by its seed: legal, or with one fault. Whether the control
/// really refuses it, the peer says.</summary>
internal sealed class RandomBlock
{
    private readonly RandomNumbers _random;
    private readonly List<string> _before = [];
    private List<string> _words = [];

    private RandomBlock(ulong seed) => _random = new(seed);

    /// <summary>What every block begins with, so that it does not depend on the one before it.</summary>
    public static IReadOnlyList<string> Reset { get; } =
    [
        "G40", .. Enumerable.Range(1, 9).Select(n => $"G10 L2 P{n} X0 Y0 Z0 R0"),
        .. Enumerable.Range(1, 9).Select(n => $"G10 L1 P{n} X0 Z0 R1"),
        "M71", "G80", "M5", "G17", "G21", "G90", "G91.1", "G94", "G54", "G49", "G98", "G92.1", "G61", "G97", "G8",
        "S500 F100", "G53 G0 X0 Y0 Z0 A0 B0 C0", "G0 X1 Y2 Z10",
    ];

    /// <summary>The blocks before it, behind those of <see cref="Reset"/>.</summary>
    public IReadOnlyList<string> Before => _before;

    public string Text { get; private set; } = "";

    /// <summary>What was done to it; empty for a legal one.</summary>
    public string Fault { get; private set; } = "";

    public static RandomBlock Write(int seed, bool isFaulty)
    {
        var block = new RandomBlock(((ulong)seed * 2) + (isFaulty ? 1ul : 0));
        block.WriteLegal();
        if (isFaulty)
        {
            block.Spoil();
        }
        else
        {
            block.Text = block.Spelled(block._words);
        }

        return block;
    }

    private string Any(params ReadOnlySpan<string> choices) => choices[_random.Below(choices.Length)];

    private string Number(double low, double high) =>
        Math.Round(_random.Uniform(low, high), _random.Below(4)).ToString(CultureInfo.InvariantCulture);

    private string Place() => Number(-50, 50);

    private void Behind(params ReadOnlySpan<string> blocks) => _before.AddRange(blocks);

    private void Words(params ReadOnlySpan<string> words) => _words = [.. words];

    private string Axes(string letters = "XYZ")
    {
        var some = string.Concat(letters.Where(_ => _random.Chance(0.6)));
        some = some.Length == 0 ? letters[.._random.Below(1)] + letters[0] : some;
        return string.Join(' ', some.Distinct().Select(l => l + Place()));
    }

    private string[] Split(string text) => text.Split(' ', StringSplitOptions.RemoveEmptyEntries);

    private void WriteLegal()
    {
        switch (_random.Below(44))
        {
            case 0: Words(["G0", .. Split(Axes())]); break;
            case 1: Words(["G1", .. Split(Axes()), Any("F300", "S50", "F1.5", "M8")]); break;
            case 2: Behind("G1 X3"); Words(Split(Axes())); break;
            case 3: Words("G2", "X" + (1 + 10), "Y2", "I5", "J0"); break;
            case 4: Words("G3", "X1", "Y12", "I0", "J5", Any("Z5", "F80", "P1", "P3")); break;
            case 5: Words(Any("G2", "G3"), "X" + Number(2, 30), "Y" + Number(4, 30), "R" + Number(60, 90)); break;
            case 6: Words(Any("G2", "G3"), "I" + Number(1, 9), "J" + Number(1, 9)); break;
            case 7: Behind("G18"); Words("G2", "X11", "Z10", "I5", "K0"); break;
            case 8: Behind("G19"); Words("G3", "Y12", "Z10", "J5", "K0"); break;
            case 9: Behind("G2 X11 Y2 I5"); Words("X1", "Y2", "I-5", "J0"); break;
            case 10: Words("G4", "P" + Number(0, 3)); break;
            case 11: Words("G10", "L2", "P" + _random.Below(10), Axes("XYZ").Split(' ')[0], Any("R0", "R10", "Z5")); break;
            case 12: Words("G10", "L20", "P" + _random.Below(10), "X1", "Y2"); break;
            case 13: Words("G10", Any("L1", "L10", "L11"), "P" + (1 + _random.Below(9)), Any("Z5", "R3", "X1"), Any("Q1", "I10")); break;
            case 14: Words(Any("G28", "G30"), Any("X1", "Z5", "Y2")); break;
            case 15:
                Words(Any(
                    "G28.1", "G30.1", "G17", "G18", "G19", "G20", "G21", "G90", "G91", "G93", "G94", "G95", "G98", "G99"));
                break;
            case 16: Words(["G53", Any("G0", "G1"), .. Split(Axes())]); break;
            case 17: Words(["G92", .. Split(Axes())]); break;
            case 18: Words(Any("G92.1", "G92.2", "G92.3", "G49", "G40", "G80", "G61", "G61.1", "G64", "G97")); break;
            case 19: Words("G43", "H" + (1 + _random.Below(9))); break;
            case 20: Words("G43.1", "Z" + Place()); break;
            case 21: Words("G81", "X5", "Y5", "Z-3", "R5", Any("L1", "L3", "F80")); break;
            case 22: Words(Any("G73", "G83"), "X5", "Z-3", "R5", "Q" + Number(1, 3)); break;
            case 23: Words(Any("G82", "G89"), "Y5", "Z-3", "R5", "P" + Number(0, 2)); break;
            case 24: Behind("M3"); Words("G86", "X5", "Z-3", "R5", "P1"); break;
            case 25: Words("G85", "X5", "Z-3", "R5"); break;
            case 26: Behind(Any("M3")); Words("G84", "X5", "Z-3", "R5", Any("P1", "L2")); break;
            case 27: Behind("M4"); Words("G74", "X5", "Z-3", "R5"); break;
            case 28: Behind("G81 X5 Y5 Z-3 R5"); Words("X" + Place(), "Y" + Place()); break;
            case 29: Behind("G83 X5 Y5 Z-3 R5 Q1"); Words("X" + Place(), Any("L2", "Q2", "R6", "Z-4")); break;
            case 30: Words(Any("G38.2", "G38.3", "G38.4", "G38.5"), "Z" + Number(-20, 5)); break;
            case 31: Words("G5", "X20", "Y10", "I5", "J5", "P-5", "Q-5"); break;
            case 32: Words("G5.1", "X20", "Y10", "I5", "J5"); break;
            case 33: Behind(Any("M3", "M4")); Words("G33", "Z5", "K" + Number(0.5, 2)); break;
            case 34: Behind("G93"); Words("G1", "X5", "F" + Number(1, 9)); break;
            case 35: Behind("G95", "M3 S400"); Words("G1", "X5", "F0.1"); break;
            case 36: Words(Any("G96 D2000", "G96"), "S" + Number(1, 300)); break;
            case 37:
                Words(Any("M0", "M1", "M3", "M4", "M5", "M7", "M8", "M9", "M48", "M49", "M60", "M70"), Any("S800", "F90", "T3"));
                break;
            case 38:
                Words(Any("M62 P1", "M63 P2", "M64 P0", "M65 P3", "M66 P1", "M66 E1", "M67 E1 Q5", "M68 E0 Q1", "M50 P1", "M52 P0",
                "M61 Q2", "T4 M6", "M19 R90", "M19 R10 P1", "M66 P1 L3 Q2"));
                break;
            case 39: Words("G64", "P" + Number(0.01, 1), "Q" + Number(0.01, 1)); break;
            case 40: Words(Any("@5^30", "G0 @4 ^60", "G1 ^45", "G0 X5 A10", "G1 Y2 B3 C4", "G0 A90")); break;
            case 41:
                Words(Any("#1=5", "#<a>=[2+3]", "#100=#5220", "#<_glob>=ABS[-3]", "#2=ATAN[1]/[2]", "#3=SQRT[2]", "#4=[5 MOD 3]",
                "#5=ROUND[2.5]", "#6=[2**3]", "#7=[1 GT 0]", "#8=EXISTS[#<a>]", "#9=FIX[-2.5]", "#10=ACOS[0.5]", "#11=LN[2]"));
                break;
            case 42: Words("G1", "X[1+2]", "Y-#5220", "Z[5*[2-1]]"); break;
            default:
                Behind("G1 X5", "G41.1 D2");
                Words("G1", "X30", "Y" + Number(20, 40));
                break;
        }

        if (_random.Chance(0.15))
        {
            _words.Insert(0, "N" + _random.Below(9999));
        }

        if (_random.Chance(0.1))
        {
            _words.Add(Any("(comment)", "(a, b: c)", "; rest", "M8", "S700"));
        }
    }

    private string Spelled(List<string> words)
    {
        var text = string.Join(_random.Chance(0.9) ? " " : "", words);
        return _random.Chance(0.1) ? text.ToLowerInvariant() : text;
    }

    private void Spoil()
    {
        var words = _words;
        var at = _random.Below(words.Count);
        (Fault, Text) = _random.Below(31) switch
        {
            0 or 1 => ("a letter more", Spelled([.. words, Any("D1", "E2", "H1", "I3", "J3", "K3", "L2", "P1", "Q1", "R5")])),
            2 or 3 => ("a code more",
                Spelled([.. words, Any("G0", "G1", "G2", "G17", "G19", "G20", "G90", "G91", "G93", "G55", "G43 H1", "G4 P1",
                "G53", "G80", "G28", "G92 X0", "G98", "G61", "G64", "G10 L2 P1 X0", "M3", "M5", "M8", "M0", "G41", "G91.1", "G90.1")])),
            4 => ("a word twice", Spelled([.. words, words[at]])),
            5 or 6 => ("a word less", Less(at)),
            7 => ("below zero", Spelled([.. words, Any("F-100", "S-5", "T-1", "H-3", "L-2", "M-3", "G-1")])),
            8 => ("a fraction", Spelled([.. words, Any("T1.5", "H1.5", "L1.5", "M3.5", "G1.05", "G90.5", "M8.2")])),
            9 => ("an exponent", Spelled(["G1", "X1.5E-3"])),
            10 => ("no feed", NoFeed()),
            11 => ("a comment in a comment", Spelled([.. words, Any("(a (b) c)", "((a))", "(a (b)")])),
            12 => ("an open comment", Spelled([.. words, "(open"])),
            13 => ("a bad number", Spelled([.. words, Any("Y1.2.3", "Y--1", "Y+-2", "Y", "Y.", "Y-", "Y1,5", "G", "F", "Y1O")])),
            14 => ("a bad sign", Spelled([.. words, Any("?", "&", "=5", "!", "\"", "~", "]", ")", "*", "|", ":", "{", "Y=5")])),
            15 => ("an unknown code",
                Spelled([.. words, Any("G9", "G16", "G68", "G60", "G99.9", "G100", "G15", "G44", "G50", "G54.1", "G65", "M12",
                "M97", "M250", "M31", "M99.5", "G1000")])),
            16 => ("G53 and what it does not go with",
                Any("G53 G2 X5 Y5 I1", "G53 X1 G91", "G53", "G91 G53 G0 X1", "G53 G38.2 Z-1", "G53 G81 X1 R5 Z1")),
            17 => ("coordinates without a motion", WithBefore(Any("G80"), Axes())),
            18 => ("G80 with coordinates", "G80 " + Axes()),
            19 => ("a bad arc",
                Any("G2 X5 Y5", "G2 X5 Y5 I1 R3", "G2 X5 Y5 K2", "G2 X30 Y2 I3 J0", "G2 R5", "G2 X90 Y2 R5", "G18 G2 X5 Z5 J1",
                "G19 G2 Y5 Z5 I1", "G2 Z5 R4", "G3 X1 Y2 R5", "G90.1 G2 X11 Y2 I6", "G2 X11 Y2 I5 P0", "G2 X11 Y2 I5 P1.5",
                "G2 X11 Y2 I5 P-1",
                "G2 X1 Y2 I0 J0", "G17.1 G2 X11 Y2 I5")),
            20 => ("a bad cycle",
                Any("G81 X5 Z-3", "G81 X5 R5", "G83 X5 Z-3 R5", "G73 X5 Z-3 R5", "G82 X5 Z-3 R5", "G89 X5 Z-3 R5", "G81 X5 Z8 R5",
                "G81 X5 Z-3 R5 L0", "G93 G81 X5 Z-3 R5 F5", "G84 X5 Z-3 R5", "G86 X5 Z-3 R5 P1", "M3 G74 X5 Z-3 R5", "M4 G84 X5 Z-3 R5",
                "G83 X5 Z-3 R5 Q0", "G83 X5 Z-3 R5 Q-1", "G81 A5 Z-3 R5", "G81 X5 Z-3 R5 U1", "G81 Z-3 R5 L1.5", "G18 G81 X5 Z-3 R5",
                "G81", "G81 R5", "G81 X5 Z-3 R5 Q1 P1", "G91 G81 X5 Z3 R-5", "G19 G81 X5 Y1 R1")),
            21 => ("two codes with coordinates",
                Any("G92 G1 X5", "G28 G0 X5", "G10 G1 L2 P1 X5", "G52 G0 X1", "G30 G2 X5 I1", "G28 G38.2 Z1")),
            22 => ("a bad expression",
                Any("G1 X[SQRT[-1]]", "G1 X[ASIN[2]]", "G1 X[LN[0]]", "G1 X[1/0]", "G1 X[FOO[1]]", "G1 X[1+2", "G1 X[ATAN[1]]",
                "G1 X#0", "G1 X#99999", "G1 X[1+]", "#1 5", "#1=", "#=5", "G1 X[1 FOO 2]", "#5220=1 #5400=2", "G1 X#1.5", "G1 X[]",
                "G1 X]1[",
                "#<abc=5", "G1 X[ABS 1]", "#1=[1 2]", "#5420=7", "G1 X[ACOS[1.5]]", "G1 X[0/0]", "G1 X[2 ** 1e3]")),
            23 => ("a block number elsewhere", Any("G1 X5 N10", "N-5 G1 X5", "N1.5 G1 X5", "N G1 X5", "N10 N20 X5", "NX5", "N1.2.3 X5")),
            24 => ("a long line", Spelled([.. words, "(" + new string('a', 250) + ")"])),
            25 => ("many functions", Any("M3 M8 M48 M0 M62 P1", "M3 M8 M48 M0", "M3 M7 M8", "M3 M5", "M0 M1", "M48 M50 P1", "M62 P1 M63 P2",
                "M3 M8 M48 M0 M62 P1 T1 M6", "M6 M61 Q1", "M3 M4", "M7 M9")),
            26 => ("compensation",
                Any("G41.1 D1|G1 X9|G41.1 D1", "G41.1 D1|G1 X9|G28", "G41.1 D1|G1 X9|G18", "G19|G41.1 D1", "G41.1", "G41 D1.5",
                "G41 D-1", "G41.1 D1|G1 X9|G81 X1 Z1 R2", "G41.1 D1|G1 X9|G53 G0 X1", "G41.1 D1|G1 X9|G55", "G41.1 D1|G1 X9|G92 X1",
                "G41.1 D1|G1 X9|G38.2 Z1", "G41.1 D1|G1 X9|M62 P1", "G41.1 D1|G1 X9|G17", "G41.1 D1|G1 X9|G42.1 D1",
                "G41.1 D1|G1 X9|G43 H1",
                "G41.1 D1|G1 X9|G98", "G41.1 D1|G1 X9|G64", "G41.1 D1|G1 X9|M6", "G41.1 D1|G1 X9|G40", "G41.1 D1|G1 X9|G21",
                "G41.1 D1|G1 X9|G91",
                "G41.1 D1|G1 X9|G93", "G41.1 D1|G1 X9|G20", "G41.1 D1|G1 X9|S5", "G41.1 D1|G1 X9|M8", "G41.1 D1|G1 X9|G4 P1",
                "G41.1 D1|G1 X9|M49", "G41.1 D1|G1 X9|G10 L2 P2 X1", "G41.1 D1|G1 X9|G10 L2 P1 X1", "G41.1 D1|G1 X9|G30.1",
                "G41.1 D1|G1 X9|G49")),
            27 => ("what a code needs",
                Any("G4", "G92", "G52", "G38.2", "G33 Z5", "M3|G33 Z5", "M3|G33 Z5 K1 F5", "G33 Z5 K1", "G96", "G96 D100",
                "G76 Z5 P1", "G5 X1", "G5.1 X1 Y1", "G5.1 X1 Y1 I1", "G5 X1 Y1 P1 I1 J1", "G18|G5.1 X1 Y1 I1 J1", "G5.1 X1 Y1 I1 J1 Z1",
                "G93|G1 X5", "G93|G2 X11 Y2 I5", "S0|G95|G1 X5", "G95|G38.2 Z1", "G43.2", "G43.2 H1 X1", "G10", "G10 L3 P1", "G10 L2",
                "G10 L2 P10 X1",
                "G10 L2 P1.5 X1", "G10 L2 P1 X1 I1", "G10 L20 P1 X1 R1", "G10 L1 P0 Z1", "G10 L1 P1", "G10 L1 P1 Z1 Q10", "G10 L20 P-1 X1",
                "G10 L1 Z1", "G5.3", "G4 P1 G2 X11 Y2 I5", "G4 X5", "G38.2 X1 Y2 Z10", "G40|G0 X5 Y5|G41.1 D1 G2 X11 Y5 I3", "G64 P-1",
                "G53 G1")),
            28 => ("what a function needs",
                Any("M61", "M62", "M63", "M64", "M65", "M66", "M67", "M68 Q1", "M66 P1 E1", "M67 Q1", "M61 Q-1", "M19 P3",
                "M19 R400", "M19 Q0", "M19 R-1", "M66 P-1", "M67 E-1 Q1", "M19 P1.5", "M66 E1 L1 Q1", "M98", "M66 P1 L3", "M72", "M6 Q1")),
            29 => ("polar",
                Any("G18|G0 @5^30", "G0 X1 @5", "G0 Y1 ^5", "G53 G0 @5^3", "G92 @5^3", "@5^30 G80", "G28 @5^3", "G0 @", "G0 @5 ^")),
            _ => ("two motions", Spelled([.. words, Any("G1 X1", "G0", "G3", "G81", "G38.2", "G5.1", "G76", "G33")])),
        };
        if (Text.Contains('|', StringComparison.Ordinal) && Fault is "compensation" or "what a code needs" or "polar")
        {
            var blocks = Text.Split('|');
            _before.Clear();
            _before.AddRange(blocks[..^1]);
            Text = blocks[^1];
        }
        else if (Fault is "a bad arc" or "a bad cycle" or "what a function needs" or "two codes with coordinates" or "what a code needs"
            or "compensation" or "polar" or "a bad expression" or "a block number elsewhere" or "many functions" or "G80 with coordinates"
            or "an exponent" || Fault.StartsWith("G53", StringComparison.Ordinal))
        {
            _before.Clear();
        }
    }

    private string Less(int at)
    {
        var words = _words.ToList();
        words.RemoveAt(at);
        return words.Count == 0 ? "G4" : Spelled(words);
    }

    private string NoFeed()
    {
        _before.Add("F0");
        return Any("G1 X5", "G2 X11 Y2 I5", "G81 X5 Z-3 R5", "G38.2 Z-1", "G5.1 X20 Y10 I5 J5", "G1", "G1 X5 F0", "G0 X5", "G1 F10 X5",
            "G3 I4");
    }

    private string WithBefore(string before, string text)
    {
        _before.Clear();
        _before.Add(before);
        return text;
    }
}
