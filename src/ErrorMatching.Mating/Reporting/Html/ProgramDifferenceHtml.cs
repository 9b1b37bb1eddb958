using System.Globalization;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The difference of any two programs as one HTML file without network or script: the moved motions with their distances, and
/// the blocks side by side.</summary>
/// <remarks>Lengths are in millimeters. Also well-formed XML; UTF-8 without a byte order mark. The same programs always give the same
/// bytes.</remarks>
public static class ProgramDifferenceHtml
{
    /// <summary>Maximum number of motions to show; the JSON of a comparison has all of them.</summary>
    private const int MotionsShown = 2000;

    /// <summary>The comparison as a page.</summary>
    /// <param name="comparison">Both programs, motion by motion.</param>
    /// <param name="before">Name of the first program.</param>
    /// <param name="after">Name of the second program.</param>
    public static byte[] Write(MotionComparison comparison, string before, string after)
    {
        ArgumentNullException.ThrowIfNull(comparison);
        return ReportPage.Write("Two programs compared", $"{before} and {after}", [
            new("summary", "Summary", html => WriteSummary(html, comparison)),
            new("motions", "Motions that differ", html => WriteMotions(html, comparison)),
            new("program", "Program", html => WriteBlocks(html, comparison)),
        ]);
    }

    private static void WriteSummary(HtmlText html, MotionComparison comparison)
    {
        var facts = new List<(string, string)> { ("Identical", ReportNumber.Count(comparison.Identical, "motion")) };
        foreach (var change in Enum.GetValues<MotionChange>())
        {
            if (comparison.Differences.Count(d => d.Change == change) is > 0 and var count)
            {
                facts.Add((Word(change), ReportNumber.Count(count, "motion")));
            }
        }

        if (comparison.Furthest is { } furthest)
        {
            facts.Add(("Furthest", $"{ReportNumber.Fine(MotionComparison.DistanceMm(furthest))} mm, {Name(comparison, furthest)}"));
        }

        if (comparison.AtEnd is { } end)
        {
            facts.Add(("At the end", Words(end)));
        }

        ReportFacts.Write(html, [.. facts]);
        html.Put(
            "p",
            comparison.IsSame
                ? "Both programs do the same."
                : "Motions are compared, not text: another block number or spelling is no difference. Tool radius compensation is not "
                    + "applied.");
    }

    private static void WriteMotions(HtmlText html, MotionComparison comparison)
    {
        if (comparison.Differences.Count == 0)
        {
            html.Put("p", "None.");
            return;
        }

        TableColumn[] columns = [
            new("Line", true), new("Block"), new("Change"), new("X", true, "Displacement (mm)"), new("Y", true, "Displacement (mm)"),
            new("Z", true, "Displacement (mm)"), new("Words that move nothing")];
        HtmlTable.Write(
            html,
            "motions-table",
            "Motions that differ, in the order of the programs",
            columns,
            comparison.Differences.Take(MotionsShown),
            (row, d) =>
        {
            row.Number((BlockOf(comparison, d) + 1).ToString(CultureInfo.InvariantCulture));
            row.Header(Name(comparison, d));
            row.Text(Word(d.Change));
            var isPair = d.Before >= 0 && d.After >= 0;
            foreach (var value in new[] { d.Displacement.X, d.Displacement.Y, d.Displacement.Z })
            {
                row.Number(isPair ? ReportNumber.Signed(value) : ReportNumber.None);
            }

            row.Text(d.Functions is { } functions ? Words(functions) : "");
        }, isLong: true);
        if (comparison.Differences.Count > MotionsShown)
        {
            html.Put("p", $"{ReportNumber.Count(comparison.Differences.Count - MotionsShown, "more motion")} are not listed here.");
        }
    }

    private static void WriteBlocks(HtmlText html, MotionComparison comparison)
    {
        var blocks = DifferenceRows.Of(comparison);
        if (blocks.Count == 0)
        {
            html.Put("p", "No word differs.");
            return;
        }

        BlockTable.Write(html, blocks);
    }

    private static int BlockOf(MotionComparison comparison, MotionDifference d) =>
        d.Before >= 0 ? comparison.Before.Motions[d.Before].Block : comparison.After.Motions[d.After].Block;

    private static string Name(MotionComparison comparison, MotionDifference d)
    {
        var program = (d.Before >= 0 ? comparison.Before : comparison.After).Program;
        return program.NameOf(program[BlockOf(comparison, d)]);
    }

    private static string Words(FunctionChange change) => $"{Side(change.Before)} → {Side(change.After)}";

    private static string Side(IReadOnlyList<string> words) => words.Count == 0 ? "nothing" : string.Join(' ', words);

    private static string Word(MotionChange change) => change switch
    {
        MotionChange.Moved => "Moved",
        MotionChange.Replaced => "Replaced",
        MotionChange.Feed => "Feed",
        MotionChange.Inserted => "Inserted",
        MotionChange.Removed => "Removed",
        MotionChange.Tool => "Tool",
        MotionChange.Spindle => "Spindle",
        _ => "Words",
    };
}
