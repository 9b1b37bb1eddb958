using System.Globalization;

namespace ErrorMatching.Cell.Tests;

/// <summary>A cell whose one job corrects a rectangular boss by offsets of a LinuxCNC control: its slot gets the program of the
/// offsets.</summary>
internal static class OffsetCell
{
    /// <summary>Name of the program of the offsets at the machine.</summary>
    public const string Program = "OFFSETS.NGC";

    /// <summary>The program that cuts, which the cell never writes.</summary>
    public const string Cutting = """
        %
        G21 G17 G40 G90 G54
        T1 M6
        G0 Z5
        G0 X-10 Y-10
        G1 Z-2 F300
        N10 G42 D1 X-6 Y0
        N20 X40 Y0
        N30 X40 Y30
        N40 X0 Y30
        N50 X0 Y-6
        N60 G40 X-10 Y-10
        G0 Z5
        M2
        %

        """;

    private static readonly (string Name, double X, double Y, double NormalX, double NormalY)[] Points =
    [
        ("1", 8, 0, 0, -1), ("2", 32, 0, 0, -1), ("3", 40, 6, 1, 0), ("4", 40, 24, 1, 0),
        ("5", 32, 30, 0, 1), ("6", 8, 30, 0, 1), ("7", 0, 24, -1, 0), ("8", 0, 6, -1, 0),
    ];

    /// <summary>Lays the cell out.</summary>
    /// <param name="from">The piece that is compensated.</param>
    /// <param name="allow">The offsets that the job allows, as JSON.</param>
    /// <param name="policy">The cell's policy.</param>
    /// <param name="more">Keys of the job's correction.</param>
    /// <param name="uncertaintyMm">Of the gauge.</param>
    public static ConfiguredCell Of(
        string from = "part",
        string allow = "\"tool-wear\", \"work-offset\"",
        string policy = """{ "approve": "automatic", "limitMm": 0.1, "sumLimitMm": 0.2 }""",
        string more = "",
        double uncertaintyMm = 0.0001)
    {
        var cell = new ConfiguredCell(Configuration(from, policy));
        Directory.CreateDirectory(cell.PathOf("job"));
        File.WriteAllText(cell.PathOf("job/boss.ngc"), Cutting);
        File.WriteAllText(cell.PathOf("job/theoretical.csv"), Measured((_, _) => (0, 0)));
        File.WriteAllText(cell.PathOf("job/job.json"), string.Create(CultureInfo.InvariantCulture, $$"""
            {
              "kind": "mating", "name": "Boss",
              "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
              "gauge": { "format": "points", "uncertaintyMm": {{uncertaintyMm}}, "acceptCoarse": true },
              "features": [
                { "name": "L1", "kind": "line", "points": ["1", "2"], "blocks": ["N20"], "toleranceMm": [-0.002, 0.002] },
                { "name": "L2", "kind": "line", "points": ["3", "4"], "blocks": ["N30"], "toleranceMm": [-0.002, 0.002] },
                { "name": "L3", "kind": "line", "points": ["5", "6"], "blocks": ["N40"], "toleranceMm": [-0.002, 0.002] },
                { "name": "L4", "kind": "line", "points": ["7", "8"], "blocks": ["N50"], "toleranceMm": [-0.002, 0.002] }
              ],
              "counterpart": { "program": "boss.ngc", "dialect": "linuxcnc", "toolDiameterMm": 6, "measured": "counterpart.csv" },
              "compensation": { "from": "{{from}}" },
              "correction": { "allow": [{{allow}}], "otherCuts": "may-move", "firstVariable": 501{{more}} }
            }
            """));
        return cell;
    }

    /// <summary>The configuration but for kind, name, store, keys and logs.</summary>
    public static string Configuration(string from, string policy, string program = Program) => $$"""
        "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename", "everyMs": 20 }],
        "machines": [{ "name": "m1", "dialect": "linuxcnc", "transport": { "kind": "folder", "folder": "m1" }, "attempts": 1,
          "slots": [{ "name": "A", "program": "{{program}}" }] }],
        "jobs": [{{Job(from, "part")}}{{(from == "part" ? "" : ", " + Job(from, "counterpart"))}}],
        "policy": {{policy}}
        """;

    /// <summary>A measurement by the deviation of each place.</summary>
    /// <param name="deviation">X and Y of the deviation, by the place's normal.</param>
    public static string Measured(Func<double, double, (double X, double Y)> deviation) =>
        "point,x_mm,y_mm\n" + string.Concat(Points.Select(p =>
        {
            var (x, y) = deviation(p.NormalX, p.NormalY);
            return string.Create(CultureInfo.InvariantCulture, $"{p.Name},{p.X + x:0.000000},{p.Y + y:0.000000}\n");
        }));

    /// <summary>A piece that is larger on all sides.</summary>
    public static string Grown(double mm) => Measured((x, y) => (x * mm, y * mm));

    /// <summary>A piece that is shifted.</summary>
    public static string Shifted(double x, double y) => Measured((_, _) => (x, y));

    /// <summary>A piece that is turned about the middle of the rectangle, counterclockwise.</summary>
    public static string Turned(double degrees)
    {
        var (sin, cos) = Math.SinCos(degrees * Math.PI / 180);
        return "point,x_mm,y_mm\n" + string.Concat(Points.Select(p =>
        {
            var (x, y) = (p.X - 20, p.Y - 15);
            return string.Create(
                CultureInfo.InvariantCulture, $"{p.Name},{20 + (cos * x) - (sin * y):0.000000},{15 + (sin * x) + (cos * y):0.000000}\n");
        }));
    }

    /// <summary>A piece that no offset of the control brings: two opposite sides alone are off.</summary>
    public static string Wider(double mm) => Measured((x, _) => (x * mm, 0));

    /// <summary>The program that the machine has in the slot.</summary>
    public static byte[] Sent(ConfiguredCell cell) => File.ReadAllBytes(cell.PathOf("m1/" + Program));

    private static string Job(string from, string piece)
    {
        var (name, serial, more) = from == "part"
            ? ("boss", "(?<serial>[A-Z0-9]+)", "")
            : (piece == "part" ? "boss" : "boss-cut", "", ", \"accumulates\": true");
        return $$"""
            { "name": "{{name}}", "job": "job/job.json", "piece": "{{piece}}", "gauges": ["cmm"],
              "recognize": { "fileName": "^{{piece}}_{{serial}}" }, "machine": "m1", "slot": "A"{{more}} }
            """;
    }
}
