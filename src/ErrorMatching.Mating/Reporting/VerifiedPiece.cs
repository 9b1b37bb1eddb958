using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The verified counterpart as a result for other systems (<see cref="QifWriter"/>, <see cref="AqdefWriter"/>).</summary>
public static class VerifiedPiece
{
    /// <summary>The counterpart that was cut with compensation: wanted is the measured part, the deviation is the mating error along the
    /// normal, and its limits are those of the feature.</summary>
    /// <param name="report">The verification.</param>
    /// <param name="job">The job, which knows the planes of the points. A coordinate across a plane is 0.</param>
    public static PieceResult Of(VerifyReport report, MatingJob job)
    {
        ArgumentNullException.ThrowIfNull(report);
        ArgumentNullException.ThrowIfNull(job);
        var planes = job.Features.SelectMany(f => f.Points.Select(p => (Label: p, f.Plane)))
            .ToDictionary(p => p.Label, p => p.Plane, StringComparer.Ordinal);
        return new(
            report.Job.Name,
            ReportInputs.Find(report.Inputs, "counterpart-after")?.Sha256 ?? "",
            [.. report.Result.Points.Select(p => Of(p, planes[p.Label], report.Result.BandOf(p.Label)))])
        {
            WorkOrder = report.Job.WorkOrder,
        };
    }

    private static PointResult Of(VerifiedPoint point, CoordinatePlane plane, ToleranceBand? band) => new(
        point.Label,
        plane.Lift(point.Part, 0),
        plane.Lift(point.After, 0),
        plane.Lift(Point2.Origin + point.Normal, 0) - default(Point3),
        point.AfterError.NormalMm)
    {
        HasZ = plane != CoordinatePlane.XY,
        Limits = band is { } limits ? (limits.LowerMm, limits.UpperMm) : null,
    };
}
