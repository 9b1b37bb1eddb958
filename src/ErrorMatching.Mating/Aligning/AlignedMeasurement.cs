using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>A measurement prepared for comparison: contact points in the plane of their feature, aligned as the job requests.</summary>
/// <param name="File">The measurement.</param>
/// <param name="Alignment">The alignment applied and its residuals over the key points, in the order of the job.</param>
/// <param name="Points">The aligned points by label.</param>
/// <param name="StandsOut">Points out of their feature's plane, with their distance from it; empty if the file has no Z.</param>
public sealed record AlignedMeasurement(
    MeasurementFile File,
    Alignment Alignment,
    IReadOnlyDictionary<string, Point2> Points,
    IReadOnlyList<(string Label, double Millimeters)> StandsOut)
{
    /// <summary>Code of the refusal of an alignment across features in several planes.</summary>
    public const string AlignmentNeedsOnePlane = "alignment-needs-one-plane";

    /// <summary>Code of the refusal of centers of a ball whose diameter the job does not state.</summary>
    public const string StylusMissing = "stylus-missing";

    /// <summary>Distance from the plane above which a point is reported, mm.</summary>
    private const double Flat = 0.001;

    /// <summary>Why a job's alignment cannot be computed, or null.</summary>
    internal static Refusal? Check(MatingJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return job.Alignment.Kind == JobAlignmentKind.None || job.Features.All(f => f.Plane == job.Features[0].Plane)
            ? null
            : new(
                AlignmentNeedsOnePlane,
                "The features lie in several planes, so one alignment cannot serve all. Make a job for each plane, or align in the gauge.");
    }

    /// <summary>Transforms a measurement to the part's frame.</summary>
    /// <param name="job">The job.</param>
    /// <param name="maps">The mapped features, for the normals along which a ball touches.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="measured">The measurement.</param>
    /// <param name="piece">The piece that was measured.</param>
    /// <exception cref="InputException">A point is missing, or has no coordinate in its feature's plane.</exception>
    /// <exception cref="GeometryException">The points do not determine the alignment.</exception>
    internal static AlignedMeasurement Align(
        MatingJob job, IReadOnlyList<FeatureMap> maps, MeasurementFile theoretical, MeasurementFile measured, MeasuredPiece piece)
    {
        measured.Require(job.NeededPoints);
        var labels = new List<string>();
        var (actual, nominal, toContact) = (new List<Point2>(), new List<Point2>(), new List<Vector2>());

        var standsOut = new List<(string, double)>();
        foreach (var map in maps)
        {
            for (var i = 0; i < map.Feature.Points.Count; i++)
            {
                var label = map.Feature.Points[i];
                var (want, have) = (
                    ProjectedPoint.Of(theoretical[label], map.Feature.Plane, theoretical.File),
                    ProjectedPoint.Of(measured[label], map.Feature.Plane, measured.File));
                if (have.StandsOutMm(want) is { } height && Math.Abs(height) >= Flat)
                {
                    standsOut.Add((label, height));
                }

                labels.Add(label);
                toContact.Add(
                    StylusCenter.ToContact(want.Position, RadiusMm(job, measured, label), map.Normals[i], piece) - want.Position);
                nominal.Add(want.Position - toContact[^1]);
                actual.Add(have.Position);
            }
        }

        // Align balls with where their centers should be, and only then move them to the contact: the normals are in the part's frame,
        // which a piece reaches by its alignment.
        var alignment = Align(job, theoretical, measured, actual, nominal);
        var points = new Dictionary<string, Point2>(labels.Count, StringComparer.Ordinal);
        for (var i = 0; i < labels.Count; i++)
        {
            points.Add(labels[i], alignment.Aligned[i] + toContact[i]);
        }

        return new(measured, alignment, points, standsOut);
    }

    // A file that states the radius of its ball was read as contacts. A probing log says of each point what it is, whatever the job says.
    private static double RadiusMm(MatingJob job, MeasurementFile measured, string label)
    {
        if (!(measured.IsCenter(label) ?? (job.Gauge.Reports == ProbeReport.StylusCenter && !measured.IsContact)))
        {
            return 0;
        }

        return job.Gauge.StylusDiameterMm / 2 ?? throw InputException.At(
            StylusMissing,
            measured.File,
            "it has the centers of the stylus ball, and the job does not say how large the ball is; expected \"stylusDiameterMm\" under "
                + "\"gauge\": the diameter of the ball that touched, in mm.",
            measured[label].Line);
    }

    private static Alignment Align(
        MatingJob job, MeasurementFile theoretical, MeasurementFile measured, List<Point2> actual, List<Point2> nominal)
    {
        var asked = job.Alignment;
        return asked.Kind switch
        {
            JobAlignmentKind.Datum => Alignment.Datum(Datum(measured), Datum(theoretical), actual, nominal),
            JobAlignmentKind.BestFit => Alignment.BestFit(actual, nominal, Freedom(asked)),
            _ => Alignment.None(actual, nominal),
        };

        Segment2 Datum(MeasurementFile file) => new(In(file, asked.Origin!), In(file, asked.Direction!));

        Point2 In(MeasurementFile file, string label) => ProjectedPoint.Of(file[label], job.Features[0].Plane, file.File).Position;
    }

    private static AlignmentFreedom Freedom(JobAlignment asked) =>
        (asked.LockX ? AlignmentFreedom.None : AlignmentFreedom.X) | (asked.LockY ? AlignmentFreedom.None : AlignmentFreedom.Y) | (
            asked.LockRotation ? AlignmentFreedom.None : AlignmentFreedom.Rotation);
}
