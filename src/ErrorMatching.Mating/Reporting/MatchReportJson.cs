using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The report of a match as JSON, schema <c>errormatch/match/1</c>.</summary>
/// <remarks>Lengths are in millimeters, angles in degrees, numbers rounded to the ninth decimal. UTF-8 without a byte order mark, lines
/// end with a line feed.</remarks>
public static class MatchReportJson
{
    /// <summary>Name of the schema.</summary>
    public const string Schema = "errormatch/match/1";

    /// <summary>The report as a document.</summary>
    public static byte[] Write(MatchReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportWriter.Document(Schema, w =>
        {
            w.Object("verdict", () => report.Verdict.Write(w));
            report.Acceptance.Write(w);
            w.Job("mating", report.Job);
            w.Inputs(report.Inputs);
            w.Object("alignment", () => WriteAlignments(w, report.Alignments));
            w.Optional("originCheck", report.OriginCheck, c => WriteOriginCheck(w, c));
            w.Texts("without", report.Without);
            w.Object("compensation", () => WriteCompensation(w, report.Compensation));
            RuleWords.Write(w, report.Rule);
            w.Number("probabilityBefore", report.ProbabilityBefore);
            w.Number("probabilityAfter", report.ProbabilityAfter);
            w.Object("uncertainty", () => WriteUncertainty(w, report.Uncertainty));
            w.Optional("toleranceChain", report.Chain, c => c.Write(w));
            w.List("features", report.Features, f => f.Write(w));
            w.List("keyPoints", report.KeyPoints, p => p.Write(w));
            w.Object("outsideLimits", () =>
            {
                w.Texts("drivenOut", report.Outside.DrivenOut);
                w.Texts("staying", report.Outside.Staying);
            });
            w.Optional("pair", report.Pair, p => p.Write(w));
            w.Object("program", () => report.Program.Write(w));
            w.Object("proof", () => report.Proof.Write(w));
            w.Object("time", () => report.Time.Write(w));
            w.Number("radiusWearMm", report.RadiusWearMm);
            w.Optional("correction", report.Correction, c => c.Write(w));
            w.Optional("lot", report.Lot, l => LotJson.Write(w, l.Pieces, l.Next));
            w.Warnings(report.Warnings);
            w.Texts("notes", report.Notes);
        });
    }

    /// <summary>Reads a document. Reports older than the codes of warnings, the roles of neighbors and the decision rules are read
    /// without them.</summary>
    /// <param name="document">The document, of this schema.</param>
    /// <returns>The report, without what the document does not contain: the links of the chain and the corrected outlines.</returns>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static MatchReport Read(ReportReader document)
    {
        ArgumentNullException.ThrowIfNull(document);
        var features = ReadFeatures(document);
        var (pieces, next) = LotJson.Read(document);
        return new()
        {
            Acceptance = Acceptance.Read(document),
            Job = document.Job(),
            Inputs = document.Inputs(),
            Alignments = ReadAlignments(document.Object("alignment")),
            OriginCheck = document.OptionalObject("originCheck") is { } check ? ReadOriginCheck(check) : null,
            Compensation = ReadCompensation(document.Object("compensation")),
            Rule = RuleWords.Read(document),
            ProbabilityBefore = document.OptionalNumber("probabilityBefore"),
            ProbabilityAfter = document.OptionalNumber("probabilityAfter"),
            Trust = document.OptionalObject("verdict") is { } verdict ? MeasurementTrust.Read(verdict) : null,
            Without = document.OptionalTexts("without"),
            Uncertainty = ReadUncertainty(document.Object("uncertainty")),
            Chain = document.OptionalObject("toleranceChain") is { } chain ? ReportChain.Read(chain) : null,
            Features = features,
            KeyPoints = ReadKeyPoints(document, [.. features.Select(f => f.Name)]),
            Pair = document.OptionalObject("pair") is { } pair ? PairAssembly.Read(pair) : null,
            Program = ReportProgram.Read(document.Object("program")),
            Proof = ReportProof.Read(document.Object("proof")),
            Time = ReportTime.Read(document.Object("time")),
            RadiusWearMm = document.OptionalNumber("radiusWearMm"),
            Correction = document.OptionalObject("correction") is { } correction ? ReportCorrection.Read(correction) : null,
            Lot = pieces is null ? null : new(pieces, next),
            Warnings = document.Warnings(),
            Notes = document.Texts("notes"),
        };
    }

    /// <summary>The corrections by offsets with which the program of a document is cut; null if its job allowed none.</summary>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static OffsetTotals? OffsetsOf(ReportReader document)
    {
        ArgumentNullException.ThrowIfNull(document);
        return document.OptionalObject("correction") is { } correction ? ReportCorrection.Read(correction).Totals : null;
    }

    private static IReadOnlyList<ReportFeature> ReadFeatures(ReportReader document)
    {
        var names = new HashSet<string>(StringComparer.Ordinal);
        return document.List("features", r => names.Add(r.Text("name"))
            ? ReportFeature.Read(r)
            : throw r.Refusal("name", "duplicate-name", "each feature once"));
    }

    private static IReadOnlyList<ReportKeyPoint> ReadKeyPoints(ReportReader document, IReadOnlyList<string> features)
    {
        var labels = new HashSet<string>(StringComparer.Ordinal);
        var points = document.List("keyPoints", r =>
        {
            _ = r.Word("feature", features, f => f);
            return labels.Add(r.Text("point")) ? ReportKeyPoint.Read(r) : throw r.Refusal("point", "duplicate-name", "each point once");
        });
        return features.FirstOrDefault(f => points.All(p => p.Feature != f)) is { } without
            ? throw document.Refusal("keyPoints", "too-few-items", $"at least one point of {without}")
            : points;
    }

    // The part's alignment is at the top level; the others, aligned in the same way, follow.
    private static void WriteAlignments(ReportWriter w, IReadOnlyList<ReportAlignment> alignments)
    {
        if (alignments.Count > 0)
        {
            alignments[0].Write(w);
        }

        w.List("others", alignments.Skip(1), a => a.Write(w));
    }

    private static ReportAlignment[] ReadAlignments(ReportReader r) =>
        [.. r.Names.Contains("of") ? [ReportAlignment.Read(r)] : Array.Empty<ReportAlignment>(), .. r.List("others", ReportAlignment.Read)];

    private static void WriteOriginCheck(ReportWriter w, OriginCheck check)
    {
        w.Text("point", check.Point);
        w.Number("distanceMm", check.DistanceMm);
        w.Number("limitMm", check.LimitMm);
        w.Flag("holds", check.Holds);
    }

    private static OriginCheck ReadOriginCheck(ReportReader r) => new(r.Text("point"), r.Number("distanceMm"), r.Number("limitMm"));

    private static void WriteCompensation(ReportWriter w, JobCompensation compensation)
    {
        w.Text("from", ReportWords.Of(compensation.From));
        w.Number("gain", compensation.Gain);
        w.Text("amount", ReportWords.Of(compensation.Amount));
        w.Text("along", ReportWords.Of(compensation.Along));
        w.Number("limitMm", compensation.LimitMm);
    }

    private static JobCompensation ReadCompensation(ReportReader r) => new(
        r.Word<CompensationSource>("from", ReportWords.Of),
        r.Number("gain"),
        r.Word<CompensationAmount>("amount", ReportWords.Of),
        r.Word<CompensationDirection>("along", ReportWords.Of),
        r.Number("limitMm"));

    private static void WriteUncertainty(ReportWriter w, UncertaintyBudget budget)
    {
        w.Number("combinedMm", budget.CombinedMm);
        w.List("contributions", budget.Contributions, c =>
        {
            w.Text("name", c.Name);
            w.Number("valueMm", c.ValueMm);
        });
    }

    private static UncertaintyBudget ReadUncertainty(ReportReader r) =>
        new(r.List("contributions", c => new UncertaintyContribution(c.Text("name"), c.Number("valueMm"))));
}
