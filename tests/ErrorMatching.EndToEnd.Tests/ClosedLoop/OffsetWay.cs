namespace ErrorMatching.EndToEnd.Tests;

/// <summary>How a part deviates, by its number.</summary>
internal sealed class OffsetWay
{
    /// <summary>The job's <c>correction</c>: everything is allowed, and the control keeps what it did in #501 and up.</summary>
    public const string Job =
        """{ "allow": ["tool-wear", "work-offset", "blocks"], "otherCuts": "may-move", "firstVariable": 501, """
            + """ "stepDegrees": 0.5, "totalDegrees": 0.5, "stepMm": 0.6, "totalMm": 0.6 }""";

    private readonly double _growth;
    private readonly Flat _shift;
    private readonly double _turn;
    private readonly int _kind;

    public OffsetWay(RandomPart part, int seed)
    {
        var random = new Random(seed);
        _kind = seed % 4;
        Name = new[] { "growth", "shift", "turn", "shape" }[_kind];
        _growth = Signed(random, 0.02, 0.05);
        _shift = new(Signed(random, 0.02, 0.05), Signed(random, 0.02, 0.05));

        // About the middle of the key points, by what moves the outermost ones by some hundredths.
        var places = part.KeyPoints.Select(p => p.Place).ToArray();
        Middle = new(places.Average(p => p.U), places.Average(p => p.V));
        _turn = Signed(random, 0.02, 0.05) / places.Max(p => (p - Middle).Length);
    }

    public string Name { get; }

    /// <summary>Under cutter compensation a part has a tool of 0.2 mm, which a correction may make smaller.</summary>
    public static RandomPart WithTool(RandomPart part) => part with { ToolRadius = part.Flavor.Compensated ? 0.2 : part.ToolRadius };

    private Flat Middle { get; }

    public double Deviation(RandomKeyPoint point) => _kind switch
    {
        0 => _growth,
        1 => _shift.Dot(point.Normal),
        2 => (_shift + ((point.Place - Middle).Left * _turn)).Dot(point.Normal),
        _ => point.Deviation,
    };

    /// <summary>The smallest kind that leaves at most a micrometer at the key points, where this is certain; otherwise null. A growth
    /// that fits a deviation of its own, or a shift without a turn that does, are for the referee to judge.</summary>
    public string? Smallest(RandomPart part)
    {
        double[] all = [.. part.KeyPoints.Select(Deviation)];
        var spread = (all.Max() - all.Min()) / 2;
        var byWear = part.Flavor.Compensated && spread < 0.0005;
        return byWear ? "ToolWear"
            : part.Flavor.Compensated && spread < 0.003 ? null
            : _kind is 1 or 2 && all.Max(Math.Abs) > 0.003 ? "WorkOffset"
            : null;
    }

    private static double Signed(Random random, double from, double to) =>
        (from + ((to - from) * random.NextDouble())) * (random.Next(2) == 0 ? 1 : -1);
}
