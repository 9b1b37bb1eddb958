using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>How the files of <c>samples/dovetail</c> were made: the outline of the key, the true errors of the part, and a gauge with
/// noise. The outline is traversed as it is cut, with the material on the right; normals point to the tool.</summary>
internal static class DovetailPart
{
    public const double ToolRadius = 4;
    public const double UncertaintyMm = 0.002;

    private const double CornerRadius = 5;
    private const double EdgeRadius = 1;
    private const double CamFrom = 10;
    private const double CamLength = 26;
    private const double CamHeight = 2.5;

    private static readonly double CornerX = 40 + (CornerRadius * Math.Sqrt(3));
    private static readonly double EdgeLength = EdgeRadius * Math.Tan(Math.PI / 8);

    /// <summary>The elements in the order of cutting, each as a function from the fraction of its extent.</summary>
    private static readonly Dictionary<string, Func<double, (Flat Place, Flat Normal)>> Elements = new(StringComparer.Ordinal)
    {
        ["L1"] = Line(new(-80, -30), new(-CornerX, -30)),
        ["F1"] = Line(Flank(-1, 0), Flank(-1, 1)),
        ["A1"] = Arc(new(-CornerX, -CornerRadius), 210, -120),
        ["T1"] = Line(new(-CornerX, 0), new(-34 - EdgeLength, 0)),
        ["V1/1"] = Line(Notch(-1, 0), Notch(-1, 1)),
        ["V1/2"] = Line(Notch(1, 1), Notch(1, 0)),
        ["T2"] = Line(new(-10 + EdgeLength, 0), new(CamFrom, 0)),
        ["C1"] = Cam,
        ["T3"] = Line(new(CamFrom + CamLength, 0), new(CornerX, 0)),
        ["A2"] = Arc(new(CornerX, -CornerRadius), 90, -120),
        ["F2"] = Line(Flank(1, 1), Flank(1, 0)),
        ["L2"] = Line(new(CornerX, -30), new(80, -30)),
    };

    private static readonly (string Element, double[] At)[] Measured =
    [
        ("L1", [0.1, 0.8]), ("F1", [0.1, 0.5, 0.9]), ("T1", [0.1, 0.9]), ("V1/1", [0.1, 0.9]), ("V1/2", [0.1, 0.9]),
        ("T2", [0.05, 0.9]), ("C1", [0.06, 0.18, 0.31, 0.44, 0.56, 0.69, 0.82, 0.94]), ("T3", [0.2, 0.9]),
        ("F2", [0.1, 0.5, 0.9]), ("L2", [0.2, 0.9]),
    ];

    /// <summary>The 28 key points.</summary>
    public static IReadOnlyList<DovetailPoint> KeyPoints => [.. Measured.SelectMany(m => m.At.Select(at => On(m.Element, at)))];

    /// <summary>Places all along the elements and the two outer corners, 41 of each.</summary>
    public static IReadOnlyList<DovetailPoint> Everywhere =>
        [.. Elements.Keys.SelectMany(e => Enumerable.Range(0, 41).Select(i => On(e, i / 40.0)))];

    /// <summary>The key points as designed.</summary>
    public static string Theoretical => Table(KeyPoints.Select(p => p.Place));

    /// <summary>The part as measured: its true errors and the noise of the gauge.</summary>
    public static string Part => Gauged(1, p => p.TrueMm);

    /// <summary>The key as the program cuts it on a machine with errors of its own.</summary>
    public static string Before => Gauged(2, p => OfTheMachine(p.Place, p.Normal));

    /// <summary>The key that follows the part exactly, except for its shoulders, which are within their limits, cut on that
    /// machine.</summary>
    public static string After => Gauged(3, p => (p.Element is "L1" or "L2" ? 0 : p.TrueMm) + OfTheMachine(p.Place, p.Normal));

    private static DovetailPoint On(string element, double at)
    {
        var (place, normal) = Elements[element](at);
        return new(element, place, normal, OfThePart(element, place, normal));
    }

    /// <summary>
    /// The part was milled in two settings and its notch in a third. Each setting shifts, turns and scales what it cuts and leaves an
    /// allowance, so lines stay lines, arcs stay arcs, and neighbors stay tangent. Over the cam, the first setting blends into the second.
    /// </summary>
    private static double OfThePart(string element, Flat place, Flat normal)
    {
        var left = Setting(place, normal, new(-0.012, 0.022), 0.00035, 0.0005, 0.025);
        var right = Setting(place, normal, new(0.020, 0.016), -0.0004, 0.0005, 0.030);
        var share = Math.Clamp((place.U - CamFrom) / CamLength, 0, 1);
        var blend = share * share * (3 - (2 * share));
        return (left * (1 - blend)) + (right * blend)
            + (element.StartsWith('V') ? normal.Dot(new(0.030, 0.020)) : 0)
            + (element == "C1" ? 0.02 * Math.Pow(Math.Sin(Math.PI * share), 2) : 0);
    }

    private static double OfTheMachine(Flat place, Flat normal) =>
        Setting(place, normal, new(0.003, -0.002), 0.00002, 0.00003, 0.002);

    private static double Setting(Flat place, Flat normal, Flat shift, double turn, double scale, double allowance) =>
        (shift + (place.Left * turn) + (place * scale)).Dot(normal) + allowance;

    private static string Gauged(ulong seed, Func<DovetailPoint, double> deviation)
    {
        var noise = Normal(seed).GetEnumerator();
        return Table(KeyPoints.Select(p =>
        {
            noise.MoveNext();
            return p.Place + (p.Normal * (deviation(p) + (UncertaintyMm * noise.Current)));
        }));
    }

    private static string Table(IEnumerable<Flat> places) => "point,x_mm,y_mm\n" + string.Concat(
        places.Select((p, i) => string.Create(CultureInfo.InvariantCulture, $"{i + 1},{p.U:F4},{p.V:F4}\n")).Select(l =>
            l.Replace(",-0.0000", ",0.0000", StringComparison.Ordinal)));

    /// <summary>Normal deviates by the method of Box and Muller from SplitMix64, which is the same everywhere and always.</summary>
    private static IEnumerable<double> Normal(ulong state)
    {
        double Next()
        {
            state += 0x9E3779B97F4A7C15UL;
            var mixed = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9UL;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
            return Math.ScaleB((mixed ^ (mixed >> 31)) >> 11, -53);
        }

        while (true)
        {
            var radius = Math.Sqrt(-2 * Math.Log(1 - Next()));
            yield return radius * Math.Cos(2 * Math.PI * Next());
        }
    }

    private static Func<double, (Flat Place, Flat Normal)> Line(Flat from, Flat to) =>
        at => (from + ((to - from) * at), (to - from).Unit().Left);

    private static Func<double, (Flat Place, Flat Normal)> Arc(Flat center, double fromDegrees, double sweepDegrees) => at =>
    {
        var spoke = Flat.Toward((fromDegrees + (sweepDegrees * at)) * Math.PI / 180);
        return (center + (spoke * CornerRadius), spoke);
    };

    private static (Flat Place, Flat Normal) Cam(double at)
    {
        var slope = CamHeight * Math.PI / CamLength * Math.Cos(Math.PI * at);
        return (new(CamFrom + (CamLength * at), CamHeight * Math.Sin(Math.PI * at)), new Flat(1, slope).Unit().Left);
    }

    /// <summary>The straight part of a flank of 60 degrees, 30 mm high: its lower end (0) and its upper end (1).</summary>
    private static Flat Flank(int side, int end)
    {
        var up = new Flat(side * 0.5, Math.Sqrt(0.75));
        var cut = CornerRadius * Math.Sqrt(3);
        return end == 0 ? new Flat(side * 40, -30) + (up * cut) : new Flat(side * (40 + (30 / Math.Sqrt(3))), 0) - (up * cut);
    }

    /// <summary>The straight part of a flank of the notch of 90 degrees, 12 mm deep at -22: its upper end (0) and its lower end
    /// (1).</summary>
    private static Flat Notch(int side, int end)
    {
        var down = new Flat(-side, -1).Unit();
        return end == 0 ? new Flat(-22 + (side * 12), 0) + (down * EdgeLength) : new Flat(-22, -12) - (down * CornerRadius);
    }
}
