using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Mating;

/// <summary>
/// Whether a measurement has the unit of the theoretical points: how far the key points lie apart is the same in both, wherever a piece is
/// clamped and however it is turned, but for a deviation; in inches it is 25.4 times less.
/// </summary>
internal static class UnitCheck
{
    private const double MillimetersPerInch = 25.4;

    // Two files of one piece differ by deviations, which are small even beside a boundary of a millimeter.
    // No two pieces that differ by just this factor are mated.
    private const double Margin = 0.1;

    /// <summary>The refusal of the first measurement that seems to be in inches while the theoretical points are not,
    /// or the other way around.</summary>
    /// <returns>The refusal; null where all have one unit.</returns>
    public static MatingRefusal? Refuse(MatingJob job, MeasurementFile theoretical, params ReadOnlySpan<MeasurementFile?> measurements)
    {
        foreach (var file in measurements)
        {
            if (file is not null && Ratio(job, theoretical, file) is { } ratio && (IsInch(ratio) || IsInch(1 / ratio)))
            {
                return new(RefusalForms.UnitDiffers.Name, RefusalForms.UnitDiffers.With(file.File, ratio, theoretical.File));
            }
        }

        return null;
    }

    private static bool IsInch(double ratio) => Math.Abs((ratio / MillimetersPerInch) - 1) < Margin;

    // How many times as far apart the key points lie as they are designed; null for fewer than two points, or all at one place.
    private static double? Ratio(MatingJob job, MeasurementFile theoretical, MeasurementFile measured)
    {
        var (designed, found) = (new List<Point3>(), new List<Point3>());
        foreach (var label in job.KeyPoints)
        {
            // What is missing is said where it is needed.
            if (theoretical.TryGet(label, out var want) && measured.TryGet(label, out var have))
            {
                // A height that one of the files does not have is none of the other's.
                var isFlat = !(want.HasZ && have.HasZ);
                designed.Add(isFlat ? want.Position with { Z = 0 } : want.Position);
                found.Add(isFlat ? have.Position with { Z = 0 } : have.Position);
            }
        }

        var (before, after) = (Spread(designed), Spread(found));
        return before > 0 && after > 0 ? after / before : null;
    }

    // Root of the sum of squared distances from the first point: neither shift nor turn changes it.
    private static double Spread(List<Point3> points) => Math.Sqrt(points.Sum(p => (p - points[0]).Dot(p - points[0])));
}
