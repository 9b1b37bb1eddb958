using System.Globalization;
using System.Text.Json;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The motions in which two programs differ: a summary, each motion, then the blocks side by side.</summary>
internal sealed class NcDiffAnswer(string before, string after, MotionComparison comparison) : DocumentAnswer
{
    private const int MotionsShown = 100;

    private static readonly MotionChange[] Changes = Enum.GetValues<MotionChange>();

    public override string Schema => "errormatch/nc-diff/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("before", before);
        json.WriteString("after", after);
        json.WriteString("dialect", comparison.Before.Dialect.Name);
        json.WriteBoolean("sameBytes", SameBytes);
        json.WriteNumber("motionsBefore", comparison.Before.Motions.Length);
        json.WriteNumber("motionsAfter", comparison.After.Motions.Length);
        WriteSummary(json);
        json.WriteStartArray("motions");
        foreach (var difference in comparison.Differences)
        {
            var (was, now) = Sides(difference);
            json.WriteStartObject();
            json.WriteString("change", ShownDifference.Word(difference.Change));
            json.WriteString("block", (was ?? now)!.Block);
            json.WriteNumber("line", (was ?? now)!.Line);
            ShownDifference.WriteVector(json, "displacement", was is null || now is null ? null : difference.Displacement);
            ShownDifference.WriteVector(json, "centerDisplacement", ShownDifference.Center(comparison, difference));
            WriteFunctions(json, "functions", difference.Functions);
            WriteSide(json, "before", was);
            WriteSide(json, "after", now);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        WriteFunctions(json, "functionsAtEnd", comparison.AtEnd);
        ShownNotes.Write(json, (before, comparison.Before), (after, comparison.After));
    }

    public override void WriteText(Page page)
    {
        page.Heading(comparison.IsSame
            ? $"{before} and {after} do the same"
            : string.Create(
                CultureInfo.InvariantCulture,
                $"{ReportNumber.Count(comparison.Differences.Count, "motion differs", "motions differ")} "
                + $"between {before} and {after}"));
        page.Line();
        page.Facts([.. Facts()]);
        ShownNotes.Write(page, (before, comparison.Before), (after, comparison.After));
        if (comparison.Differences.Count > 0)
        {
            page.Line();
            page.Table(
                ["line", "block", "change", "dx", "dy", "dz", "center dx", "dy", "dz"],
                comparison.Differences.Take(MotionsShown).Select(Row));
            if (comparison.Differences.Count > MotionsShown)
            {
                page.Line(string.Create(
                    CultureInfo.InvariantCulture,
                    $"... and {comparison.Differences.Count - MotionsShown} more motions; --json lists them all."));
            }
        }

        if (!SameBytes)
        {
            page.Line();
            ShownBlocks.Write(page, comparison);
        }
    }

    private bool SameBytes => comparison.Before.Program.Bytes.Span.SequenceEqual(comparison.After.Program.Bytes.Span);

    private IEnumerable<(string Name, string Value)> Facts()
    {
        yield return ("identical", Text(comparison.Identical));
        foreach (var change in Changes.Where(c => Count(c) > 0))
        {
            yield return (ShownDifference.Word(change), Text(Count(change)));
        }

        if (comparison.Furthest is { } furthest)
        {
            yield return (
                "largest",
                $"{Show.Mm(MotionComparison.DistanceMm(furthest))} mm, "
                    + $"{comparison.Before.Program.NameOf(comparison.Before.Program[comparison.Before.Motions[furthest.Before].Block])}");
        }

        if (comparison.AtEnd is { } end)
        {
            yield return ("at the end", $"{Words(end.Before)} became {Words(end.After)}");
        }

        static string Text(int count) => count.ToString(CultureInfo.InvariantCulture);

        static string Words(IReadOnlyList<string> words) => words.Count == 0 ? "nothing" : string.Join(' ', words);
    }

    private IReadOnlyList<string> Row(MotionDifference difference)
    {
        var (was, now) = Sides(difference);
        var moved = was is null || now is null ? (Geometry.Vector3?)null : difference.Displacement;
        return
        [
            (was ?? now)!.Line.ToString(CultureInfo.InvariantCulture), (was ?? now)!.Block, ShownDifference.Word(difference.Change),
            .. ShownDifference.Cells(moved), .. ShownDifference.Cells(ShownDifference.Center(comparison, difference)),
        ];
    }

    private int Count(MotionChange change) => comparison.Differences.Count(d => d.Change == change);

    private void WriteSummary(Utf8JsonWriter json)
    {
        json.WriteStartObject("summary");
        json.WriteNumber("identical", comparison.Identical);
        foreach (var change in Changes)
        {
            json.WriteNumber(ShownDifference.Word(change), Count(change));
        }

        json.Number(
            "largestDisplacementMm", comparison.Furthest is { } furthest ? Math.Round(MotionComparison.DistanceMm(furthest), 9) : 0);
        json.WriteEndObject();
    }

    private static void WriteFunctions(Utf8JsonWriter json, string name, FunctionChange? functions)
    {
        if (functions is null)
        {
            json.WriteNull(name);
            return;
        }

        json.WriteStartObject(name);
        foreach (var (side, words) in new[] { ("before", functions.Before), ("after", functions.After) })
        {
            json.WriteStartArray(side);
            foreach (var word in words)
            {
                json.WriteStringValue(word);
            }

            json.WriteEndArray();
        }

        json.WriteEndObject();
    }

    private static void WriteSide(Utf8JsonWriter json, string name, ShownMotion? motion)
    {
        if (motion is null)
        {
            json.WriteNull(name);
            return;
        }

        json.WriteStartObject(name);
        motion.Write(json);
        json.WriteEndObject();
    }

    private (ShownMotion? Before, ShownMotion? After) Sides(MotionDifference difference) =>
        (
            difference.Before < 0 ? null : new(comparison.Before, difference.Before),
            difference.After < 0 ? null : new(comparison.After, difference.After));
}
