using System.Globalization;
using System.Text.Json;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A displaced program that was written, and its proof.</summary>
/// <param name="file">The original.</param>
/// <param name="output">The program that was written; null for standard output.</param>
/// <param name="path">The original, interpreted.</param>
/// <param name="rewrite">What was changed.</param>
/// <param name="proof">The result of the proof.</param>
/// <param name="misfitMm">The largest deviation of an element from what was requested at a point; null if no points were given.</param>
internal sealed class NcDisplaceAnswer(string file, string? output, NcPath path, Rewrite rewrite, NcProof proof, double? misfitMm)
    : DocumentAnswer
{
    private const int BlocksShown = 20;

    public override string Schema => "errormatch/nc-displace/1";

    public override ReadOnlyMemory<byte>? Program => output is null ? rewrite.Program.Bytes : default(ReadOnlyMemory<byte>?);

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("dialect", path.Dialect.Name);
        json.WriteString("output", output);
        json.WriteString("sha256", ContentHash.Sha256(rewrite.Program.Bytes.Span));
        json.WriteNumber("changedBlocks", rewrite.ChangedBlocks.Count);
        json.WriteNumber("changedWords", rewrite.ChangedWords);
        json.WriteStartArray("blocks");
        foreach (var block in rewrite.ChangedBlocks)
        {
            json.WriteStartObject();
            json.WriteString("block", path.Program.NumberOf(path.Program[block]));
            json.WriteNumber("line", block + 1);
            json.WriteString("original", path.Program.TextOf(path.Program[block]));
            json.WriteString("modified", rewrite.Program.TextOf(rewrite.Program[block]));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        if (misfitMm is { } misfit)
        {
            json.Number("maxPointMisfitMm", misfit);
        }

        ShownNotes.Write(json, (file, path));
        ShownProof.Write(json, proof);
    }

    public override void WriteText(Page page)
    {
        page.Heading(string.Create(
            CultureInfo.InvariantCulture,
            $"{output ?? "standard output"}: {ReportNumber.Count(rewrite.ChangedWords, "word")} changed in "
                + $"{ReportNumber.Count(rewrite.ChangedBlocks.Count, "block")}"));
        page.Line();
        if (rewrite.ChangedBlocks.Count > 0)
        {
            page.Table(["line", "before", "after"], rewrite.ChangedBlocks.Take(BlocksShown).Select(b => (IReadOnlyList<string>)
                [
                    (b + 1).ToString(CultureInfo.InvariantCulture),
                    path.Program.TextOf(path.Program[b]),
                    rewrite.Program.TextOf(rewrite.Program[b])]));
            if (rewrite.ChangedBlocks.Count > BlocksShown)
            {
                page.Line(string.Create(
                    CultureInfo.InvariantCulture,
                    $"... and {rewrite.ChangedBlocks.Count - BlocksShown} more blocks; --json lists them all."));
            }

            page.Line();
        }

        ShownProof.Write(page, proof);
        ShownNotes.Write(page, (file, path));
        if (misfitMm is > 0.0005 and var misfit)
        {
            page.Warning(
                $"at one of the points the element goes {Show.Mm(misfit)} mm beside what was asked, since a line cannot bend "
                    + $"between its ends. Split the block, or ask for less.");
        }
    }
}
