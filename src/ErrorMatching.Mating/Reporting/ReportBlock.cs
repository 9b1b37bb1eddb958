using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A block of the program before and after, to show side by side.</summary>
/// <param name="Number">Its number as written (<c>N110</c>); empty if it has none.</param>
/// <param name="Line">Its line in the original program, from 1.</param>
/// <param name="Original">Its text in the original program; empty for an inserted block.</param>
/// <param name="Modified">Its text in the new program.</param>
/// <param name="OriginalSpans">The replaced parts of the original text.</param>
/// <param name="ModifiedSpans">Their replacements in the new text.</param>
public sealed record ReportBlock(
    string Number,
    int Line,
    string Original,
    string Modified,
    IReadOnlyList<TextSpan> OriginalSpans,
    IReadOnlyList<TextSpan> ModifiedSpans)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("number", Number);
        w.Count("line", Line);
        w.Text("original", Original);
        w.Text("modified", Modified);
        w.List("originalSpans", OriginalSpans, s => s.Write(w));
        w.List("modifiedSpans", ModifiedSpans, s => s.Write(w));
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ReportBlock Read(ReportReader r)
    {
        var (original, modified) = (r.Text("original"), r.Text("modified"));
        return new(
            r.Text("number"),
            r.Count("line"),
            original,
            modified,
            r.List("originalSpans", s => TextSpan.Read(s, original)),
            r.List("modifiedSpans", s => TextSpan.Read(s, modified)));
    }
}
