using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the key points. Every deviation is actual - nominal.</summary>
internal static class MatchKeyPoints
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var outside = report.Outside.Points;
        var measured = report.KeyPoints.Any(p => p.Counterpart is not null);
        HtmlTable.Write(html, "key-points-table", "Key points in the order of cutting, mm", Columns(measured), report.KeyPoints, (row, p) =>
        {
            row.Header(p.Point);
            row.Text(p.Feature);
            row.Number(ReportNumber.Plain(p.Theoretical.X));
            row.Number(ReportNumber.Plain(p.Theoretical.Y));
            row.Number(ReportNumber.Plain(p.Actual.X));
            row.Number(ReportNumber.Plain(p.Actual.Y));
            if (measured)
            {
                row.Number(p.Counterpart is { } c ? ReportNumber.Plain(c.X) : ReportNumber.None);
                row.Number(p.Counterpart is { } d ? ReportNumber.Plain(d.Y) : ReportNumber.None);
            }

            row.Number(ReportNumber.Signed(-p.Deviation.X));
            row.Number(ReportNumber.Signed(-p.Deviation.Y));
            row.Number(ReportNumber.Signed(p.NormalMm));
            row.Number(ReportNumber.Signed(p.Correction.X));
            row.Number(ReportNumber.Signed(p.Correction.Y));
            row.Number(ReportNumber.Signed(p.UncompensatedMm));
            row.Number((outside.Contains(p.Point) ? "⚠ " : "") + Left(p));
            row.Code(string.Join(' ', p.Blocks));
        });
        html.Put(
            "p",
            "Deviation: actual - theoretical; along the normal from the counterpart's material to its tool, positive where the counterpart "
                + "needs more material. Correction: what is added to the program, in the program's frame. Mating error: counterpart - part "
                + "along the normal, positive where too much material stands (overlap), negative where it lacks (gap); after: as predicted "
                + "from the program that was written, with its 95 % interval; ⚠ marks one that is outside its limits.",
            ("class", "small"));
    }

    /// <summary>The mating error left at a key point, with its interval if it is known.</summary>
    internal static string Left(ReportKeyPoint point) => point.Interval95Mm is { } half
        ? ReportNumber.Interval(point.PredictedMm, half)
        : ReportNumber.Signed(point.PredictedMm);

    private static List<TableColumn> Columns(bool measured)
    {
        var columns = new List<TableColumn>
        {
            new("Point"),
            new("Feature"),
            new("X", true, "Theoretical"),
            new("Y", true, "Theoretical"),
            new("X", true, "Actual part"),
            new("Y", true, "Actual part")
        };
        if (measured)
        {
            columns.AddRange([new("X", true, "Counterpart"), new("Y", true, "Counterpart")]);
        }

        columns.AddRange([
            new("X", true, "Deviation"), new("Y", true, "Deviation"), new("along normal", true, "Deviation"), new("X", true, "Correction"),
            new("Y", true, "Correction"),
            new("before", true, "Mating error"), new("after", true, "Mating error"), new("Blocks")]);
        return columns;
    }
}

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

/// <summary>The appendix with key points and quantities as figure 9 of Wang 2021 prints them: deviations are theoretical -
/// actual.</summary>
internal static class MatchAsInPaper
{
    private static readonly TableColumn[] PointColumns =
        [
            new("Point"), new("X", true, "Theoretical"), new("Y", true, "Theoretical"), new("X", true, "Actual"), new("Y", true, "Actual"),
            new("X", true, "Theoretical - actual"), new("Y", true, "Theoretical - actual")];

    private static readonly TableColumn[] QuantityColumns =
        [
            new("Feature"), new("Quantity"), new("Unit"), new("Ideal", true), new("Actual", true), new("Ideal - actual", true),
            new("Corrected", true)];

    public static void Write(HtmlText html, MatchReport report)
    {
        html.Put(
            "p",
            "Wang 2021 prints deviations as theoretical - actual, the opposite sign of everything above. These columns are for the "
                + "comparison with its tables; do not mix them with the others.");
        HtmlTable.Write(
            html, "paper-points-table", "Key points as in figure 9 of the paper, mm", PointColumns, report.KeyPoints, (row, p) =>
        {
            row.Header(p.Point);
            row.Number(ReportNumber.Plain(p.Theoretical.X));
            row.Number(ReportNumber.Plain(p.Theoretical.Y));
            row.Number(ReportNumber.Plain(p.Actual.X));
            row.Number(ReportNumber.Plain(p.Actual.Y));
            row.Number(ReportNumber.Signed(p.Deviation.X));
            row.Number(ReportNumber.Signed(p.Deviation.Y));
        });
        HtmlTable.Write(
            html,
            "paper-quantities-table",
            "Lengths and angles as in figure 9 of the paper",
            QuantityColumns,
            report.Features.SelectMany(f => f.Quantities.Select(q => (Feature: f, q.Quantity, q.Corrected))),
            (row, q) =>
        {
            row.Header(q.Feature.Name);
            row.Text(QuantityName.Words(q.Quantity.Name));
            row.Text(QuantityName.Unit(q.Quantity.Name));
            row.Number(ReportNumber.Plain(q.Quantity.Theoretical));
            row.Number(ReportNumber.Plain(q.Quantity.Actual));
            row.Number(ReportNumber.Signed(q.Quantity.Deviation));
            row.Number(q.Corrected is { } corrected ? ReportNumber.Plain(corrected) : ReportNumber.None);
        });
    }
}
