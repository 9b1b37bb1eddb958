using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>By what a correction is made, and the program of the offsets, if the job allows offsets.</summary>
/// <param name="Choice">The choice; read from a document without the program's bytes.</param>
/// <param name="File">Path of the program of the offsets, which may not be written yet; null if there is none.</param>
/// <param name="Sha256">SHA-256 of that program; null if there is none.</param>
public sealed record ReportCorrection(CorrectionChoice Choice, string? File, string? Sha256)
{
    /// <summary>The block by which another program calls that program; null if the dialect states none, or if its file has a name that
    /// the control does not find.</summary>
    public string? Call { get; init; }

    /// <summary>The corrections by offsets in all, for the next match.</summary>
    public OffsetTotals Totals => new(Choice.Radius?.TotalMm ?? 0, Choice.Work?.Total ?? default);

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("kind", Choice.Kind is { } kind ? ReportWords.Of(kind) : null);
        w.Optional("radius", Choice.Radius, r =>
        {
            w.Count("number", r.Number);
            w.Count("tool", r.Tool);
            w.Number("totalMm", (double)r.TotalMm);
            w.Number("beforeMm", (double?)r.BeforeMm);
        });
        w.Optional("workOffset", Choice.Work, o =>
        {
            w.Count("number", o.Number);
            w.Object("total", () => Write(w, o.Total));
            if (o.Before is { } before)
            {
                w.Object("before", () => Write(w, before));
            }
        });
        w.Number("differenceMm", Choice.DifferenceMm);
        w.Optional("expected", Choice.Expected, e => Write(w, e));
        w.Optional("expectedByBlocks", Choice.ExpectedByBlocks, e => Write(w, e));
        w.List("refused", Choice.Refused, r =>
        {
            w.Text("kind", ReportWords.Of(r.Kind));
            w.Text("reason", r.Reason);
        });
        if (File is not null)
        {
            w.Object("program", () =>
            {
                w.Text("file", File);
                w.Text("sha256", Sha256);
                if (Call is not null)
                {
                    w.Text("call", Call);
                }
            });
        }
    }

    /// <summary>Reads what <see cref="Write(ReportWriter)"/> writes.</summary>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    internal static ReportCorrection Read(ReportReader r)
    {
        var program = r.OptionalObject("program");
        return new(
            new(
                r.OptionalText("kind") is null ? null : r.Word<CorrectionKind>("kind", ReportWords.Of),
                r.OptionalObject("radius") is { } radius
                    ? new(
                        radius.Count("number"),
                        radius.Count("tool"),
                        Exact(radius.Number("totalMm")),
                        Exact(radius.OptionalNumber("beforeMm")))
                    : null,
                r.OptionalObject("workOffset") is { } work
                    ? new(work.Count("number"), Shift(work.Object("total")), work.OptionalObject("before") is { } b ? Shift(b) : null)
                    : null,
                r.Number("differenceMm"),
                r.List("refused", x => new KindRefused(x.Word<CorrectionKind>("kind", ReportWords.Of), x.Text("reason"))),
                null)
            {
                Expected = Expected(r.OptionalObject("expected")),
                ExpectedByBlocks = Expected(r.OptionalObject("expectedByBlocks")),
            },
            program?.Text("file"),
            program?.Text("sha256"))
        {
            Call = program?.OptionalText("call"),
        };
    }

    private static void Write(ReportWriter w, OffsetShift shift)
    {
        w.Number("xMm", (double)shift.XMm);
        w.Number("yMm", (double)shift.YMm);
        w.Number("rotationDegrees", (double)shift.RotationDegrees);
    }

    private static void Write(ReportWriter w, ExpectedError expected)
    {
        w.Number("rmsMm", expected.RmsMm);
        w.Number("largestMm", expected.LargestMm);
    }

    private static ExpectedError? Expected(ReportReader? r) => r is null ? null : new(r.Number("rmsMm"), r.Number("largestMm"));

    private static OffsetShift Shift(ReportReader r) =>
        new(Exact(r.Number("xMm")), Exact(r.Number("yMm")), Exact(r.Number("rotationDegrees")));

    // Offsets have few decimals, which a double keeps; values beyond any offset are cut off.
    private static decimal Exact(double value) => Math.Round((decimal)Math.Clamp(value, -1e6, 1e6), 9);

    private static decimal? Exact(double? value) => value is { } v ? Exact(v) : null;
}
