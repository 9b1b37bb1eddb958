using ErrorMatching.Geometry;
using ErrorMatching.Reporting;
using MathNet.Numerics.LinearAlgebra;

namespace ErrorMatching.Mating;

/// <summary>The motion of a part as a whole that explains the most of what was measured, in the part's frame.</summary>
/// <param name="ShiftMm">Its shift at the middle of the key points.</param>
/// <param name="TurnDeg">Its turn about that place, counterclockwise.</param>
/// <param name="Explains">Its share in the sum of squares of the deviations, 0 to 1.</param>
/// <param name="IsSignificant">True if it is more than the noise of the points: with a risk of one in a thousand.</param>
/// <param name="LargestMm">How far it moves a key point, at most.</param>
/// <param name="MostMm">The distance beyond which it asks whether the origin is right; null if any motion is expected.</param>
public sealed record CommonMotion(
    Vector2 ShiftMm, double TurnDeg, double Explains, bool IsSignificant, double LargestMm, double? MostMm)
{
    // A motion that leaves more than a tenth is not the only cause.
    private const double NearlyAll = 0.9;

    // The largest risk that noise is taken for a motion.
    private const double Risk = 0.001;

    // A direction in which no normal has more than this share of the best one is not told.
    private const double LeastShare = 0.02;

    /// <summary>Standard uncertainty of the shift in X and in Y, mm, and of the turn, degrees.</summary>
    public required (double X, double Y, double TurnDeg) Uncertainty { get; init; }

    /// <summary>True if it is more than a part can be expected to be off: is the origin right?</summary>
    public bool AsksForOrigin => IsSignificant && Explains >= NearlyAll && LargestMm > MostMm;

    /// <summary>The motion of least squares; null if the points are too few to tell it from their own errors.</summary>
    /// <remarks>d = n . t + w (p x n) at each key point, method, section 11. Directions that no normal determines stay 0.</remarks>
    /// <param name="points">The key points.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a deviation.</param>
    /// <param name="mostMm">The distance beyond which a motion asks whether the origin is right; null for none.</param>
    internal static CommonMotion? Find(IReadOnlyList<BoundaryPoint> points, double uncertaintyMm, double? mostMm)
    {
        var n = points.Count;
        var squares = points.Sum(p => p.MeasuredMm * p.MeasuredMm);
        if (n < 3 || squares == 0)
        {
            return null;
        }

        var middle = new Point2(points.Average(p => p.Present.X), points.Average(p => p.Present.Y));
        var length = Math.Sqrt(points.Average(p => Square((p.Present - middle).Length)));
        var scale = length > 0 ? length : 1;
        var design = Matrix<double>.Build.Dense(n, 3, (i, k) => k switch
        {
            0 => points[i].Normal.X,
            1 => points[i].Normal.Y,
            _ => (points[i].Present - middle).Cross(points[i].Normal) / scale,
        });
        var values = Vector<double>.Build.Dense(n, i => points[i].MeasuredMm);
        var svd = design.Svd();
        int[] told = [.. Enumerable.Range(0, Math.Min(3, n)).Where(k => svd.S[k] > LeastShare * svd.S[0])];
        if (n - told.Length < 2)
        {
            return null;
        }

        var motion = Vector<double>.Build.Dense(3);
        double[] variances = [0, 0, 0];
        foreach (var k in told)
        {
            motion += svd.VT.Row(k) * (svd.U.Column(k).DotProduct(values) / svd.S[k]);
            for (var i = 0; i < 3; i++)
            {
                variances[i] += Square(svd.VT[k, i] / svd.S[k]);
            }
        }

        var left = Math.Min(squares, (values - (design * motion)).DotProduct(values - (design * motion)));
        var noise = Math.Max(Math.Sqrt(left / (n - told.Length)), Math.Max(uncertaintyMm, DeviationField.LeastUncertaintyMm));
        var turn = motion[2] / scale;
        return new(
            new(motion[0], motion[1]),
            Angle.FromRadians(turn).Degrees,
            1 - (left / squares),
            ChiSquaredDistribution.Above((squares - left) / Square(noise), told.Length) < Risk,
            points.Max(p => (new Vector2(motion[0], motion[1]) + ((p.Present - middle).Left * turn)).Length),
            mostMm)
        {
            Uncertainty = (
                noise * Math.Sqrt(variances[0]),
                noise * Math.Sqrt(variances[1]),
                Angle.FromRadians(noise * Math.Sqrt(variances[2]) / scale).Degrees),
        };
    }

    internal void Write(ReportWriter w)
    {
        w.Number("x", ShiftMm.X);
        w.Number("y", ShiftMm.Y);
        w.Number("turnDeg", TurnDeg);
        w.Number("explains", Explains);
        w.Flag("significant", IsSignificant);
        w.Number("uncertaintyXMm", Uncertainty.X);
        w.Number("uncertaintyYMm", Uncertainty.Y);
        w.Number("uncertaintyTurnDeg", Uncertainty.TurnDeg);
        w.Number("largestMm", LargestMm);
        w.Number("mostMm", MostMm);
    }

    internal static CommonMotion Read(ReportReader r) => new(
        new(r.Number("x"), r.Number("y")),
        r.Number("turnDeg"),
        r.Number("explains"),
        r.Flag("significant"),
        r.Number("largestMm"),
        r.OptionalNumber("mostMm"))
    {
        Uncertainty = (r.Number("uncertaintyXMm"), r.Number("uncertaintyYMm"), r.Number("uncertaintyTurnDeg")),
    };

    private static double Square(double value) => value * value;
}
