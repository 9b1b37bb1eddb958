using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Checks whether a measurement and the theoretical points have the same unit. Apart from deviations, the distances between key
/// points are the same in both, however the piece is clamped or turned; in inches they are 25.4 times smaller.</summary>
internal static class UnitCheck
{
    private const double MillimetersPerInch = 25.4;

    // Files of the same piece differ only by deviations, which are small even for a boundary of one millimeter. No mating pair differs by
    // exactly the inch factor.
    private const double Margin = 0.1;

    /// <summary>The refusal of the first measurement that seems to be in inches while the theoretical points are in millimeters, or the
    /// reverse; null if all units agree.</summary>
    public static Refusal? Refuse(MatingJob job, MeasurementFile theoretical, params ReadOnlySpan<MeasurementFile?> measurements)
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

    // Ratio of measured to designed key point distances; null for fewer than two points, or if all coincide.
    private static double? Ratio(MatingJob job, MeasurementFile theoretical, MeasurementFile measured)
    {
        var (designed, found) = (new List<Point3>(), new List<Point3>());
        foreach (var label in job.KeyPoints)
        {
            // A missing point is reported where it is needed.
            if (theoretical.TryGet(label, out var want) && measured.TryGet(label, out var have))
            {
                // Without a height in one file, ignore the other file's.
                var isFlat = !(want.HasZ && have.HasZ);
                designed.Add(isFlat ? want.Position with { Z = 0 } : want.Position);
                found.Add(isFlat ? have.Position with { Z = 0 } : have.Position);
            }
        }

        var (before, after) = (Spread(designed), Spread(found));
        return before > 0 && after > 0 ? after / before : null;
    }

    // Root of the sum of squared distances from the first point; unaffected by shift and rotation.
    private static double Spread(List<Point3> points) => Math.Sqrt(points.Sum(p => (p - points[0]).Dot(p - points[0])));
}
