using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;
using Avalonia;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What the screen of on-line compensation says and how its figures stand, beside the figures themselves.</summary>
public sealed partial class CompensationWordsTests
{
    // Table 5 of Wang, Tu and Gunawan (2021): point 1 of L1 lies 0.117 mm off, where 0.05 are allowed;
    // of L2L3 two points are outside by 0.051 and 0.086.
    [Theory]
    [InlineData(0, "L1 · line", "+0.1170", "Points outside: 1; furthest: point 1, 0.0670\u00a0mm beyond its limit.")]
    [InlineData(1, "L2L3 · triangle", "+0.1359", "Points outside: 2; furthest: point 3b, 0.0859\u00a0mm beyond its limit.")]
    public Task A_decision_says_its_reason(int row, string feature, string largest, string reason) => Seat.AtAsync(seat =>
    {
        var decision = Arrive(seat).Decisions[row];
        Assert.Equal((feature, "Compensated", largest), (decision.Feature, decision.Decision, decision.Largest));
        Assert.Equal(reason + " The counterpart follows the whole deviation.", decision.Reason);
        seat.Tap("tab-decisions");
        seat.WaitFor(
            () => seat.Window.GetVisualDescendants().OfType<TextBlock>().Any(t => t.IsEffectivelyVisible && t.Text == decision.Reason),
            "The reason is not on the screen.");
    });

    [Fact]
    public Task Deviations_are_drawn_as_many_times_larger_as_is_said() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        seat.Tap("tab-gap").See("gap-exaggeration");
        var factor = double.Parse(Number().Match(seat.TextOf("gap-exaggeration")!).Value, CultureInfo.InvariantCulture);
        Assert.True(factor > 1, $"{factor} shows nothing.");
        using var report = JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        var designed = report.RootElement.GetProperty("keyPoints")
            .EnumerateArray()
            .ToDictionary(p => p.GetProperty("point").GetString()!, p => p.GetProperty("theoretical"), StringComparer.Ordinal);
        foreach (var drawing in new[] { detail.Before!, detail.After! })
        {
            Assert.Equal(16, drawing.Points.Count);

            // The part stands upright and is drawn lying, turned clockwise: its x is seen downward, its y to the right.
            // Deviations are drawn from where the program cuts, which is less than a micrometer beside the designed points here.
            Assert.All(
                drawing.Points,
                p => Assert.Equal(
                    factor * Math.Abs(p.PartMm),
                    (
                        p.At - new Point2(designed[p.Label].GetProperty("y").GetDouble(), -designed[p.Label].GetProperty("x").GetDouble()))
                        .Length,
                    0.001));
        }
    });

    [Fact]
    public Task A_decision_says_by_which_convention_its_deviation_has_its_sign() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);

        // The same point, seen from the part and seen from the mating.
        Assert.Equal(("+0.1170", "−0.1170"), (detail.Decisions[0].Largest, detail.Points[0].Without));
        seat.Tap("tab-decisions").See("decisions-note");
        Assert.Equal(
            "Largest deviation: actual − theoretical of the part along the normal, positive where the counterpart needs more material. "
                + "The limits have the same sign. +0.1359\u00a0mm here is a mating error of −0.1359\u00a0mm under Points.",
            seat.TextOf("decisions-note"));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(
            () => seat.TextOf("decisions-note") == "最大偏差：沿法線的 工件實際值 − 理論值，正值表示對應件需要更多材料，公差限的正負號相同。"
                + "此處的 +0.1359\u00a0mm 即「關鍵點」頁的配合誤差 −0.1359\u00a0mm。",
            "It is said in English only.");
        Texts.Current.Language = Language.English;
    });

    [Fact]
    public Task The_course_begins_with_what_was_last_and_counts_warnings_instead_of_saying_them_again() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        Assert.Equal(["Needs approval", "Calculated", "Recognized", "Arrived"], detail.Steps.Select(s => s.State));
        Assert.Equal(
            $"displaced by at most {Shown.Mm(seat.Station.Store.Find(1)!.LargestMm)}\u00a0mm at block N150. Warnings: 2",
            detail.Steps[1].Basis);
        Assert.Contains(
            "Point 2 lies on a rounded corner",
            seat.Station.Store.Corrections.StepsOf(1).Single(s => s.To == CorrectionState.Computed).Basis.Sentence,
            StringComparison.Ordinal);
    });

    [Fact]
    public Task How_many_blocks_changed_is_said_beside_the_program() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        using var report = JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        Assert.Equal(
            $"Blocks changed: {report.RootElement.GetProperty("program").GetProperty("changedBlocks").GetInt32()}. Changed words are "
                + $"marked.",
            detail.Changed);
    });

    [Fact]
    public Task A_length_or_an_angle_is_told_aloud_with_its_feature() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        seat.Tap("tab-features").See("quantities");
        var names = seat.See("quantities")
            .GetVisualDescendants()
            .OfType<ListBoxItem>()
            .Where(i => i.IsEffectivelyVisible)
            .Select(i => ControlAutomationPeer.CreatePeerForElement(i).GetName())
            .ToArray();
        Assert.Equal(detail.Quantities.Take(names.Length).Select(q => $"{q.Feature} · {q.Quantity}"), names);
        Assert.Equal(names.Length, names.Distinct(StringComparer.Ordinal).Count());
        Assert.Contains("L1 · length", names);
    });

    // The corner beside point 2 cannot be followed: what is left over there turns the predicted line,
    // which looks like a correction made twice.
    [Fact]
    public Task What_is_ideal_actual_and_corrected_is_said_below_the_lengths_and_angles() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        seat.Tap("tab-features").See("features-note");
        Assert.Equal(
            "Ideal: as designed. Actual: as measured on the part. Corrected: as predicted on the counterpart; it should come close to "
                + "actual. The difference remains at the points, or is along the boundary, where points are not moved.",
            seat.TextOf("features-note"));
        var direction = detail.Quantities.Single(q => q.Feature == "L1" && q.Quantity == "direction");
        var turned = Angle.FromRadians(Math.Atan2(
            Value(detail.Points[0].LeftOver) - Value(detail.Points[1].LeftOver),
            Value(detail.Quantities.Single(q => q.Feature == "L1" && q.Quantity == "length").Corrected))).Degrees;
        Assert.Equal(turned, Math.Abs(Value(direction.Corrected) - Value(direction.Actual)), 0.005);

        static double Value(string shown) => double.Parse(shown.Split('\u00a0')[0].Replace('\u2212', '-'), CultureInfo.InvariantCulture);
    });

    [Theory]
    [InlineData("points", 8)]
    [InlineData("counterpart", 6)]
    [InlineData("features", 3)]
    public Task Figures_of_a_column_stand_with_their_decimal_signs_below_each_other(string side, int count) => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        seat.Tap("tab-" + side);
        var columns = seat.See(side switch { "points" => side, "counterpart" => "counterparts", _ => "quantities" })
            .GetVisualDescendants()
            .OfType<TextBlock>()
            .Where(
                t => t.IsEffectivelyVisible
                    && t.Classes.Contains("figure")
                    && t.DataContext is PointRow or CounterpartRow or QuantityRow
                    && t.Text!.Contains('.', StringComparison.Ordinal))
            .GroupBy(t => Math.Round(t.TranslatePoint(new(t.Bounds.Width, 0), seat.Window)!.Value.X))
            .Select(
                g => g.Select(
                    t => t.TranslatePoint(
                        new(t.TextLayout.HitTestTextPosition(t.Text!.IndexOf('.', StringComparison.Ordinal)).X, 0), seat.Window)!.Value.X
                        + Indent(t)).ToArray())
            .ToArray();
        Assert.Equal(count, columns.Length);
        Assert.All(columns, c => Assert.True(c.Length > 4 && c.Max() - c.Min() < 0.5, string.Join(" ", c)));

        // Where a block of text is wider than its text, the text stands at its right end.
        static double Indent(TextBlock text) =>
            text.TextAlignment == Avalonia.Media.TextAlignment.Right ? Math.Max(0, text.Bounds.Width - text.TextLayout.Width) : 0;
    });

    private static CorrectionDetail Arrive(Seat seat)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Detail is not null, "The correction is not shown.");
        return screen.Detail!;
    }

    [GeneratedRegex("[0-9]+", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex Number();
}
