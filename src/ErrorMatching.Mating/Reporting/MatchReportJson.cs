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
            w.Job("mating", report.Job);
            w.Inputs(report.Inputs);
            w.Object("alignment", () => WriteAlignments(w, report.Alignments));
            w.Optional("originCheck", report.OriginCheck, c => WriteOriginCheck(w, c));
            w.Object("compensation", () => WriteCompensation(w, report.Compensation));
            w.Object("uncertainty", () => WriteUncertainty(w, report.Uncertainty));
            w.Optional("toleranceChain", report.Chain, c => WriteChain(w, c));
            w.List("features", report.Features, f => WriteFeature(w, f));
            w.List("keyPoints", report.KeyPoints, p => WriteKeyPoint(w, p));
            w.Object("outsideLimits", () =>
            {
                w.Texts("drivenOut", report.Outside.DrivenOut);
                w.Texts("staying", report.Outside.Staying);
            });
            w.Object("program", () => WriteProgram(w, report.Program));
            w.Object("proof", () => WriteProof(w, report.Proof));
            w.Object("time", () =>
            {
                w.Number("measuringS", report.Time.MeasuringS);
                w.Number("calculatingS", report.Time.CalculatingS);
            });
            w.Number("radiusWearMm", report.RadiusWearMm);
            w.Texts("warnings", report.Warnings.Select(n => n.Message));
            w.List("warningCodes", report.Warnings, n =>
            {
                w.Text("code", n.Code);
                w.Texts("values", n.Values);
            });
            w.Texts("notes", report.Notes);
        });
    }

    /// <summary>The part's alignment is at the top level; the others, aligned in the same way, follow.</summary>
    private static void WriteAlignments(ReportWriter w, IReadOnlyList<ReportAlignment> alignments)
    {
        if (alignments.Count > 0)
        {
            WriteAlignment(w, alignments[0]);
        }

        w.List("others", alignments.Skip(1), a => WriteAlignment(w, a));
    }

    private static void WriteAlignment(ReportWriter w, ReportAlignment a)
    {
        w.Text("of", a.Role);
        w.Text("kind", ReportWords.Of(a.Kind));
        w.Object("transform", () =>
        {
            w.Text("mirror", ReportWords.Of(a.Transform.Mirror));
            w.Number("rotateDeg", a.Transform.Rotation.Degrees);
            w.Numbers("translateMm", [a.Transform.Translation.X, a.Transform.Translation.Y]);
        });
        w.Number("rmsMm", a.RmsMm);
        w.Number("maxMm", a.MaxMm);
        w.List("residuals", a.Residuals, r =>
        {
            w.Text("point", r.Point);
            w.Vector(r.Left);
        });
    }

    private static void WriteOriginCheck(ReportWriter w, OriginCheck check)
    {
        w.Text("point", check.Point);
        w.Number("distanceMm", check.DistanceMm);
        w.Number("limitMm", check.LimitMm);
        w.Flag("holds", check.Holds);
    }

    private static void WriteCompensation(ReportWriter w, JobCompensation compensation)
    {
        w.Text("from", ReportWords.Of(compensation.From));
        w.Number("gain", compensation.Gain);
        w.Text("amount", ReportWords.Of(compensation.Amount));
        w.Text("along", ReportWords.Of(compensation.Along));
        w.Number("limitMm", compensation.LimitMm);
    }

    private static void WriteUncertainty(ReportWriter w, UncertaintyBudget budget)
    {
        w.Number("combinedMm", budget.CombinedMm);
        w.List("contributions", budget.Contributions, c =>
        {
            w.Text("name", c.Name);
            w.Number("valueMm", c.ValueMm);
        });
    }

    private static void WriteChain(ReportWriter w, ToleranceChain chain)
    {
        w.Number("nominalMm", chain.NominalMm);
        w.Object("worstCase", () => WriteDimension(w, chain.WorstCase()));
        w.Object("rootSumOfSquares", () => WriteDimension(w, chain.RootSumOfSquares()));
    }

    private static void WriteDimension(ReportWriter w, ChainDimension dimension)
    {
        w.Number("smallestMm", dimension.SmallestMm);
        w.Number("largestMm", dimension.LargestMm);
    }

    private static void WriteFeature(ReportWriter w, ReportFeature f)
    {
        w.Text("name", f.Name);
        w.Text("kind", f.Kind.Word);
        Quantities("theoretical", q => q.Quantity.Theoretical);
        Quantities("actual", q => q.Quantity.Actual);
        Quantities("deviation", q => q.Quantity.Deviation);
        Quantities("corrected", q => q.Corrected);
        Quantities("uncertainty", q => q.Quantity.StandardUncertainty);
        w.Numbers("toleranceMm", [f.Tolerance.Band.LowerMm, f.Tolerance.Band.UpperMm]);
        w.Text("toleranceFrom", ReportWords.Of(f.Tolerance.Source));
        w.Number("largestMm", f.LargestMm);
        w.Number("uncertaintyMm", f.UncertaintyMm);
        w.Text("decision", ReportWords.Of(f.Decision));
        w.Numbers("residualsMm", f.ResidualsMm);
        w.Optional("fit", f.Curve, c =>
        {
            w.Count("degree", c.Degree);
            w.Exact("ridge", c.Ridge);
            w.Number("leaveOneOutMm", c.LeaveOneOutMm);
            w.Number("residualStandardDeviationMm", c.ResidualStandardDeviationMm);
        });
        w.Number("standsOutMm", f.StandsOutMm);
        w.Object("outline", () =>
        {
            w.Points("theoretical", f.TheoreticalOutline);
            w.Points("actual", f.ActualOutline);
        });

        void Quantities(string name, Func<ReportQuantity, double?> value) => w.Object(name, () =>
        {
            foreach (var quantity in f.Quantities)
            {
                w.Number(quantity.Quantity.Name, value(quantity));
            }
        });
    }

    private static void WriteKeyPoint(ReportWriter w, ReportKeyPoint p)
    {
        w.Text("point", p.Point);
        w.Text("feature", p.Feature);
        w.Point("theoretical", p.Theoretical);
        w.Point("actual", p.Actual);
        if (p.Counterpart is { } counterpart)
        {
            w.Point("counterpart", counterpart);
        }

        w.Vector("deviation", p.Deviation);
        w.Vector("correction", p.Correction);
        w.Vector("normal", p.Normal);
        w.Number("normalMm", p.NormalMm);
        w.Number("decidedMm", p.DecidedMm);
        w.Number("excessMm", p.ExcessMm);
        w.Number("predictedMm", p.PredictedMm);
        w.Texts("blocks", p.Blocks);
    }

    private static void WriteProgram(ReportWriter w, ReportProgram program)
    {
        w.Text("file", program.File);
        w.Text("sha256", program.Sha256);
        w.Count("changedBlocks", program.ChangedBlocks);
        w.Count("changedWords", program.ChangedWords);
        w.List("blocks", program.Blocks, b =>
        {
            w.Text("number", b.Number);
            w.Count("line", b.Line);
            w.Text("original", b.Original);
            w.Text("modified", b.Modified);
            Spans("originalSpans", b.OriginalSpans);
            Spans("modifiedSpans", b.ModifiedSpans);
        });

        void Spans(string name, IReadOnlyList<TextSpan> spans) => w.List(name, spans, s =>
        {
            w.Count("start", s.Start);
            w.Count("length", s.Length);
        });
    }

    private static void WriteProof(ReportWriter w, ReportProof proof)
    {
        w.Flag("holds", proof.Holds);
        w.Count("motions", proof.Motions);
        w.Count("movedMotions", proof.MovedMotions);
        w.Texts("neighbors", proof.Neighbors.Select(n => n.Block));
        w.List("neighborRoles", proof.Neighbors, n =>
        {
            w.Text("block", n.Block);
            w.Count("line", n.Line);
            w.Text("role", ReportWords.Of(n.Role));
            w.Number("displacementMm", n.DisplacementMm);
        });
        w.Text("marker", proof.Marker);
        w.Number("maxDeviationFromWantedMm", proof.MaxDeviationFromWantedMm);
        w.Flag("untouchedBytesIdentical", proof.UntouchedBytesIdentical);
    }
}
