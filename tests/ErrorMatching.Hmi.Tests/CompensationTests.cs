using System.Globalization;
using System.Text.Json;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

public sealed class CompensationTests
{
    [Fact]
    public Task Every_figure_is_that_of_the_report() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat, DemoCell.Setter);
        using var report = JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        var points = report.RootElement.GetProperty("keyPoints").EnumerateArray().ToArray();
        Assert.Equal(16, points.Length);
        Assert.Equal(points.Length, detail.Points.Count);
        foreach (var (json, row) in points.Zip(detail.Points))
        {
            Assert.Equal(json.GetProperty("point").GetString(), row.Point);
            Same(json.GetProperty("theoretical").GetProperty("x"), row.TheoreticalX);
            Same(json.GetProperty("theoretical").GetProperty("y"), row.TheoreticalY);
            Same(json.GetProperty("actual").GetProperty("x"), row.ActualX);
            Same(json.GetProperty("actual").GetProperty("y"), row.ActualY);
            Same(json.GetProperty("correction").GetProperty("x"), row.CompensationX);
            Same(json.GetProperty("correction").GetProperty("y"), row.CompensationY);

            // The sample's program is in the part's frame: the paper's figure 9 shows both.
            var counterpart = detail.Counterparts.Single(c => c.Point == row.Point);
            Same(json.GetProperty("inProgram").GetProperty("x"), counterpart.TheoreticalX);
            Same(json.GetProperty("inProgram").GetProperty("y"), counterpart.TheoreticalY);
            Assert.Equal((row.TheoreticalX, row.TheoreticalY), (counterpart.TheoreticalX, counterpart.TheoreticalY));
            Assert.Equal((row.CompensationX, row.CompensationY), (counterpart.CompensationX, counterpart.CompensationY));
            Assert.Equal(
                json.GetProperty("theoretical").GetProperty("x").GetDouble() + json.GetProperty("correction").GetProperty("x").GetDouble(),
                double.Parse(counterpart.CorrectedX.Replace('\u2212', '-'), CultureInfo.InvariantCulture),
                0.00006);
            Assert.Equal(
                Shown.SignedMm(json.GetProperty("predictedMm").GetDouble(), json.GetProperty("interval95Mm").GetDouble()), row.LeftOver);

            // Feed-forward: what was decided about is part - counterpart as designed; a mating error is the other way round, with what the
            // program does differently from the design: less than a micrometer here.
            var without = json.GetProperty("uncompensatedMm").GetDouble();
            Assert.Equal(Shown.SignedMm(without), row.Without);
            Assert.Equal(-json.GetProperty("decidedMm").GetDouble(), without, 0.001);
        }

        var quantities = report.RootElement.GetProperty("features")
            .EnumerateArray()
            .SelectMany(f => f.GetProperty("theoretical").EnumerateObject().Select(q => (Feature: f, q.Name)))
            .ToArray();
        Assert.Equal(quantities.Length, detail.Quantities.Count);
        foreach (var ((feature, name), row) in quantities.Zip(detail.Quantities))
        {
            Assert.Equal(feature.GetProperty("name").GetString(), row.Feature);
            Same(feature.GetProperty("theoretical").GetProperty(name), row.Ideal);
            Same(feature.GetProperty("actual").GetProperty(name), row.Actual);
            Same(feature.GetProperty("corrected").GetProperty(name), row.Corrected);
        }

        seat.Tap("tab-decisions");
        Assert.Contains("Proved", seat.TextOf("detail-proof"), StringComparison.Ordinal);
        Assert.Equal(
            report.RootElement.GetProperty("program").GetProperty("changedBlocks").GetInt32(), detail.Stored.Report!.Program.ChangedBlocks);
    });

    [Fact]
    public Task The_paper_s_deviations_are_on_the_screen() => Seat.AtAsync(seat =>
    {
        // Table 5 of Wang, Tu and Gunawan (2021): point 1 is designed at (-31.950, 76.008) and measured at (-32.067, 76.005).
        var first = Arrive(seat, DemoCell.Operator).Points[0];
        Assert.Equal(
            ("1", "−31.9500", "76.0080", "−32.0670", "76.0050"),
            (first.Point, first.TheoreticalX, first.TheoreticalY, first.ActualX, first.ActualY));
    });

    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task Each_group_of_figures_has_its_name_over_its_middle(Language language) => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Operator);
        seat.Tap("tab-points");
        Texts.Current.Language = language;
        seat.User.Settle();
        var texts = seat.Window.GetVisualDescendants().OfType<TextBlock>().Where(t => t.IsEffectivelyVisible).ToArray();
        var (x, y) = (All("Detail.X"), All("Detail.Y"));
        string[] names = ["Detail.Theoretical", "Detail.Actual", "Detail.Compensation"];
        for (var group = 0; group < names.Length; group++)
        {
            // Each of two columns of one width ends with its head.
            var width = y[group].Right - x[group].Right;
            Assert.Equal(x[group].Right, Assert.Single(All(names[group])).Center.X, width / 20);
        }

        Rect[] All(string key) =>
            [.. texts.Where(t => t.Text == Texts.Current[key]).Select(t => Layout.In(t, seat.Window)).OrderBy(r => r.X)];
    });

    [Fact]
    public Task Programs_stand_side_by_side_line_by_line() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat, DemoCell.Setter);
        var correction = seat.Station.Store.Find(1)!;
        Assert.Equal(
            Lines(correction.BaseSha256!),
            detail.Lines!.Where(l => l.Original.Length > 0 || l.ModifiedSpans.Count == 0).Select(l => l.Original));
        Assert.Equal(Lines(correction.ProgramSha256!), detail.Lines!.Select(l => l.Modified));
        Assert.Equal(detail.Stored.Report!.Program.ChangedBlocks, detail.Lines!.Count(l => l.IsChanged && l.Original.Length > 0));
        Assert.All(detail.Lines!.Where(l => !l.IsChanged), l => Assert.Equal(l.Original, l.Modified));
        seat.Tap("tab-program").Tap("change-next");
        var list = (ListBox)seat.See("program");
        Assert.True(((ProgramLine)list.SelectedItem!).IsChanged);

        string[] Lines(string sha) => System.Text.Encoding.Latin1.GetString(seat.Station.Store.Content(sha))
            .TrimEnd('\n')
            .Split('\n')
            .Select(l => l.TrimEnd('\r'))
            .ToArray();
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task Programs_begin_at_the_first_change_and_the_marker_is_found_above(bool isInHistory) => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat, DemoCell.Setter);
        if (isInHistory)
        {
            seat.Tap("nav-history").Tap("found-1").See("detail-title");
        }

        seat.Tap("tab-program").See("program");
        var first = detail.Lines!.Changes[0];
        var marker = detail.Lines.First(l => l.Modified.Contains("ERRORMATCH", StringComparison.Ordinal)).Index;
        seat.WaitFor(() => Enumerable.Range(first - 1, 3).All(IsSeen), "The first change and its neighbors are not seen.");
        Assert.False(IsSeen(marker));

        // Who goes elsewhere stays there, also in another language and coming back from another side.
        seat.User.Wheel(seat.See("program"), 100);
        Assert.True(IsSeen(marker));
        seat.Tap("language").Tap("tab-decisions").Tap("tab-program").See("program");
        seat.User.Settle();
        Assert.True(IsSeen(marker));

        bool IsSeen(int line)
        {
            var list = (ListBox)seat.See("program");
            return list.ContainerFromIndex(line) is { IsEffectivelyVisible: true } row
                && row.TranslatePoint(default, list) is { } at
                && at.Y >= 0
                && at.Y + row.Bounds.Height <= list.Bounds.Height;
        }
    });

    [Fact]
    public Task A_setter_approves_by_signing_again_and_the_machine_has_the_program() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Setter);
        seat.Tap("approve");
        Assert.False(seat.See("signing-confirm").IsEffectivelyEnabled);
        seat.Type("signing-password", "not the password").Tap("signing-confirm");
        seat.WaitFor(() => seat.Find("signing-message") is not null, "A wrong password is not said.");
        seat.WaitFor(() => seat.Find("signing-password") is { IsFocused: true }, "Whoever types it again types into nothing.");
        Assert.Equal("Wrong password for anna. Type it again.", seat.TextOf("signing-message"));
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        var sent = seat.WaitFor(1, CorrectionState.Verified);
        Assert.Equal(
            seat.Station.Store.Content(sent.ProgramSha256!), File.ReadAllBytes(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc")));
        Assert.Contains(seat.Station.Store.Corrections.StepsOf(1), s => s is { To: CorrectionState.Approved, By: DemoCell.Setter });
        seat.WaitFor(() => seat.TextOf("detail-state") == "At the machine", "The screen does not follow.");
        Assert.NotNull(seat.Find("release"));
        Assert.Null(seat.Find("approve"));
    });

    [Fact]
    public Task An_operator_cannot_approve_and_is_told_who_can() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Operator);
        // What has just arrived cannot be decided for a moment, and says that first.
        seat.WaitFor(
            () => seat.TextOf("forbidden") == "A setter must approve this. You can reject it.", "It is not said who can approve it.");
        Assert.False(seat.See("approve").IsEffectivelyEnabled);
    });

    [Fact]
    public Task An_operator_rejects_with_a_reason() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Operator);
        seat.Tap("reject");
        Assert.False(seat.See("signing-confirm").IsEffectivelyEnabled);
        Assert.Null(seat.Find("signing-password"));
        seat.Type("signing-reason", "chip under the probe").Tap("signing-confirm");
        var rejected = seat.WaitFor(1, CorrectionState.Rejected);
        Assert.Equal("chip under the probe", rejected.Reason);
        Assert.Contains(
            seat.Station.Store.Corrections.StepsOf(1),
            s => s is { To: CorrectionState.Rejected, By: DemoCell.Operator, Basis.Sentence: "chip under the probe" });
    });

    [Fact]
    public Task What_is_not_signed_stays_as_it_is() => Seat.AtAsync(seat =>
    {
        Arrive(seat, DemoCell.Setter);
        seat.Tap("approve");
        seat.User.Press(Key.Escape);
        Assert.Null(seat.Find("signing-confirm"));
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
    });

    [Fact]
    public Task The_program_before_is_brought_back() => Seat.AtAsync(seat =>
    {
        var machine = Path.Combine(seat.Cell.MachineFolder, "counterpart.nc");
        var before = File.ReadAllBytes(Path.Combine(AppContext.BaseDirectory, "samples", "complex-mating", "counterpart.nc"));
        File.WriteAllBytes(machine, before);
        Arrive(seat, DemoCell.Setter);
        seat.Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(1, CorrectionState.Verified);
        Assert.NotEqual(before, File.ReadAllBytes(machine));
        seat.Tap("revert").Type("signing-reason", "chatter").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(1, CorrectionState.Reverted);
        Assert.Equal(before, File.ReadAllBytes(machine));
        seat.WaitFor(
            () => seat.Find("signing-confirm") is null
                && seat.TextOf("detail-state") is "Reverted"
                && seat.See("release").IsEffectivelyEnabled,
            "It is not seen to be reverted.")
            .Tap("release")
            .Tap("signing-confirm");
        seat.WaitFor(() => seat.Station.Store.Slot("vmc1", "A").Correction is null, "The slot stays taken.");
    });

    /// <summary>The sample's part arrives, somebody signs in and looks at it.</summary>
    private static CorrectionDetail Arrive(Seat seat, string name)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(name).Tap("nav-compensation").See("pair");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Detail is not null, "The correction is not shown.");
        return screen.Detail!;
    }

    // Half of the last decimal that is shown, and nothing more.
    private static void Same(JsonElement json, string shown)
    {
        if (json.ValueKind == JsonValueKind.Null)
        {
            Assert.Equal(Shown.Nothing, shown);
            return;
        }

        var decimals = shown.Length - shown.IndexOf('.', StringComparison.Ordinal) - 1;
        Assert.Equal(
            json.GetDouble(), double.Parse(shown.Replace('−', '-'), CultureInfo.InvariantCulture), 0.5000001 * Math.Pow(10, -decimals));
    }
}
