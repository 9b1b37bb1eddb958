using System.Text.Json;
using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What a person reads before approving: one convention for errors, what will be left over, where the program goes,
/// and what to look at first.</summary>
public sealed class CorrectionHeadTests
{
    [Fact]
    public Task What_is_left_over_is_told_as_the_verification_tells_it() => Seat.AtAsync(prepare: WantedGap.In, test: seat =>
    {
        var detail = Arrive(seat);

        // Table 5 of Wang, Tu and Gunawan (2021): the part lies 0.117 mm further out at point 1,
        // so a counterpart as designed leaves a gap there.
        Assert.Equal("−0.1170", detail.Points[0].Without);
        Assert.Equal(WantedGap.Outside, detail.Points.Where(p => p.IsOutside).Select(p => p.Point));
        seat.Tap("tab-points");
        Assert.Contains(
            "above zero the pieces overlap, below zero there is a gap", seat.TextOf("points-note"), StringComparison.OrdinalIgnoreCase);
        var marked = seat.See("points")
            .GetVisualDescendants()
            .OfType<ListBoxItem>()
            .Where(i => i.GetVisualDescendants().OfType<Avalonia.Controls.Shapes.Path>().Any(p => p.IsEffectivelyVisible));
        Assert.Equal(WantedGap.Outside, marked.Select(i => ((PointRow)i.Content!).Point));

        seat.Tap("nav-verification").See("piece-title");
        var verified = ((VerificationViewModel)seat.Shell.Current!).Detail!;
        Assert.Equal(
            verified.Points.Select(p => (p.Point, p.Before, p.After, p.IsOutside)),
            detail.Points.Select(p => (p.Point, p.Without, p.LeftOver, p.IsOutside)));
    });

    [Fact]
    public Task The_head_says_what_is_proved_what_is_left_over_and_what_moves_most() => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        seat.Tap("tab-decisions");
        using var report = JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        var (proof, points) = (
            report.RootElement.GetProperty("proof"), report.RootElement.GetProperty("keyPoints").EnumerateArray().ToArray());
        Assert.Equal(
            $"Proved to {Shown.Mm(proof.GetProperty("maxDeviationFromWantedMm").GetDouble())}\u00a0mm: "
                + $"{proof.GetProperty("movedMotions")} of {proof.GetProperty("motions")} motions displaced as intended, the rest "
                + $"unchanged.",
            seat.TextOf("detail-proof"));
        var match = StoredReport.Read(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!)).Match!;
        Assert.Equal(MatchVerdictText.Of(match.Verdict), seat.TextOf("detail-verdict"));
        Assert.Matches(
            "^16 of 16 points will be within ±0\\.05 \\(worst 0\\.00[0-9]+\u00a0±\u00a00\\.0[0-9]+\\)\\. Cut it\\.$",
            seat.TextOf("detail-verdict"));
        var worst = points.MaxBy(p => Math.Abs(p.GetProperty("predictedMm").GetDouble()));
        Assert.StartsWith(
            $"Worst at the points: {Shown.SignedMm(worst.GetProperty("predictedMm").GetDouble())}\u00a0±\u00a0"
                + $"{Shown.Mm(worst.GetProperty("interval95Mm").GetDouble())}\u00a0mm at point "
                + $"{worst.GetProperty("point").GetString()} of ",
            seat.TextOf("detail-left-over"),
            StringComparison.Ordinal);
        Assert.Contains("; between them: ", seat.TextOf("detail-left-over"), StringComparison.Ordinal);
        Assert.Contains(" Risk that a point will be outside its limits: ", seat.TextOf("detail-left-over"), StringComparison.Ordinal);

        // It is looked at first: nothing in the head is above it, or as large.
        var verdict = (TextBlock)seat.See("detail-verdict");
        Assert.True(Layout.In(verdict, seat.Window).Bottom <= Layout.In(seat.See("detail-title"), seat.Window).Top);
        Assert.True(verdict.FontSize > ((TextBlock)seat.See("detail-title")).FontSize);
        Assert.True(Application.Current!.TryGetResource("Good", seat.Window.ActualThemeVariant, out var good));
        Assert.Same(good, verdict.Foreground);

        // The tip of the tooth moves most, where both flanks meet.
        Assert.Equal(
            $"Largest displacement {Shown.Mm(seat.Station.Store.Find(1)!.LargestMm)}\u00a0mm at N150", seat.TextOf("detail-largest"));
        Assert.Equal(("Complex mating", "Goes to vmc1/A as counterpart.nc"), (seat.TextOf("detail-job"), seat.TextOf("detail-target")));
        seat.Tap("approve");
        Assert.Equal(
            ("Complex mating · #1 · 0001", "Goes to vmc1/A as counterpart.nc"),
            (seat.TextOf("signing-subject"), seat.TextOf("signing-target")));

        // Who signs sees what for, although the dialog hides the head.
        (string?, Severity)[] known = [
            (seat.TextOf("detail-verdict"), Severity.Quiet),
            (seat.TextOf("detail-largest"), Severity.Quiet),
            (seat.TextOf("detail-left-over"), Severity.Quiet),
            ("Warnings: 2", Severity.Attention)];
        Assert.Equal(known, seat.Shell.Signing!.Facts.Select(f => ((string?)f.Text, f.Severity)));
        Assert.All(
            known,
            k => Assert.Contains(
                seat.See("signing-facts").GetVisualDescendants().OfType<TextBlock>(), t => t.Text == k.Item1 && t.IsEffectivelyVisible));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(
            () => seat.Shell.Signing.Facts[0].Text.StartsWith("16 點中 16 點", StringComparison.Ordinal)
                && seat.Shell.Signing.Facts[1].Text.StartsWith("最大位移", StringComparison.Ordinal),
            "What is signed stays in the language before.");
        Texts.Current.Language = Language.English;
        seat.Tap("signing-leave");

        // Who rejects need not be warned of the program.
        seat.Tap("reject");
        Assert.Empty(seat.Shell.Signing!.Facts);
        Assert.Null(seat.Find("signing-target"));
        seat.Tap("signing-leave");

        // A tap on the warnings leads to them, and each is to be read.
        var warnings = seat.See("detail-warnings");
        Assert.Equal("Warnings: 2", AutomationProperties.GetName(warnings));
        seat.Tap("tab-decisions");
        var texts = seat.See("warnings").GetVisualDescendants().OfType<TextBlock>().ToArray();
        var window = seat.See("warnings").FindAncestorOfType<ScrollViewer>()!;
        Assert.Equal(2, texts.Length);
        Assert.All(
            texts,
            t => Assert.True(
                new Rect(window.Bounds.Size).Contains(new Rect(t.Bounds.Size).TransformToAABB(t.TransformToVisual(window)!.Value)),
                $"{t.Text} is not to be seen."));
    });

    [Fact]
    public void Where_every_point_comes_within_its_limits_the_head_is_quiet()
    {
        var detail = new CorrectionDetail(
            new(
                new(1, CorrectionState.Proposed, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1),
                [],
                SampleReport.Of(j => j.Replace("[-0.05, 0.05]", "[-0.1, 0.1]", StringComparison.Ordinal)),
                null),
            TimeProvider.System);
        Assert.True(detail.IsWithin);
        Assert.Equal(Severity.Quiet, detail.VerdictSeverity);
        Assert.StartsWith("16 of 16 points will be within ±0.1 (worst ", detail.Verdict, StringComparison.Ordinal);
        Assert.DoesNotContain(detail.Points, p => p.IsOutside);
    }

    [Fact]
    public void Who_signs_for_an_offset_reads_which_one_its_step_and_its_total()
    {
        var correction = new Correction(
            1, CorrectionState.Proposed, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1)
        {
            Offset = RecordedOffset.Radius.With(1, 0.02m, 0.035m),
            LargestMm = 0.02,
        };
        var detail = new CorrectionDetail(new(correction, [], null, null), TimeProvider.System);
        const string Offset = "offset of the control: radius D1 by 0.0200\u00a0mm, 0.0350\u00a0mm in all.";
        Assert.Equal(Offset, detail.Offset);
        Assert.Equal(Offset, detail.Changed);
        Assert.Contains(new Fact(Offset, Severity.Quiet), detail.Facts);
    }

    [Fact]
    public Task The_next_change_is_a_changed_block_with_those_around_it() => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        seat.Tap("tab-program").Tap("change-next");
        var list = (ListBox)seat.See("program");
        Assert.StartsWith("N110 ", ((ProgramLine)list.SelectedItem!).Original, StringComparison.Ordinal);

        // The twenty-first change is far down: it stands in the middle, not at the edge.
        for (var i = 0; i < 20; i++)
        {
            seat.Tap("change-next");
        }

        var row = list.ContainerFromIndex(list.SelectedIndex)!;
        var middle = row.TranslatePoint(new(0, row.Bounds.Height / 2), list)!.Value.Y;
        Assert.InRange(middle, 0.4 * list.Bounds.Height, 0.6 * list.Bounds.Height);
    });

    [Fact]
    public Task Both_pictures_of_the_gap_are_looked_at_closely_together() => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        seat.Tap("tab-gap").See("gap-after");
        var (before, after) = ((GapPlot)seat.See("gap-before"), (GapPlot)seat.See("gap-after"));

        // Both at once, in the least window there is.
        Assert.Equal(1280, seat.Window.Width);
        var room = (ScrollViewer)seat.See("gap-scroll");
        Assert.Equal((0, room.Viewport.Height), (room.Offset.Y, room.Extent.Height));
        seat.Tap("gap-before-nearer");
        after.Pan(new(30, 20));
        Assert.Equal((before.View.ScaleX, before.View.Middle), (after.View.ScaleX, after.View.Middle));
        Assert.False(before.ShowsAll);
        seat.Tap("gap-after-all");
        Assert.True(before.ShowsAll && after.ShowsAll);
    });

    private static CorrectionDetail Arrive(Seat seat)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        return ((CompensationViewModel)seat.Shell.Current!).Detail!;
    }
}
