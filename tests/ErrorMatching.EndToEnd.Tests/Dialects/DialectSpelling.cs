using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>How programs of a dialect are written in these tests, and how the referee, who reads plain words only, comes to read
/// them.</summary>
/// <param name="Name">The dialect.</param>
/// <param name="Head">The lines before the first motion.</param>
/// <param name="Interludes">What can be between two contours; the second one states all coordinates.</param>
/// <param name="Passed">Pattern of the lines that the referee passes over: they move nothing, or in a way that nobody follows.</param>
/// <param name="Call">The line that calls a subprogram, with {0} for its number; empty if the dialect has none.</param>
/// <param name="Begin">The first line of a subprogram.</param>
/// <param name="End">The last line of a subprogram.</param>
/// <param name="Further">Further subprograms, which interludes call.</param>
/// <param name="Formula">A coordinate as a formula, which a program may have in place of the number, with a variable of value 3; null if
/// the dialect has none here.</param>
/// <param name="Unroll">Runs what the dialect computes, in place of the referee; null if it computes nothing here.</param>
internal sealed record DialectSpelling(
    string Name, string Head, string[] Interludes, string Passed, string Call = "", string Begin = "", string End = "M99",
    string Further = "", Func<double, string, Random, string>? Formula = null, Func<string, string>? Unroll = null)
{
    private const string IsoHead = "%\nO0001\nG21 G17 G40 G49 G80 G90 G54";

    private static readonly string[] IsoInterludes = ["G28 Z5.", "T2 M6", "G98 G81 X1. Y1. Z-3. R1. F50.\nG80", "G53 G0 Z0."];

    public static IReadOnlyList<DialectSpelling> All { get; } =
    [
        new(
            "haas",
            "%\nO00001 (A PART)\nG20\nG21 G17 G40 G49 G80 G90\nG103 P1\nT1 M06\nG154 P12\nG187 P3 E0.01",
            [
                "G103\nG187 P1",
                "G12 I5. F100. Z-2. D1\nG0 Z5.",
                "G81 G98 Z-3. R1. F50. L0\nG70 I10. J15. L6\nG80",
                "G81 G99 G71 X3. Y4. Z-3. R1. F50. I10. J15. K-20. L3\nG80",
                "G47 P0 X1. Y1. I0. J5. R1. Z-1. (TEXT)",
                "G110",
                "G53 G0 Z0.",
            ],
            @"G103.*|G154 .*|G187.*|G110|G12 .*|G81 .*|G70 .*|G47 .*|G53 .*",
            "M97 P{0}",
            "N{0}"),
        new(
            "grbl",
            "$H\n$X\nG21 G90 G17 G40 G54 G94\nG91.1\nM3 S10000",
            ["$G", "G38.2 Z-20. F50.\nG92 Z0.\nG92.1", "$J=G91 X10. F500", "G28.1", "G53 G0 Z0."],
            @"\$.*|G91\.1|G38\.2 .*|G92.*|G28\.1|G53 .*"),
        new(
            "mazak-eia",
            IsoHead + "\nG61.1\nG54.1 P3",
            [
                "G64",
                "G98 G81 X1. Y1. Z-3. R1. F50.\nG80",
                "G34.1 X0. Y0. I10. J0. K4.\nG0 Z5.",
                "G75 X1. Y1. Z-3. R1. F50.\nG80",
                "G53 G0 Z0.",
            ],
            @"G61\.1|G54\.1 .*|G98 G81 .*|G34\.1 .*|G75 .*|G53 .*",
            "M98 Q{0}",
            "N{0}"),
        new(
            "mitsubishi-m80",
            IsoHead + "\nG61.1",
            ["G64", "G98 G81 X1. Y1. Z-3. R1. F50.\nG80", "G12 I5. D1 F100.", "G36 X0. Y0. I10. J0. P20. K4.", "G53 G0 Z0."],
            @"G61\.1|G98 G81 .*|G12 .*|G36 .*|G53 .*",
            "M98 H{0}",
            "N{0}"),
        new(
            "okuma-osp",
            "$PART.MIN%\nOPART (A PART)\nG21 G17 G40 G80 G90 G94\nG15 H1\nM130\nXOFS=3\nZOFS=1\nPF100=200\nVC9=0",
            [
                "G71 Z50.\nG81 X1. Y1. Z-3. R1. F50. M53\nG80",
                "G0 G16 H0 Z0.",
                "T2 M6\nG56 H2",
                "G30 P1",
                "G116 T3\nG90 G17 G40",
                "F=PF100",
                "VC1=0\nNL{1} VC1=VC1+1\nG0 X=VC1*10\nIF [VC1 LT 3] NL{1}",
                "IF [XOFS GT 0] NS{1}\nG0 X999.\nNS{1} Y=XOFS*2",
                "GOTO NG{1}\nG1 X999.\nNG{1} ZOFS=[ZOFS+1]*2",
                "MODIN ODRIL PDEP=ZOFS\nG0 X20.\nX=20+XOFS\nMODOUT",
                "CALL ODRIL Q2 PDEP=5",
            ],
            @"\$.*|G15 .*|G71 .*|G81 .*|.*G16 .*|G56 .*|G30 .*|G116 .*",
            "CALL O{0} PX=XOFS",
            "O{0}",
            "RTS",
            "ODRIL\nG0 Z=PDEP\nG0 Z=PDEP+[2*PDEP]\nRTS\n%\n",
            OkumaFormula,
            OkumaReferee.Unrolled),
        new("generic", IsoHead, IsoInterludes, "G98 G81 .*|G53 .*", "M98 P{0}", "O{0}"),
        new("fanuc", IsoHead, IsoInterludes, "G98 G81 .*|G53 .*", "M98 P{0}", "O{0}"),
        new("delta-nc300", IsoHead, IsoInterludes, "G98 G81 .*|G53 .*", "M98 P{0}", "O{0}"),
    ];

    private static string OkumaFormula(double value, string three, Random random)
    {
        var number = value.ToString("0.0##", CultureInfo.InvariantCulture);
        var less = (value - 3).ToString("0.0##", CultureInfo.InvariantCulture);
        return random.Next(6) switch
        {
            0 => $"={three}{(value < 3 ? "" : "+")}{less}",
            1 => $"=[{less}+{three}]",
            2 => $"={number}*[1-VC9]",
            3 => $"= {number}",
            _ => number,
        };
    }

    /// <summary>The program with its subprograms in the place of their calls, and without what the referee passes over.</summary>
    public string ForReferee(string program)
    {
        var lines = program.Split('\n');
        var plain = new List<string>();
        foreach (var line in lines)
        {
            if (Unroll is null && Called(line) is { } number)
            {
                var begin = Array.IndexOf(lines, string.Format(CultureInfo.InvariantCulture, Begin, number));
                plain.AddRange(lines[(begin + 1)..Array.IndexOf(lines, End, begin)]);
            }
            else if (!Regex.IsMatch(line, $"^({Passed})$", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(1)))
            {
                plain.Add(line);
            }
        }

        return Unroll?.Invoke(string.Join('\n', plain)) ?? string.Join('\n', plain);
    }

    private string? Called(string line)
    {
        var at = Call.IndexOf("{0}", StringComparison.Ordinal);
        return at > 0 && line.StartsWith(Call[..at], StringComparison.Ordinal) ? line[at..] : null;
    }
}
