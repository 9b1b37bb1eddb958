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
        var worst = Furthest(points);
        var (sample, at) = (worst.Sample, worst.Sample.Nominal);
        var others = points.Where(p => p != worst).Select(p => p.Sample.Point.ToString(CultureInfo.InvariantCulture)).ToArray();
        return string.Create(
            CultureInfo.InvariantCulture,
            $"Point {sample.Point} (near {PlaceText.Words(at)}) is {sample.ErrorMm * 1000:+0.0;-0.0;0.0} um off along the normal, where "
                + $"the points around it say {worst.SaidMm * 1000:+0.0;-0.0;0.0} um")
            + (
                others.Length == 0
                    ? ""
                    : $"; likewise off {(others.Length == 1 ? "is point" : "are points")} {string.Join(", ", others.Take(MostNamed))}"
                        + (others.Length > MostNamed ? ", ..." : ""));
    }

    /// <summary>The point that is furthest off.</summary>
    /// <param name="points">At least one.</param>
    public static OutlyingPoint Furthest(IReadOnlyList<OutlyingPoint> points) => points.MaxBy(p => Math.Abs(p.OffMm))!;
}
