using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A compensated surface, its inputs, and the expected outcome. Lengths in millimeters.</summary>
public sealed record CompensationResult
{
    internal CompensationResult()
    {
    }

    /// <summary>The inputs.</summary>
    public required CompensationInput Input { get; init; }

    /// <summary>The alignment of the points to the surface; null if they were not moved.</summary>
    public required SurfaceAlignment? Alignment { get; init; }

    /// <summary>The motion of the whole piece that explains the most of the errors; null if the points do not tell it, or were
    /// aligned.</summary>
    public required SurfaceMotion? Motion { get; init; }

    /// <summary>The error at each measured point; the mean if the point was measured several times.</summary>
    public required IReadOnlyList<ErrorSample> Samples { get; init; }

    /// <summary>The error at each point that the surface to cut has to correct: the measured one, or with a lot what is expected of the
    /// next piece without corrections.</summary>
    public required IReadOnlyList<ErrorSample> Expected { get; init; }

    /// <summary>What the pieces of the lot say about the next one; null for the first piece.</summary>
    public required Measurement.Lot? Lot { get; init; }

    /// <summary>The lot with this piece, and what the surface to cut corrects.</summary>
    public required Measurement.MeasuredLot Pieces { get; init; }

    /// <summary>Statistics of the measured errors.</summary>
    public required DeviationStatistics Before { get; init; }

    /// <summary>Whether the errors of neighboring points are alike.</summary>
    public required SpatialStructure Structure { get; init; }

    /// <summary>The systematic part of the errors: a field, or the mean if they have no structure.</summary>
    public required ErrorField Systematic { get; init; }

    /// <summary>The field that is compensated, before the gain.</summary>
    public required ErrorField Compensated { get; init; }

    /// <summary>The error that a modified tool radius compensates, before the gain: the mean, or zero if the errors have no structure
    /// and the mean is not significant.</summary>
    public required ConstantField Mean { get; init; }

    /// <summary>The surface to cut. It has the parameters and boundaries of the nominal one, or its own if fitted to the points.</summary>
    public required PartSurface Surface { get; init; }

    /// <summary>The surface through the compensation points; null if the error was fitted.</summary>
    public required FittedSurface? ThroughPoints { get; init; }

    /// <summary>Largest distance between <see cref="Surface"/> as written and the exact nominal surface displaced by the field, sampled
    /// densely. Zero if a surface was fitted to the points.</summary>
    public required double ApproximationMm { get; init; }

    /// <summary>Largest distance from the nominal surface, sampled densely and at the measured points.</summary>
    public required double LargestMoveMm { get; init; }

    /// <summary>The error that is expected to remain after mirroring.</summary>
    public required SurfacePrediction Mirror { get; init; }

    /// <summary>The error that is expected to remain after modifying the tool radius.</summary>
    public required SurfacePrediction ToolRadius { get; init; }

    /// <summary>Warnings, in sentences.</summary>
    public required IReadOnlyList<ReportWarning> Warnings { get; init; }

    /// <summary>Notes, in sentences.</summary>
    public required IReadOnlyList<string> Notes { get; init; }

    /// <summary>Returns the compensation point of a measured point: the ideal point moved by the compensated share of its own error
    /// (equations 1 and 2).</summary>
    public Geometry.Point3 PointOf(ErrorSample sample)
    {
        ArgumentNullException.ThrowIfNull(sample);
        var error = Input.Job.Compensation.Mirror && Systematic is not ConstantField ? sample.ErrorMm : Compensated.At(sample.U, sample.V);
        return MirrorEquations.Compensated(sample.Nominal, sample.Normal, error, Input.Job.Compensation.Gain);
    }

    /// <summary>Returns the displacement of the cut surface from the nominal surface at a measured point, in millimeters: the value of the
    /// field, or the vector to the surface fitted to the compensation points.</summary>
    /// <remarks>This differs from the vector to <see cref="PointOf"/>: a point's own error includes noise, which no fit follows.</remarks>
    public Geometry.Vector3 MoveAt(ErrorSample sample)
    {
        ArgumentNullException.ThrowIfNull(sample);
        return ThroughPoints is null
            ? sample.Normal * (-Input.Job.Compensation.Gain * Compensated.At(sample.U, sample.V))
            : -Surface.Spline.ClosestPoint(sample.Nominal).Offset;
    }

    /// <summary>Returns the signed distance of the cut surface from the nominal surface along the normal, in millimeters; positive leaves
    /// material. Beyond the edge of a surface fitted to points, the edge is used.</summary>
    internal double MovedMmAt(double u, double v)
    {
        if (ThroughPoints is null)
        {
            return -Input.Job.Compensation.Gain * Compensated.At(u, v);
        }

        // Project onto the cut surface and back. Beyond an edge, the direct vector would not be along the normal.
        var cut = Surface.Spline.ClosestPoint(Input.Surface.Spline.PointAt(u, v)).At.Position;
        return Input.Surface.Spline.ClosestPoint(cut, u, v).Height * Input.Surface.Outside;
    }

    /// <summary>The prediction for the selected compensation.</summary>
    public SurfacePrediction Predicted => Input.Job.Compensation.Mirror ? Mirror : ToolRadius;

    /// <summary>The verdict by the job's profile tolerance; null if the job states none.</summary>
    /// <param name="known">The map of this compensation, if the caller has it.</param>
    internal SurfaceVerdict? Verdict(ErrorMap? known = null)
    {
        if (Input.Job.Profile is not { } tolerance)
        {
            return null;
        }

        var map = known ?? ErrorMap.Of(this);
        var anywhere = Input.Job.Compensation.Mirror ? map.MirrorMm : map.ToolRadiusMm;
        return new(
            tolerance,
            ProfileJudgement.OfMeasured(tolerance, Samples, Input.Job.Measuring.UncertaintyMm),
            ProfileJudgement.OfPredicted(
                tolerance,
                Samples,
                Predicted.Errors,
                Predicted.Statistics.ProfileIsoMm,
                Predicted.PointUncertaintyMm,
                map.Net.Inside().Select(k => anywhere[k])));
    }
}
