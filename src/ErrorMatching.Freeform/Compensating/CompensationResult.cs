namespace ErrorMatching.Freeform;

/// <summary>A compensated surface, what it was made of, and what is expected of it. Lengths in millimetres.</summary>
public sealed record CompensationResult
{
    internal CompensationResult()
    {
    }

    /// <summary>What it was made of.</summary>
    public required CompensationInput Input { get; init; }

    /// <summary>How the points were laid onto the surface; null if they stayed where they were measured.</summary>
    public required SurfaceAlignment? Alignment { get; init; }

    /// <summary>The error at each measured point, of several measurements their mean.</summary>
    public required IReadOnlyList<ErrorSample> Samples { get; init; }

    /// <summary>What the errors come to.</summary>
    public required DeviationStatistics Before { get; init; }

    /// <summary>Whether errors of neighbors are alike.</summary>
    public required SpatialStructure Structure { get; init; }

    /// <summary>What is systematic in the errors: a field, or their mean where neighbors are not alike.</summary>
    public required ErrorField Systematic { get; init; }

    /// <summary>The field that is compensated, before the gain.</summary>
    public required ErrorField Compensated { get; init; }

    /// <summary>What a modified tool radius compensates, before the gain: the mean error, or nothing where neighbors are not alike and it is not significant.</summary>
    public required ConstantField Mean { get; init; }

    /// <summary>The surface to cut, with the parametrization and the limits of the nominal one (or that of the points, where a surface was fitted to them).</summary>
    public required PartSurface Surface { get; init; }

    /// <summary>The surface through the compensation points; null where the error was fitted.</summary>
    public required FittedSurface? ThroughPoints { get; init; }

    /// <summary>Largest distance between <see cref="Surface"/> as written and the exact nominal surface moved by the field, measured densely; zero where a surface was fitted to points.</summary>
    public required double ApproximationMm { get; init; }

    /// <summary>Largest distance of the surface from the nominal one, measured densely and at the measured points.</summary>
    public required double LargestMoveMm { get; init; }

    /// <summary>What mirroring is expected to leave.</summary>
    public required SurfacePrediction Mirror { get; init; }

    /// <summary>What a modified tool radius is expected to leave.</summary>
    public required SurfacePrediction ToolRadius { get; init; }

    /// <summary>Sentences that a person must not overlook.</summary>
    public required IReadOnlyList<string> Warnings { get; init; }

    /// <summary>Sentences that a person may want to read.</summary>
    public required IReadOnlyList<string> Notes { get; init; }

    /// <summary>The compensation point of a measured one: the ideal point moved by the compensated share of its own error (equations 1 and 2).</summary>
    public Geometry.Point3 PointOf(ErrorSample sample)
    {
        ArgumentNullException.ThrowIfNull(sample);
        var error = Input.Job.Compensation.Mirror && Systematic is not ConstantField ? sample.ErrorMm : Compensated.At(sample.U, sample.V);
        return MirrorEquations.Compensated(sample.Nominal, sample.Normal, error, Input.Job.Compensation.Gain);
    }

    /// <summary>By how much the surface that is cut lies away from the nominal one at a measured point, in millimetres: what the field says there, or the way to the surface that was fitted to the compensation points.</summary>
    /// <remarks>That is not the way to <see cref="PointOf"/>: a point's own error has its noise, which no fit follows.</remarks>
    public Geometry.Vector3 MoveAt(ErrorSample sample)
    {
        ArgumentNullException.ThrowIfNull(sample);
        return ThroughPoints is null
            ? sample.Normal * (-Input.Job.Compensation.Gain * Compensated.At(sample.U, sample.V))
            : -Surface.Spline.ClosestPoint(sample.Nominal).Offset;
    }

    /// <summary>By how much the surface that is cut lies out of the nominal one at a place of it, along the normal, in millimetres: positive leaves material. Beyond the edge of a surface that was fitted to points its edge counts.</summary>
    internal double MovedMmAt(double u, double v)
    {
        if (ThroughPoints is null)
        {
            return -Input.Job.Compensation.Gain * Compensated.At(u, v);
        }

        // From the nominal surface to the cut one and back: beyond an edge the way there would not be along the normal.
        var cut = Surface.Spline.ClosestPoint(Input.Surface.Spline.PointAt(u, v)).At.Position;
        return Input.Surface.Spline.ClosestPoint(cut, u, v).Height * Input.Surface.Outside;
    }

    /// <summary>The prediction for the compensation that was made.</summary>
    public SurfacePrediction Predicted => Input.Job.Compensation.Mirror ? Mirror : ToolRadius;
}
