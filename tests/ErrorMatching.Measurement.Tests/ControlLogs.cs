using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement.Tests;

/// <summary>The same five points as controls and gauges write them. The layouts follow published descriptions.</summary>
internal static class ControlLogs
{
    public const string Table =
        "point,x_mm,y_mm,z_mm\n1,20.5120,-4.0311,-2.0000\n2,-20.4985,-4.0250,-2.0000\n3,-22.0063,0.7500,-2.0000\n"
            + "4,0.2500,6.0049,-2.0000\n5,22.0102,0.7388,-2.0000\n";

    /// <summary>The points, in the order of the logs.</summary>
    public static readonly Point3[] Points =
        [new(20.512, -4.0311, -2), new(-20.4985, -4.025, -2), new(-22.0063, 0.75, -2), new(0.25, 6.0049, -2), new(22.0102, 0.7388, -2)];

    /// <summary>Names of logs whose points have no labels.</summary>
    public static readonly string[] ByOrder = [
        "probeopen", "grbl", "grbl terminal", "grbl answers behind commands", "grbl with commands", "dprnt without labels",
    ];

    /// <summary>Logs with X and Y of each point, by name.</summary>
    public static readonly IReadOnlyDictionary<string, string> All = new Dictionary<string, string>(StringComparer.Ordinal)
    {
        ["probeopen"] = Lines((_, p) => $"{D(p.X, 6)} {D(p.Y, 6)} {D(p.Z, 6)} 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\n"),
        ["grbl"] = Lines((_, p) => $"[PRB:{D(p.X, 3)},{D(p.Y, 3)},{D(p.Z, 3)}:1]\r\nok\r\n"),
        ["grbl terminal"] =
            "Grbl 1.1h ['$' for help]\n$13=0\n[MSG:Check Limits]\n"
            + Lines((_, p) => $"> G38.2 Z-9 F50\n<Run|MPos:{D(p.X, 3)},0.000,0.000|FS:0,0>\n"
                + $"[PRB:{D(p.X, 3)},{D(p.Y, 3)},{D(p.Z, 3)}:1]\nok\n")
            + "[G54:0.000,0.000,0.000]\n[TLO:0.000]\n[PRB:22.010,0.739,-2.000:1]\nok\n",
        ["grbl answers behind commands"] =
            "[CTRL+X] < Grbl 1.1f ['$' for help]\nG0X5 < ok\n"
            + Lines((_, p) => $"G21G91G38.2Z-30F100 < [PRB:{D(p.X, 3)},{D(p.Y, 3)},{D(p.Z, 3)}:1]\nok\n"),
        ["grbl with commands"] =
            Lines((_, p) => $"G38.2 F420Y-40.0\r\n\r\n[PRB:{D(p.X, 3)},{D(p.Y, 3)},{D(p.Z, 3)},0.000,0.000:1]\nok\r\nM493.1\r\nok\r\n"),
        ["dprnt"] = "%\r\n" + Lines((n, p) => $"P{n} X{D(p.X, 4, 9)} Y{D(p.Y, 4, 9)} Z{D(p.Z, 4, 8)}\r\n") + "%\r\n",
        ["dprnt of a serial line"] = "\u0012%\r\n" + Lines((n, p) => $"N{n} X{D(p.X, 4, 9)}Y{D(p.Y, 4, 9)}\r\n") + "%\u0014\r\n",
        ["dprnt comma"] = "%\r\n" + Lines((n, p) => $"{n}, {D(p.X, 4, 9)},{D(p.Y, 4, 9)}\r\n") + "%\r\n",
        ["dprnt sign apart"] = "%\r\n" + Lines((n, p) => $"{n},{Apart(p.X)},{Apart(p.Y)}\r\n") + "%\r\n",
        ["dprnt without labels"] = Lines((_, p) => $"X{Apart(p.X)} Y{Apart(p.Y)}\n") + "%\n",
        ["dprnt closed only"] = Lines((n, p) => $"{n} {D(p.X, 4, 9)} {D(p.Y, 4, 9)} {D(p.Z, 4, 9)}\n") + "%",
        ["results file"] =
            "RESULTSFILE PLATE_RESULTS\nSTART\nDOCUMENTID 7\nTOOLPATHID 12\nTOOLPATH Outline\nG331 N1 A-90. B0. C0. X0. Y1.8 Z0.\n"
            + "G330 N1 A0. B0. C0. X0 Y0 Z0 I0 R0\n"
            + Lines((n, p) => $"G800 N{n} X{D(p.X + 0.01, 4)} Y{D(p.Y + 0.02, 4)} Z{D(p.Z, 4)} I0.6 J-0.8 K0. O0. U0.05 L0.05\n"
                + $"G801 N{n} X{D(p.X + 1.8, 4)} Y{D(p.Y - 2.4, 4)} Z{D(p.Z, 4)} R3.\n")
            + "END\n",
        ["results file, normals into the piece"] =
            "START\n"
            + Lines((n, p) => $"G800 N{n} X{D(p.X, 4)} Y{D(p.Y, 4)} Z{D(p.Z, 4)} I-0.6 J0.8 K0.\n"
                + $"G801 N{n} X{D(p.X + 1.8, 4)} Y{D(p.Y - 2.4, 4)} Z{D(p.Z, 4)} R3.\n")
            + "END\n",
        ["results file, nominal centers"] =
            "START\n"
            + Lines((n, p) => $"G800 N{n} X{D(p.X + 1.79, 4)} Y{D(p.Y - 2.4, 4)} Z{D(p.Z, 4)} I-0.6 J0.8 K0. O0.\n"
                + $"G801 N{n} X{D(p.X + 1.8, 4)} Y{D(p.Y - 2.4, 4)} Z{D(p.Z, 4)} R3.\n")
            + "END\n",
        ["renishaw"] = Lines((n, p) => $"{new string('-', 60)}\r\n   COMPONENT NO 4     FEATURE NO {n}\r\n{new string('-', 60)}\r\n"
            + $"SIZE D10.0000 ACTUAL 10.0021 TOL 0.0500 DEV 0.0021\r\nPOSN X{D(p.X, 4)} ACTUAL {D(p.X, 4)} TOL TP 0.0500 DEV 0.0000\r\n"
            + $"          +++++OUT OF POS+++++ ERROR TP 0.0112 RADIAL\r\n"
            + $"POSN Y{D(p.Y - 0.01, 4)} ACTUAL {D(p.Y, 4)} TOL 0.0500 DEV 0.0100\r\n"),
        ["siemens"] = "Messprotokoll\n" + Lines((n, p) => $"CYCLE978 {n}  X Soll {D(p.X, 3)} Ist {D(p.X, 3)} Diff 0.000\n"
            + $"CYCLE978 {n}  Y Soll {D(p.Y - 0.5, 3)} Ist {D(p.Y, 3)} Diff 0.500\n"),
    };

    public static byte[] Bytes(string text) => Encoding.Latin1.GetBytes(text);

    private static string Lines(Func<int, Point3, string> line) =>
        string.Concat(Points.Select((p, i) => line(i + 1, p)));

    private static string Apart(double value) => (value < 0 ? "-" : " ") + D(Math.Abs(value), 4, 9);

    private static string D(double value, int decimals, int width = 0) =>
        value.ToString("F" + decimals.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture).PadLeft(width);
}
