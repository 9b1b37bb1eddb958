namespace ErrorMatching.Mating;

/// <summary>One quantity of the counterpart, before and after.</summary>
/// <param name="Name">Name of the feature or of the job's comparison.</param>
/// <param name="Quantity">The compared quantity.</param>
/// <param name="Wanted">The part's value; zero for deviations.</param>
/// <param name="Before">The value of the counterpart cut without compensation.</param>
/// <param name="After">The value of the counterpart cut with compensation.</param>
public sealed record VerifiedFeature(string Name, VerifiedQuantity Quantity, double Wanted, double Before, double After)
{
    /// <summary>Labels of the key points for a largest deviation; empty for lengths and angles.</summary>
    public IReadOnlyList<string> Points { get; init; } = [];

    /// <summary>Standard uncertainty of the change from before to after, from the gauge's uncertainty; null if it is not known, as in
    /// reports of earlier versions.</summary>
    public double? ChangeUncertainty { get; init; }

    /// <summary>True if the error changed by less than the expanded uncertainty of the change: the gauge cannot tell whether it
    /// did.</summary>
    public bool IsChangeUncertain => IsWithinUncertainty(Math.Abs(After - Wanted) - Math.Abs(Before - Wanted));

    /// <summary>True if the error before was less than that uncertainty: a change in percent of it would say nothing.</summary>
    public bool IsBeforeUncertain => IsWithinUncertainty(Before - Wanted);

    /// <summary>Reduction of the error, in percent of the error before; negative if it grew, null if it was zero.</summary>
    public double? ImprovementPercent
    {
        get
        {
            var before = Math.Abs(Before - Wanted);
            return before > 0 ? 100 * (before - Math.Abs(After - Wanted)) / before : null;
        }
    }

    /// <summary>The largest deviations of some points along their normals, without sign.</summary>
    /// <param name="name">Name of the feature.</param>
    /// <param name="points">Its points, at least one.</param>
    public static VerifiedFeature DeviationOf(string name, IReadOnlyList<VerifiedPoint> points) =>
        new(
            name,
            VerifiedQuantity.Deviation,
            0,
            points.Max(p => Math.Abs(p.BeforeError.NormalMm)),
            points.Max(p => Math.Abs(p.AfterError.NormalMm)))
        {
            Points = [.. points.Select(p => p.Label)]
        };

    private bool IsWithinUncertainty(double difference) =>
        ChangeUncertainty is { } u && Math.Abs(difference) < UncertaintyBudget.CoverageFactor * u;
}
