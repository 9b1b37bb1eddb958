using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The mating error that a program will leave: counterpart minus part, positive where too much material stands.</summary>
/// <param name="Features">The features in the order of the job.</param>
public sealed record MatingPrediction(IReadOnlyList<FeaturePrediction> Features);

/// <summary>The predicted mating error of a feature.</summary>
/// <param name="Points">Its key points in the order of the job: measured exactly against all cuts of the program around them.</param>
/// <param name="WorstBetween">The largest error that is expected between them; if nothing is known there, the place where one more point
/// would tell most. Null for an element with a single point.</param>
/// <param name="Priors">What was assumed about each of its elements before it was measured; empty for kinds without a course.</param>
public sealed record FeaturePrediction(
    IReadOnlyList<PredictedError> Points, PredictedError? WorstBetween, IReadOnlyList<ElementPrior> Priors)
{
    /// <summary>The measured deviation at a length along the boundary, toward the tool, mm; null for kinds without a course.</summary>
    internal Func<double, double>? Deviation { get; init; }
}

/// <summary>The predicted mating error at a place of the boundary, mm.</summary>
/// <param name="Place">Where the boundary is as designed, in the part's frame.</param>
/// <param name="Normal">Unit normal there, from the counterpart's material to its tool, in the part's frame.</param>
/// <param name="BeforeMm">The error that the original program leaves.</param>
/// <param name="AfterMm">The error that the program to cut leaves.</param>
/// <param name="StandardUncertaintyMm">Standard uncertainty of both.</param>
public sealed record PredictedError(Point2 Place, Vector2 Normal, double BeforeMm, double AfterMm, double StandardUncertaintyMm)
{
    /// <summary>Ratio of half a 95 % interval to the standard uncertainty of a normal distribution.</summary>
    public const double Factor95 = 1.96;

    /// <summary>The part of it that the original program brings along, because it cuts elsewhere than the theoretical outline is; 0 in
    /// feedback, where the measured counterpart has it. Not in a report's place between points.</summary>
    public double BaseMm { get; init; }

    /// <summary>False if the points say nothing of the form of the boundary there, and the job states none: then the errors are those of a
    /// perfect shape, and their uncertainty is not known.</summary>
    public bool IsKnown { get; init; } = true;

    /// <summary>Half the 95 % interval about either error. Of the worst place between points, one that holds the errors at all other
    /// places, too.</summary>
    public double Interval95Mm
    {
        get => _widened ?? (Factor95 * StandardUncertaintyMm);
        init => _widened = value;
    }

    private readonly double? _widened;

    /// <summary>The largest error, either way, of the interval about <see cref="AfterMm"/>.</summary>
    public double BoundMm => Math.Abs(AfterMm) + Interval95Mm;

    /// <summary>The worst of several places between points. One of which nothing is known comes first. Then the largest error outside the
    /// limits, because it decides; else the largest bound, because the error there may be the largest.</summary>
    /// <param name="places">The places.</param>
    /// <param name="limits">The limits of the mating error; null for none.</param>
    /// <returns>Null if there is no place.</returns>
    internal static PredictedError? Worst(IEnumerable<PredictedError> places, ToleranceBand? limits) => places
        .OrderBy(p => p.IsKnown)
        .ThenByDescending(p => limits?.Contains(p.AfterMm) == false ? Math.Abs(p.AfterMm) : 0)
        .ThenByDescending(p => p.IsKnown ? p.BoundMm : Math.Abs(p.AfterMm))
        .FirstOrDefault();

    /// <summary>The same error with an interval that reaches a bound, if it does not reach further already.</summary>
    internal PredictedError Within(double boundMm) => boundMm <= BoundMm ? this
        : this with { Interval95Mm = boundMm - Math.Abs(AfterMm) };

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Point("place", Place);
        w.Vector("normal", Normal);
        w.Number("uncompensatedMm", BeforeMm);
        w.Number("predictedMm", AfterMm);
        w.Flag("known", IsKnown);
        w.Number("uncertaintyMm", IsKnown ? StandardUncertaintyMm : null);
        w.Number("interval95Mm", IsKnown ? Interval95Mm : null);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static PredictedError Read(ReportReader r)
    {
        var error = new PredictedError(
            r.Point("place"),
            r.Vector("normal"),
            r.Number("uncompensatedMm"),
            r.Number("predictedMm"),
            r.OptionalNumber("uncertaintyMm") ?? 0)
        {
            IsKnown = r.OptionalFlag("known") ?? true,
        };
        return r.OptionalNumber("interval95Mm") is { } interval ? error with { Interval95Mm = interval } : error;
    }
}

/// <summary>What was assumed about the deviation of an element before it was measured, chosen by the evidence of the key points.</summary>
/// <param name="TiltMm">Standard deviation of its tilt at both ends, and of the change of an arc, mm; null for a curve, whose linear mean
/// is vague.</param>
/// <param name="FormMm">Standard deviation of its form error, mm.</param>
/// <param name="LengthMm">Length over which its form error is correlated, mm; null without a form error.</param>
public sealed record ElementPrior(double? TiltMm, double FormMm, double? LengthMm)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Number("tiltMm", TiltMm);
        w.Number("formMm", FormMm);
        w.Number("lengthMm", LengthMm);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ElementPrior Read(ReportReader r) => new(r.OptionalNumber("tiltMm"), r.Number("formMm"), r.OptionalNumber("lengthMm"));
}
