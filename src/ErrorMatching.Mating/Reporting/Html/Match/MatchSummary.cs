using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section for the setter at the machine: what was measured, decided, changed and proved, and what to do next.</summary>
internal static class MatchSummary
{
    public static void Write(HtmlText html, MatchReport report)
    {
        MatchProof.WriteVerdict(html, report.Proof);
        ReportFacts.WriteWarnings(html, [.. report.Warnings.Select(w => w.Message)]);
        ReportFacts.Write(html, ("Measured", Measured(report)), ("Decided", Decided(report)), ("Changed", Changed(report)));
        WriteFeatures(html, report);
        html.Put("h3", "What to do next");
        using (html.In("ol"))
        {
            foreach (var step in Steps(report))
            {
                html.Put("li", step);
            }
        }

        WriteWear(html, report);
        ReportFacts.WriteNotes(html, report.Notes);
    }

    private static string Measured(MatchReport report)
    {
        var part = ReportInputs.Find(report.Inputs, "part");
        var counterpart = report.Compensation.From == CompensationSource.Counterpart
            ? ReportInputs.Find(report.Inputs, "counterpart")
            : null;
        return $"{ReportNumber.Count(report.KeyPoints.Count, "key point")} of the part" + Source(part)
            + (counterpart is null ? "" : ", and of the counterpart that the program cut" + Source(counterpart)) + ".";

        static string Source(ReportInput? input) =>
            input is null ? "" : $", {input.File} (SHA-256 {ReportInputs.ShortHash(input.Sha256)}…)";
    }

    private static string Decided(MatchReport report)
    {
        Decision[] decisions = [Decision.Compensated, Decision.WithinTolerance, Decision.NotSignificant];
        var counts = decisions
            .Select(d => (Words: DecisionMark.Words(d), Count: report.Features.Count(f => f.Decision == d)))
            .Where(d => d.Count > 0)
            .Select(d => $"{ReportNumber.Count(d.Count)} {d.Words}");
        var largest = report.KeyPoints.MaxBy(p => Math.Abs(p.DecidedMm));
        return $"{ReportNumber.Count(report.Features.Count, "feature")}: {string.Join(", ", counts)}."
            + (
                largest is null
                    ? ""
                    : $" The largest deviation is {ReportNumber.SignedMm(largest.DecidedMm)}, at point {largest.Point} of "
                        + $"{largest.Feature}.");
    }

    private static string Changed(MatchReport report) => report.IsUnchanged
        ? $"Nothing: {report.Program.File} is the original program, byte for byte."
        : report.Acceptance.IsWithheld
        ? $"Nothing is written. The program would change {ReportNumber.Count(report.Program.ChangedBlocks, "block")} and "
            + $"{ReportNumber.Count(report.Program.ChangedWords, "word")} of them."
        : $"{ReportNumber.Count(report.Program.ChangedBlocks, "block")} and {ReportNumber.Count(report.Program.ChangedWords, "word")} of "
            + $"them, written to {report.Program.File} (SHA-256 {ReportInputs.ShortHash(report.Program.Sha256)}…). The original is "
            + $"untouched.";

    private static void WriteFeatures(HtmlText html, MatchReport report)
    {
        using (html.In("ul", ("class", "features")))
        {
            foreach (var feature in report.Features)
            {
                using (html.In("li"))
                {
                    html.Put("strong", feature.Name);
                    html.Text($" ({feature.Kind.Word}): ");
                    DecisionMark.Write(html, feature.Decision);
                    html.Text(
                        $". Largest deviation {ReportNumber.SignedMm(feature.LargestMm)}"
                            + (
                                report.PointsOf(feature).MaxBy(p => Math.Abs(p.PredictedMm)) is { } left
                                    ? $"; mating error left, as predicted: {MatchKeyPoints.Left(left)} mm."
                                    : ".")
                            + string.Concat(OutsideWords.Of(report.OutsideOf(feature)).Select(s => " ⚠ " + s)));
                }
            }
        }
    }

    private static IEnumerable<string> Steps(MatchReport report)
    {
        if (!report.Proof.Holds)
        {
            return ["Do not send the program to a machine. Read under Proof what differs, and report it."];
        }

        var order = report.Job.WorkOrder is { } number ? $"work order {number}" : $"the job {report.Job.Name}";
        string[] decide = OutsideWords.ToDecide(report.Outside) is { } first ? [first]
            : report.Verdict.IsToCut ? []
            : ["Decide whether to cut: the verdict at the top says what speaks against it."];
        if (report.Acceptance is { IsWithheld: true, Sentence: { } withheld })
        {
            return [.. decide, withheld];
        }

        return
        [
            .. decide,
            $"Make sure that the part is the one of {order}: this counterpart fits no other.",
            report.IsUnchanged
                ? $"Cut the counterpart with {report.Program.File}, which is the program as designed."
                : $"Cut the counterpart with {report.Program.File}, with work offset, tool and wear values as for the original program. "
                    + $"The corrections are in the program: do not enter them as offsets too.",
            "Measure the counterpart, and compare it with the part: errormatch verify.",
        ];
    }

    private static void WriteWear(HtmlText html, MatchReport report)
    {
        if (report.RadiusWearMm is not { } w || !report.Proof.Holds)
        {
            return;
        }

        using (html.In("div", ("class", "box note")))
        {
            html.Put("h3", "The same by tool-radius wear");
            html.Put(
                "p",
                $"Every correction is one uniform offset. If the original program cuts with cutter compensation (G41, G42), a "
                    + $"tool-radius wear value of {ReportNumber.SignedMm(w)} ({ReportNumber.SignedMm(2 * w)} where the control keeps a "
                    + $"diameter) does the same with it. Use the new program or the wear value, never both.");
        }
    }
}
