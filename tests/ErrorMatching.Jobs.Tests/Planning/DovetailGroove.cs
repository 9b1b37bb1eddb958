using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The groove of the sample "dovetail" with its boundary displaced: by how much is known of each feature, from the key's
/// material to its tool. Its corners are sharp, away from all key points.</summary>
internal static class DovetailGroove
{
    /// <summary>What each feature of the sample's job is displaced by, mm.</summary>
    public static readonly IReadOnlyDictionary<string, double> DisplacedMm = new Dictionary<string, double>
    {
        ["L1"] = 0.012,
        ["F1"] = -0.045,
        ["T1"] = 0.061,
        ["V1"] = 0.034,
        ["T2"] = 0.052,
        ["C1"] = -0.038,
        ["T3"] = 0.027,
        ["F2"] = 0.048,
        ["L2"] = -0.009,
    };

    // The cam of the sample's README.
    private const double From = 10, To = 36, Rise = 2.5;

    /// <summary>How far a key point was found off along its normal, mm.</summary>
    public static double OffMm(ReportKeyPoint point) => (point.Actual - point.Theoretical).Dot(point.Normal);

    /// <summary>The material of the groove, in its own frame; of a key with the same boundary, the material below it.</summary>
    public static IReadOnlyList<Point2> Polygon(bool ofKey = false) => Polygon(DisplacedMm, ofKey, 2000);

    /// <summary>The same of a groove with other displacements, in which the cam has so many chords.</summary>
    public static IReadOnlyList<Point2> Polygon(IReadOnlyDictionary<string, double> displacedMm, bool ofKey, int chords)
    {
        var (half, deep) = (Math.Sqrt(3) / 2, -30.0);
        (Point2 At, Vector2 Along)[] lines =
        [
            Moved("L1", new(-200, deep), new(1, 0)),
            Moved("F1", new(-40, deep), new(-0.5, half)),
            Moved("T1", new(-50, 0), new(1, 0)),
            Moved("V1", new(-22, -12), new(Math.Sqrt(0.5), -Math.Sqrt(0.5))),
            Moved("V1", new(-22, -12), new(Math.Sqrt(0.5), Math.Sqrt(0.5))),
            Moved("T2", new(0, 0), new(1, 0)),
        ];
        var points = new List<Point2> { lines[0].At };
        for (var i = 0; i + 1 < lines.Length; i++)
        {
            points.Add(Crossing(lines[i], lines[i + 1]));
        }

        points.Add(new(From, D("T2")));
        for (var k = 0; k <= chords; k++)
        {
            var x = From + ((To - From) * k / chords);
            var phase = Math.PI * (x - From) / (To - From);
            var slope = new Vector2(1, Rise * Math.PI / (To - From) * Math.Cos(phase));
            points.Add(new Point2(x, Rise * Math.Sin(phase)) + (slope.Normalize().Left * D("C1")));
        }

        points.Add(new(To, D("T3")));
        (Point2 At, Vector2 Along)[] last =
        [
            Moved("T3", new(To, 0), new(1, 0)), Moved("F2", new(40, deep), new(-0.5, -half)), Moved("L2", new(200, deep), new(1, 0)),
        ];
        points.Add(Crossing(last[0], last[1]));
        points.Add(Crossing(last[1], last[2]));
        points.Add(last[2].At);
        return [.. points, new(200, ofKey ? -100 : 100), new(-200, ofKey ? -100 : 100)];

        double D(string feature) => displacedMm[feature];

        // Along the boundary with the key's material on the right, so that its tool is on the left.
        (Point2 At, Vector2 Along) Moved(string feature, Point2 at, Vector2 along) => (at + (along.Left * D(feature)), along);
    }

    private static Point2 Crossing((Point2 At, Vector2 Along) one, (Point2 At, Vector2 Along) other) =>
        one.At + (one.Along * ((other.At - one.At).Cross(other.Along) / one.Along.Cross(other.Along)));
}
