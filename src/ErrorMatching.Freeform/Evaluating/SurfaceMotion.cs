using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The motion of a piece as a whole that explains the most of its measured errors: a shift at the middle of the points, and a turn
/// about it.</summary>
/// <remarks>Least squares of e = n . t + (p x n) . w. Directions that the normals do not determine stay zero.</remarks>
/// <param name="ShiftMm">The shift.</param>
/// <param name="TurnDegrees">The turn, as small angles about X, Y and Z.</param>
/// <param name="Explains">Its share in the sum of squares of the errors, 0 to 1.</param>
/// <param name="IsSignificant">True if noise makes as much with a probability of less than one in a thousand.</param>
/// <param name="LargestMm">How far it moves a point off the surface, at most: along the surface, the points hardly tell it.</param>
/// <param name="MostMm">The distance beyond which it asks whether the origin is right.</param>
public sealed record SurfaceMotion(
    Vector3 ShiftMm, Vector3 TurnDegrees, double Explains, bool IsSignificant, double LargestMm, double MostMm)
{
    // A motion that leaves more than a tenth is not the only cause.
    private const double NearlyAll = 0.9;

    // The largest risk that noise is taken for a motion.
    private const double Risk = 0.001;

    // A direction in which the points resist with less than this share of the best one is not told: the square of 2 %.
    private const double LeastShare = 0.0004;

    /// <summary>Standard uncertainty of the shift in millimeters.</summary>
    public required Vector3 ShiftUncertaintyMm { get; init; }

    /// <summary>Standard uncertainty of the turn in degrees.</summary>
    public required Vector3 TurnUncertaintyDegrees { get; init; }

    /// <summary>True if it is more than a piece can be expected to be off.</summary>
    public bool AsksForOrigin => IsSignificant && Explains >= NearlyAll && LargestMm > MostMm;

    /// <summary>What the warning of <see cref="AsksForOrigin"/> states: shift, turn, share in percent, and both distances.</summary>
    internal string[] Values =>
    [
        .. new[] { ShiftMm.X, ShiftMm.Y, ShiftMm.Z }.Select(x => x.ToString("+0.000;-0.000;0.000", CultureInfo.InvariantCulture)),
        .. new[] { TurnDegrees.X, TurnDegrees.Y, TurnDegrees.Z }.Select(
            x => x.ToString("+0.0000;-0.0000;0.0000", CultureInfo.InvariantCulture)),
        // No share is rounded up to all of it.
        (Math.Floor(1000 * Explains) / 10).ToString("0.#", CultureInfo.InvariantCulture),
        LargestMm.ToString("0.000", CultureInfo.InvariantCulture),
        MostMm.ToString("0.###", CultureInfo.InvariantCulture),
    ];

    /// <summary>Returns the motion of a measured piece; null if its points are too few to tell it from their own errors.</summary>
    /// <param name="samples">The errors.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of one of them.</param>
    /// <param name="mostMm">The distance beyond which a motion asks whether the origin is right.</param>
    internal static SurfaceMotion? Find(IReadOnlyList<ErrorSample> samples, double uncertaintyMm, double mostMm)
    {
        var squares = samples.Sum(s => s.ErrorMm * s.ErrorMm);
        if (squares == 0)
        {
            return null;
        }

        var center = default(Point3) + (samples.Aggregate(default(Vector3), (sum, s) => sum + (s.Nominal - default(Point3)))
            * (1.0 / samples.Count));
        // Turns are scaled by the size of the piece, so that all unknowns are lengths.
        var size = samples.Max(s => (s.Nominal - center).Length);
        var rows = samples.Select(s => Row(s.Normal, (s.Nominal - center).Cross(s.Normal) * (1 / size))).ToArray();
        var eigen = new SymmetricEigen([
            .. Enumerable.Range(0, 6).Select(i => Enumerable.Range(0, 6).Select(j => rows.Sum(r => r[i] * r[j])).ToArray())]);
        var (motion, variances, told, explained) = (new double[6], new double[6], 0, 0.0);
        for (var k = 0; k < 6 && eigen.Values[k] > LeastShare * eigen.Values[0]; k++)
        {
            var direction = eigen.Vectors[k];
            var along = rows.Zip(samples, (r, s) => Vectors.Dot(r, direction) * s.ErrorMm).Sum();
            for (var i = 0; i < 6; i++)
            {
                motion[i] += direction[i] * along / eigen.Values[k];
                variances[i] += direction[i] * direction[i] / eigen.Values[k];
            }

            told++;
            explained += along * along / eigen.Values[k];
        }

        if (samples.Count - told < 2)
        {
            return null;
        }

        explained = Math.Min(explained, squares);
        var noise = Math.Max(Math.Sqrt((squares - explained) / (samples.Count - told)), uncertaintyMm);
        var (shift, turn) = (new Vector3(motion[0], motion[1], motion[2]), new Vector3(motion[3], motion[4], motion[5]) * (1 / size));
        double[] uncertainties = Array.ConvertAll(variances, v => noise * Math.Sqrt(v));
        const double Degrees = 180 / Math.PI;
        return new(
            shift,
            turn * Degrees,
            explained / squares,
            noise > 0 && ChiSquaredDistribution.Above(explained / (noise * noise), told) < Risk,
            samples.Max(s => Math.Abs(s.Normal.Dot(shift + turn.Cross(s.Nominal - center)))),
            mostMm)
        {
            ShiftUncertaintyMm = new(uncertainties[0], uncertainties[1], uncertainties[2]),
            TurnUncertaintyDegrees = new Vector3(uncertainties[3], uncertainties[4], uncertainties[5]) * (Degrees / size),
        };
    }

    internal void Write(ReportWriter json)
    {
        json.Number("x", ShiftMm.X);
        json.Number("y", ShiftMm.Y);
        json.Number("z", ShiftMm.Z);
        json.Numbers("turnDeg", [TurnDegrees.X, TurnDegrees.Y, TurnDegrees.Z]);
        json.Number("explains", Explains);
        json.Flag("significant", IsSignificant);
        json.Numbers("uncertaintyMm", [ShiftUncertaintyMm.X, ShiftUncertaintyMm.Y, ShiftUncertaintyMm.Z]);
        json.Numbers("uncertaintyTurnDeg", [TurnUncertaintyDegrees.X, TurnUncertaintyDegrees.Y, TurnUncertaintyDegrees.Z]);
        json.Number("largestMm", LargestMm);
        json.Number("mostMm", MostMm);
    }

    internal static SurfaceMotion Read(ReportReader json) => new(
        new(json.Number("x"), json.Number("y"), json.Number("z")),
        json.Vector3("turnDeg"),
        json.Number("explains"),
        json.Flag("significant"),
        json.Number("largestMm"),
        json.Number("mostMm"))
    {
        ShiftUncertaintyMm = json.Vector3("uncertaintyMm"),
        TurnUncertaintyDegrees = json.Vector3("uncertaintyTurnDeg"),
    };

    private static double[] Row(Vector3 normal, Vector3 moment) => [normal.X, normal.Y, normal.Z, moment.X, moment.Y, moment.Z];
}
