using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Checks whether a measurement would fit the theoretical points if its columns were exchanged, or an axis pointed the other
/// way.</summary>
internal static class ColumnCheck
{
    /// <summary>The refusal of the first measurement that fits only if it is read otherwise; null if there is none. Without an alignment,
    /// points must lie where they are designed; with one, the piece may lie anywhere, but not mirrored.</summary>
    public static Refusal? Refuse(MatingJob job, MeasurementFile theoretical, params ReadOnlySpan<MeasurementFile?> measurements)
    {
        foreach (var file in measurements)
        {
            if (file is not null && Other(job, theoretical, file) is { } name)
            {
                return RefusalForms.Refusal(RefusalForms.ColumnsDiffer, new() { File = file.File }, theoretical.File, name);
            }
        }

        return null;
    }

    private static string? Other(MatingJob job, MeasurementFile theoretical, MeasurementFile measured)
    {
        var (designed, found, hasZ) = (new List<Point3>(), new List<Point3>(), true);
        foreach (var label in job.KeyPoints)
        {
            // A missing point is reported where it is needed.
            if (!theoretical.TryGet(label, out var want) || !measured.TryGet(label, out var have))
            {
                return null;
            }

            hasZ &= want.HasZ && have.HasZ;
            designed.Add(want.Position);
            found.Add(have.Position);
        }

        if (!hasZ)
        {
            (designed, found) = ([.. designed.Select(Flat)], [.. found.Select(Flat)]);
        }

        var limit = job.Compensation.LimitMm;
        return job.Alignment.Kind != JobAlignmentKind.None
            ? IsMirrored(designed, found, limit) ? AxisOrder.InPlane[0].Name : null
            : AxisOrder.Fitting(hasZ ? AxisOrder.InSpace : AxisOrder.InPlane, found, designed, limit)?.Name;
    }

    // As complex numbers about their middle: the best turn leaves |a|2 + |b|2 - 2 |sum of a times conjugate b|, and the best turn of the
    // mirrored points leaves the same without the conjugate.
    private static bool IsMirrored(List<Point3> designed, List<Point3> found, double limit)
    {
        var (a, b) = (Centered(designed), Centered(found));
        var square = 0.0;
        var (turned, mirrored) = (default(Vector2), default(Vector2));
        for (var i = 0; i < a.Length; i++)
        {
            square += a[i].Dot(a[i]) + b[i].Dot(b[i]);
            turned += new Vector2((a[i].X * b[i].X) + (a[i].Y * b[i].Y), (a[i].Y * b[i].X) - (a[i].X * b[i].Y));
            mirrored += new Vector2((a[i].X * b[i].X) - (a[i].Y * b[i].Y), (a[i].Y * b[i].X) + (a[i].X * b[i].Y));
        }

        return Rms(turned) > limit && Rms(mirrored) < limit;

        double Rms(Vector2 sum) => Math.Sqrt(Math.Max(0, square - (2 * sum.Length)) / a.Length);
    }

    private static Vector2[] Centered(List<Point3> points)
    {
        var (x, y) = (points.Average(p => p.X), points.Average(p => p.Y));
        return [.. points.Select(p => new Vector2(p.X - x, p.Y - y))];
    }

    private static Point3 Flat(Point3 point) => point with { Z = 0 };
}
