using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>A measured point whose error contradicts its neighbors.</summary>
/// <param name="Sample">The point.</param>
/// <param name="SaidMm">The error that its neighbors predict, in millimeters, positive out of the material.</param>
internal sealed record OutlyingPoint(ErrorSample Sample, double SaidMm)
{
    private const int MostNamed = 10;

    /// <summary>Error minus prediction, in millimeters.</summary>
    public double OffMm => Sample.ErrorMm - SaidMm;

    /// <summary>Describes the furthest of some points with place and both errors, and lists the other numbers. No final period.</summary>
    /// <param name="points">At least one.</param>
    public static string Words(IReadOnlyList<OutlyingPoint> points)
    {
        var (furthest, others) = Values(points);
        return string.Format(
            CultureInfo.InvariantCulture,
            "Point {0} (near {1}) is {2} µm off along the normal, where the points around it say {3} µm",
            [.. furthest])
            + (others.Length == 0 ? "" : $"; likewise off {(points.Count == 2 ? "is point" : "are points")} {others}");
    }

    /// <summary>What the words state: number, place and both errors in um of the furthest point, and the numbers of the others.</summary>
    /// <param name="points">At least one.</param>
    public static (string[] Furthest, string Others) Values(IReadOnlyList<OutlyingPoint> points)
    {
        var worst = Furthest(points);
        var others = points.Where(p => p != worst).Select(p => Number(p.Sample)).ToArray();
        return (
            [Number(worst.Sample), PlaceText.Words(worst.Sample.Nominal), Um(worst.Sample.ErrorMm), Um(worst.SaidMm)],
            string.Join(", ", others.Take(MostNamed)) + (others.Length > MostNamed ? ", ..." : ""));
    }

    /// <summary>The point that is furthest off.</summary>
    /// <param name="points">At least one.</param>
    public static OutlyingPoint Furthest(IReadOnlyList<OutlyingPoint> points) => points.MaxBy(p => Math.Abs(p.OffMm))!;

    private static string Number(ErrorSample sample) => sample.Point.ToString(CultureInfo.InvariantCulture);

    private static string Um(double mm) => (mm * 1000).ToString("+0.0;-0.0;0.0", CultureInfo.InvariantCulture);
}
