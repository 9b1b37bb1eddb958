using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A feature in the report of a match.</summary>
public sealed record ReportFeature
{
    /// <summary>Its name.</summary>
    public required string Name { get; init; }

    /// <summary>Its kind.</summary>
    public required FeatureKind Kind { get; init; }

    /// <summary>The limits of its normal deviation, and their source.</summary>
    public required JobTolerance Tolerance { get; init; }

    /// <summary>Its lengths and angles.</summary>
    public required IReadOnlyList<ReportQuantity> Quantities { get; init; }

    /// <summary>The decision on it.</summary>
    public required Decision Decision { get; init; }

    /// <summary>The signed normal deviation with the largest magnitude among its points.</summary>
    public required double LargestMm { get; init; }

    /// <summary>Combined standard uncertainty of a normal deviation.</summary>
    public required double UncertaintyMm { get; init; }

    /// <summary>The limits up to which a deviation is accepted; null in reports older than decision rules.</summary>
    public ToleranceBand? Acceptance { get; init; }

    /// <summary>A deviation up to this size may be the gauge's; null in reports older than decision rules.</summary>
    public double? SignificantMm { get; init; }

    /// <summary>True if no point alone is significant, but what the points have in common is.</summary>
    public bool IsSignificantTogether { get; init; }

    /// <summary>The probability that every point is within its limits without compensation, if their errors are independent; null for
    /// limits without width, and in reports older than decision rules.</summary>
    public double? ProbabilityBefore { get; init; }

    /// <summary>The same probability with the program as written; null for limits without width, and in reports of earlier
    /// versions.</summary>
    public double? ProbabilityAfter { get; init; }

    /// <summary>Residuals of the fit to the measured points, in the order of the points.</summary>
    public IReadOnlyList<double> ResidualsMm { get; init; } = [];

    /// <summary>The fit of a curve; null for straight features and curves without a fit.</summary>
    public ReportCurve? Curve { get; init; }

    /// <summary>The boundary that the new program cuts as a polyline in the part's frame, for drawing. The document does not contain
    /// it.</summary>
    public IReadOnlyList<Point2> CorrectedOutline { get; init; } = [];

    /// <summary>The boundary that the original program cuts as a polyline in the part's frame, for drawing.</summary>
    public IReadOnlyList<Point2> TheoreticalOutline { get; init; } = [];

    /// <summary>The measured boundary as a polyline in the part's frame, for drawing.</summary>
    public IReadOnlyList<Point2> ActualOutline { get; init; } = [];

    /// <summary>Largest distance of its measured points from its plane, without sign; null if the files have no third
    /// coordinate.</summary>
    public double? StandsOutMm { get; init; }

    /// <summary>The largest mating error expected between its key points; null for kinds without a course, and in reports of earlier
    /// versions.</summary>
    public PredictedError? WorstBetween { get; init; }

    /// <summary>What was assumed about each of its elements before it was measured; empty for kinds without a course, and in reports of
    /// earlier versions.</summary>
    public IReadOnlyList<ElementPrior> Priors { get; init; } = [];

    /// <summary>The wanted gap between the pieces, along the normal; negative for a press fit.</summary>
    public double GapMm { get; init; }

    /// <summary>True if what the original program does differently from the theoretical outline is corrected; false if it stays.</summary>
    public bool CorrectsBase { get; init; }

    /// <summary>The largest difference of the original program from the theoretical outline at the key points, signed as an error: positive
    /// where too much material stands. Null in feedback, where it is part of what was measured, and in reports of earlier
    /// versions.</summary>
    public double? BaseMm { get; init; }

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("name", Name);
        w.Text("kind", Kind.Word);
        WriteQuantities("theoretical", q => q.Quantity.Theoretical);
        WriteQuantities("actual", q => q.Quantity.Actual);
        WriteQuantities("deviation", q => q.Quantity.Deviation);
        WriteQuantities("corrected", q => q.Corrected);
        WriteQuantities("uncertainty", q => q.Quantity.StandardUncertainty);
        w.Numbers("toleranceMm", [Tolerance.Band.LowerMm, Tolerance.Band.UpperMm]);
        w.Text("toleranceFrom", ReportWords.Of(Tolerance.Source));
        if (Acceptance is { } acceptance)
        {
            w.Numbers("acceptanceMm", [acceptance.LowerMm, acceptance.UpperMm]);
        }

        w.Number("gapMm", GapMm);
        w.Text("base", CorrectsBase ? "correct" : "keep");
        w.Number("baseMm", BaseMm);
        w.Number("largestMm", LargestMm);
        w.Number("uncertaintyMm", UncertaintyMm);
        w.Number("significantMm", SignificantMm);
        w.Flag("significantTogether", IsSignificantTogether);
        w.Number("probabilityBefore", ProbabilityBefore);
        w.Number("probabilityAfter", ProbabilityAfter);
        w.Text("decision", ReportWords.Of(Decision));
        w.Numbers("residualsMm", ResidualsMm);
        w.Optional("fit", Curve, c => c.Write(w));
        w.Number("standsOutMm", StandsOutMm);
        w.Optional("worstBetween", WorstBetween, e => e.Write(w));
        w.List("priors", Priors, p => p.Write(w));
        w.Object("outline", () =>
        {
            w.Points("theoretical", TheoreticalOutline);
            w.Points("actual", ActualOutline);
        });

        void WriteQuantities(string name, Func<ReportQuantity, double?> value) => w.Object(name, () =>
        {
            foreach (var quantity in Quantities)
            {
                w.Number(quantity.Quantity.Name, value(quantity));
            }
        });
    }

    /// <summary>Reads what <see cref="Write"/> writes, without what follows from it.</summary>
    internal static ReportFeature Read(ReportReader r)
    {
        var outline = r.Object("outline");
        return new()
        {
            Name = r.Text("name"),
            Kind = r.Word("kind", FeatureKinds.All, k => k.Word),
            Tolerance = new(ReadBand(r, "toleranceMm"), r.Word<ToleranceSource>("toleranceFrom", ReportWords.Of)),
            Quantities = ReadQuantities(r),
            Decision = r.Word<Decision>("decision", ReportWords.Of),
            GapMm = r.OptionalNumber("gapMm") ?? 0,
            CorrectsBase = r.OptionalText("base") == "correct",
            BaseMm = r.OptionalNumber("baseMm"),
            LargestMm = r.Number("largestMm"),
            UncertaintyMm = r.Number("uncertaintyMm"),
            Acceptance = r.Names.Contains("acceptanceMm") ? ReadBand(r, "acceptanceMm") : null,
            SignificantMm = r.OptionalNumber("significantMm"),
            IsSignificantTogether = r.OptionalFlag("significantTogether") ?? false,
            ProbabilityBefore = r.OptionalNumber("probabilityBefore"),
            ProbabilityAfter = r.OptionalNumber("probabilityAfter"),
            ResidualsMm = r.Numbers("residualsMm"),
            Curve = r.OptionalObject("fit") is { } curve ? ReportCurve.Read(curve) : null,
            TheoreticalOutline = outline.Points("theoretical"),
            ActualOutline = outline.Points("actual"),
            StandsOutMm = r.OptionalNumber("standsOutMm"),
            Priors = r.OptionalList("priors", ElementPrior.Read),
            WorstBetween = r.OptionalObject("worstBetween") is { } worst ? PredictedError.Read(worst) : null,
        };
    }

    /// <summary>Reads limits.</summary>
    internal static ToleranceBand ReadBand(ReportReader r, string name = "toleranceMm")
    {
        var limits = r.Numbers(name, 2);
        return limits[0] <= limits[1]
            ? new(limits[0], limits[1])
            : throw r.Refusal(name, "reversed-tolerance", "the lower limit first");
    }

    private static ReportQuantity[] ReadQuantities(ReportReader r)
    {
        var (theoretical, actual, uncertainty, corrected) = (
            r.Object("theoretical"), r.Object("actual"), r.Object("uncertainty"), r.Object("corrected"));
        return [
            .. theoretical.Names.Select(n => new ReportQuantity(
                new(n, theoretical.Number(n), actual.Number(n), uncertainty.Number(n)), corrected.OptionalNumber(n)))];
    }
}
