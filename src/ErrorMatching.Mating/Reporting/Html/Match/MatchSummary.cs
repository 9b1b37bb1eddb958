using ErrorMatching.Geometry;
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

/// <summary>Plot and drawings of a match: the mating error without compensation, and the predicted one with it.</summary>
internal static class MatchPictures
{
    public static void Write(HtmlText html, MatchReport report) =>
        ReportPictures.Write(
            html,
            Plot(report),
            AssemblyScene.Of(report.Features.Select(f => Draw(report, f))),
            "without compensation",
            "as compensated (predicted)",
            [.. report.Features.Select(f => Between(report, f)).OfType<PlotPlace>()]);

    private static PlotPoint[] Plot(MatchReport report)
    {
        var limits = report.Features.ToDictionary(f => f.Name, f => f.Tolerance.Band.Opposite(), StringComparer.Ordinal);
        return [
            .. report.KeyPoints.Select(p => new PlotPoint(
                p.Point, p.Feature, p.UncompensatedMm, p.PredictedMm, limits.TryGetValue(p.Feature, out var band) ? band : null)
            {
                Interval95Mm = p.Interval95Mm
            })];
    }

    // The place on the axis of the points, at its share of the way from one key point to the next.
    private static PlotPlace? Between(MatchReport report, ReportFeature feature)
    {
        if (ErrorLeft.Between(feature) is not { IsKnown: true } worst)
        {
            return null;
        }

        var (points, last, nearest, place) = (report.KeyPoints, -1, double.PositiveInfinity, double.NaN);
        for (var i = 0; i < points.Count; i++)
        {
            if (points[i].Feature != feature.Name)
            {
                continue;
            }

            if (last >= 0)
            {
                var way = new Segment2(points[last].Theoretical, points[i].Theoretical);
                var fraction = way.NearestFraction(worst.Place);
                var distance = way.At(fraction).DistanceTo(worst.Place);
                (nearest, place) = distance < nearest ? (distance, last + fraction) : (nearest, place);
            }

            last = i;
        }

        return double.IsNaN(place)
            ? null
            : new(feature.Name, place, worst.MatingErrorMm, worst.Interval95Mm ?? 0, VerdictWords.Place(worst));
    }

    private static DrawnFeature? Draw(MatchReport report, ReportFeature feature) => DrawnFeature.Of(
        feature.TheoreticalOutline,
        [
            .. report.PointsOf(feature).Select(p => new DrawnPoint(
                p.Point, p.Theoretical, p.Normal, p.NormalMm, p.NormalMm + p.UncompensatedMm, p.NormalMm + p.PredictedMm)
            {
                Interval95Mm = p.Interval95Mm
            })]);
}

/// <summary>The section with the results of reading the new program again.</summary>
internal static class MatchProof
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var proof = report.Proof;
        WriteVerdict(html, proof);
        (string What, string Found)[] rows =
        [
            ("Motions compared", ReportNumber.Count(proof.Motions)),
            ("Motions that differ", ReportNumber.Count(proof.MovedMotions)),
            ("Largest distance of a motion from where it was wanted", $"{ReportNumber.Fine(proof.MaxDeviationFromWantedMm)} mm"),
            (
                "Neighbors that followed because they touch what moved",
                proof.Neighbors.Count == 0
                    ? "none"
                    : string.Join(
                        "; ",
                        proof.Neighbors.Select(
                            n => $"{n.Block} {ReportWords.Sentence(n.Role)} by {ReportNumber.Fine(n.DisplacementMm)} mm"))),
            ("Every byte outside the changed words is the original one", proof.UntouchedBytesIdentical ? "✓ yes" : "✗ NO"),
            ("Marker comment", proof.Marker ?? "none, since nothing was changed"),
        ];
        HtmlTable.Write(
            html,
            "proof-table",
            "What the comparison of both programs showed",
            [new("Question"), new("Finding")],
            rows,
            (row, r) =>
        {
            row.Header(r.What);
            using (row.Cell("wrap"))
            {
                html.Text(r.Found);
            }
        });
        html.Put(
            "p",
            "The new program was read and interpreted again, and compared with the original motion by motion. Tool radius compensation "
                + "is not applied in the comparison: it is the programmed path that is compared.",
            ("class", "small"));
    }

    /// <summary>Writes whether the proof succeeded, as a mark and words.</summary>
    internal static void WriteVerdict(HtmlText html, ReportProof proof)
    {
        using (html.In("p", ("class", proof.Holds ? "verdict holds" : "verdict fails")))
        {
            html.Put("strong", proof.Holds ? "✓ The proof holds." : "✗ The proof does not hold. Do not use this program.");
            html.Text(
                proof.Holds
                    ? " The new program moves as wanted, and nothing else was changed"
                        + $"{(proof.Marker is null ? "" : ", but for the marker comment")}."
                    : " It does not move as wanted, or something else was changed.");
        }
    }
}
