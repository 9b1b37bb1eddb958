using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with how the part was measured: alignment, origin, uncertainty, tolerance chain, time.</summary>
internal static class MatchMeasuring
{
    public static void Write(HtmlText html, MatchReport report)
    {
        WriteAlignments(html, report.Alignments);
        if (report.OriginCheck is { } check)
        {
            html.Put("h3", "Origin");
            html.Put(
                "p",
                $"{(check.Holds ? "✓" : "✗")} The origin {check.Point} was measured {ReportNumber.Plain(check.DistanceMm)} mm off; "
                    + $"{ReportNumber.Plain(check.LimitMm)} mm are allowed.");
        }

        WriteUncertainty(html, report.Uncertainty);
        if (report.Chain is { } chain)
        {
            WriteChain(html, chain);
        }

        html.Put("h3", "Time");
        html.Put(
            "p",
            $"Measuring: {ReportNumber.Seconds(report.Time.MeasuringS)} s by equation (7) of Wang 2021, an "
                + $"estimate.{(report.Time.CalculatingS is { } s ? $" Calculating: {ReportNumber.Seconds(s)} s, as measured." : "")}");
    }

    private static void WriteAlignments(HtmlText html, IReadOnlyList<ReportAlignment> alignments)
    {
        TableColumn[] columns = [
            new("Measurement"), new("Kind"), new("Mirror"), new("Rotation, °", true), new("X, mm", true, "Translation"),
            new("Y, mm", true, "Translation"), new("RMS, mm", true, "Left"), new("Largest, mm", true, "Left")];
        html.Put("h3", "Alignment");
        HtmlTable.Write(
            html,
            "alignment-table",
            "How the measured points were moved before they were compared",
            columns,
            alignments,
            (row, a) =>
        {
            row.Header(a.Role);
            row.Text(ReportWords.Of(a.Kind));
            row.Text(ReportWords.Of(a.Transform.Mirror));
            row.Number(ReportNumber.Signed(a.Transform.Rotation.Degrees));
            row.Number(ReportNumber.Signed(a.Transform.Translation.X));
            row.Number(ReportNumber.Signed(a.Transform.Translation.Y));
            row.Number(ReportNumber.Plain(a.RmsMm));
            row.Number(ReportNumber.Plain(a.MaxMm));
        });
        if (alignments.Any(a => a.Residuals.Count > 0))
        {
            WriteResiduals(html, alignments);
        }
    }

    private static void WriteResiduals(HtmlText html, IReadOnlyList<ReportAlignment> alignments)
    {
        using (html.In("details"))
        {
            html.Put("summary", "What the alignment leaves, point by point");
            HtmlTable.Write(
                html,
                "residuals-table",
                "Aligned - theoretical, mm",
                [new("Measurement"), new("Point"), new("X", true), new("Y", true)],
                alignments.SelectMany(a => a.Residuals.Select(r => (a.Role, Residual: r))),
                (row, r) =>
            {
                row.Text(r.Role);
                row.Header(r.Residual.Point);
                row.Number(ReportNumber.Signed(r.Residual.Left.X));
                row.Number(ReportNumber.Signed(r.Residual.Left.Y));
            }, isLong: true);
        }
    }

    private static void WriteUncertainty(HtmlText html, UncertaintyBudget budget)
    {
        html.Put("h3", "Uncertainty");
        HtmlTable.Write(
            html,
            "uncertainty-table",
            "Standard uncertainty of a measured coordinate",
            [new("Cause"), new("Contribution, mm", true)],
            budget.Contributions.Append(new("combined (root sum of squares)", budget.CombinedMm)),
            (row, c) =>
        {
            row.Header(c.Name);
            row.Number(ReportNumber.Fine(c.ValueMm));
        });
    }

    private static void WriteChain(HtmlText html, ReportChain chain)
    {
        html.Put("h3", "Tolerance chain");
        HtmlTable.Write(
            html,
            "chain-table",
            "Dimensions that add up to the mating dimension, mm",
            [new("Dimension"), new("Sign"), new("Nominal", true), new("Lower", true, "Tolerance"), new("Upper", true, "Tolerance")],
            chain.Links,
            (row, l) =>
        {
            row.Header(l.Name);
            row.Text(l.Sign > 0 ? "+" : "-");
            row.Number(ReportNumber.Plain(l.NominalMm));
            row.Number(ReportNumber.Signed(l.Tolerance.LowerMm));
            row.Number(ReportNumber.Signed(l.Tolerance.UpperMm));
        });
        (string Name, ChainDimension Dimension)[] sums = [
            ("worst case", chain.WorstCase), ("root sum of squares", chain.RootSumOfSquares)];
        HtmlTable.Write(
            html,
            "chain-sum-table",
            "The mating dimension by the chain, mm",
            [new("Method"), new("Nominal", true), new("Smallest", true), new("Largest", true)],
            sums,
            (row, s) =>
        {
            row.Header(s.Name);
            row.Number(ReportNumber.Plain(s.Dimension.NominalMm));
            row.Number(ReportNumber.Plain(s.Dimension.SmallestMm));
            row.Number(ReportNumber.Plain(s.Dimension.LargestMm));
        });
    }
}
