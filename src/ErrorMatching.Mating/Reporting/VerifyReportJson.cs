using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The report of a verification as JSON, schema <c>errormatch/verify/1</c>.</summary>
/// <remarks>Lengths are in millimeters, angles in degrees, numbers rounded to the ninth decimal. UTF-8 without a byte order mark, lines
/// end with a line feed.</remarks>
public static class VerifyReportJson
{
    /// <summary>Name of the schema.</summary>
    public const string Schema = "errormatch/verify/1";

    /// <summary>The report as a document.</summary>
    public static byte[] Write(VerifyReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportWriter.Document(Schema, w =>
        {
            w.Object("verdict", () => report.Verdict.Write(w));
            w.Optional("pair", report.Pair, p => p.Write(w));
            w.Job("mating", report.Job);
            w.Inputs(report.Inputs);
            RuleWords.Write(w, report.Rule);
            w.Number("uncertaintyMm", report.UncertaintyMm);
            w.List("points", report.Result.Points, p => WritePoint(w, p));
            w.List("features", report.Result.Features, f => WriteFeature(w, f));
            w.Flag("beforeMeasured", report.IsBeforeMeasured);
            w.Number("maxBeforeMm", report.Result.MaxBeforeMm);
            w.Number("maxAfterMm", report.Result.MaxAfterMm);
            w.Number("rmsBeforeMm", report.Result.RmsBeforeMm);
            w.Number("rmsAfterMm", report.Result.RmsAfterMm);
            w.List("boundaries", report.Result.Boundaries, b => WriteBoundary(w, b));
            w.Texts("warnings", report.Warnings);
        });
    }

    /// <summary>Reads a document. In older reports, the features have no points.</summary>
    /// <param name="document">The document, of this schema.</param>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static VerifyReport Read(ReportReader document)
    {
        ArgumentNullException.ThrowIfNull(document);
        var points = ReadPoints(document);
        var free = points.Select(p => p.Label).ToHashSet(StringComparer.Ordinal);
        return new(
            document.Job(),
            document.Inputs(),
            new(points, document.List("features", ReadFeature))
            {
                Boundaries = document.List("boundaries", b => ReadBoundary(b, free)),
            },
            document.Texts("warnings"))
        {
            IsBeforeMeasured = document.Flag("beforeMeasured"),
            UncertaintyMm = document.OptionalNumber("uncertaintyMm"),
            Pair = document.OptionalObject("pair") is { } pair ? PairAssembly.Read(pair) : null,
            Rule = RuleWords.Read(document),
        };
    }

    private static void WritePoint(ReportWriter w, VerifiedPoint point)
    {
        w.Text("point", point.Label);
        w.Point("part", point.Part);
        w.Vector("normal", point.Normal);
        w.Object("before", () => WriteError(w, point.BeforeError));
        w.Object("after", () => WriteError(w, point.AfterError));
    }

    private static IReadOnlyList<VerifiedPoint> ReadPoints(ReportReader document)
    {
        var labels = new HashSet<string>(StringComparer.Ordinal);
        var points = document.List("points", r => labels.Add(r.Text("point"))
            ? ReadPoint(r)
            : throw r.Refusal("point", "duplicate-name", "each point once"));
        return points.Count > 0 ? points : throw document.Refusal("points", "too-few-items", "at least one point");
    }

    private static VerifiedPoint ReadPoint(ReportReader r)
    {
        var part = r.Point("part");
        return new(r.Text("point"), part, part + ReadError(r.Object("before")), part + ReadError(r.Object("after")), r.Vector("normal"));
    }

    private static void WriteError(ReportWriter w, MatingError error)
    {
        w.Number("dx", error.Vector.X);
        w.Number("dy", error.Vector.Y);
        w.Number("normalMm", error.NormalMm);
    }

    private static Vector2 ReadError(ReportReader r) => new(r.Number("dx"), r.Number("dy"));

    private static void WriteFeature(ReportWriter w, VerifiedFeature feature)
    {
        w.Text("name", feature.Name);
        w.Text("quantity", feature.Quantity.Word);
        w.Number("wanted", feature.Wanted);
        w.Number("before", feature.Before);
        w.Number("after", feature.After);
        w.Number("improvementPercent", feature.ImprovementPercent);
        w.Number("changeUncertainty", feature.ChangeUncertainty);
        w.Texts("points", feature.Points);
    }

    private static VerifiedFeature ReadFeature(ReportReader r) => new(
        r.Text("name"),
        r.Word("quantity", VerifiedQuantity.All, q => q.Word),
        r.Number("wanted"),
        r.Number("before"),
        r.Number("after"))
    {
        Points = r.OptionalTexts("points"),
        ChangeUncertainty = r.OptionalNumber("changeUncertainty"),
    };

    private static void WriteBoundary(ReportWriter w, VerifiedBoundary boundary)
    {
        w.Text("name", boundary.Name);
        w.Numbers("toleranceMm", [boundary.Band.LowerMm, boundary.Band.UpperMm]);
        w.List("points", boundary.Points, p =>
        {
            w.Text("point", p.Label);
            w.Point("theoretical", p.Theoretical);
        });
        w.Points("outline", boundary.Outline);
    }

    // A boundary has points of the report, and each of them has at most one boundary.
    private static VerifiedBoundary ReadBoundary(ReportReader r, HashSet<string> free) => new(
        r.Text("name"),
        ReportFeature.ReadBand(r),
        r.List("points", p => free.Remove(p.Text("point"))
            ? (p.Text("point"), p.Point("theoretical"))
            : throw p.Refusal("point", "not-one-of", "a point of the report that no other boundary has")),
        r.Points("outline"));
}
