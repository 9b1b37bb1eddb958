using System.Text;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The picture is in the middle of a screen: it has at least half of it at 1280x800, and all of it at one tap.</summary>
public sealed class PictureTests
{
    private const double MostHead = 120;

    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task The_pair_has_half_of_the_content_and_all_of_it_at_one_tap(Language language) => Seat.AtAsync(seat =>
    {
        Arrive(seat);
        Texts.Current.Language = language;
        seat.User.Settle();
        Assert.Equal((1280, 800), (seat.Window.Width, seat.Window.Height));
        var content = Layout.In(seat.Window.GetVisualDescendants().OfType<ScreenHost>().First(h => h.IsEffectivelyVisible), seat.Window);
        var pair = (PlotArea)seat.See("pair");
        Assert.InRange(Share(), 0.5, 0.6);
        Assert.InRange(Layout.In(seat.See("detail-head").FindAncestorOfType<Border>()!, seat.Window).Height, 40, MostHead);

        seat.Tap("pair-whole");
        Assert.True(pair.FillsScreen);
        Assert.InRange(Share(), 0.9, 1);
        Assert.All(["approve", "corrections", "detail-head", "tab-points"], id => Assert.Null(seat.Find(id)));
        seat.Tap("pair-whole");
        Assert.InRange(Share(), 0.5, 0.6);
        Assert.All(["approve", "corrections", "detail-head", "tab-points"], id => Assert.NotNull(seat.Find(id)));

        // Escape leaves it, and so does whatever takes the plot from the screen.
        seat.Tap("pair-whole");
        pair.Focus();
        seat.User.Press(Key.Escape);
        Assert.False(pair.FillsScreen);
        seat.Tap("pair-whole").Tap("nav-overview").Tap("nav-compensation").See("approve");
        Assert.InRange(Layout.In(seat.See("pair"), seat.Window).Height, 100, 600);

        double Share()
        {
            var place = Layout.Seen(pair, seat.Window);
            return place.Width * place.Height / (content.Width * content.Height);
        }
    });

    [Fact]
    public Task Sixteen_points_are_seen_without_scrolling() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        Assert.Equal(16, detail.Points.Count);
        foreach (var (side, rows) in new[] { ("tab-points", "points"), ("tab-counterpart", "counterparts") })
        {
            seat.Tap(side).WaitFor(() => seat.See(rows).GetVisualDescendants().OfType<ListBoxItem>().Count() == 16, "Rows are missing.");
            Assert.All(
                seat.See(rows).GetVisualDescendants().OfType<ListBoxItem>(),
                r => Assert.Equal(r.Bounds.Height, Layout.Seen(r, seat.Window).Height, 1.0));
        }
    });

    [Fact]
    public Task The_pair_is_drawn_at_its_seat_with_its_contacts_and_the_worst_place() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        var (pair, drawing) = (detail.Stored.Report!.Pair!, detail.Seat!);

        // The sample is tall: it is drawn lying.
        Assert.True(drawing.IsTurned);
        Assert.Equal(pair.Contacts.Select(c => (Lying(c.Place), c.Feature, c.Block)), drawing.Contacts);

        // The counterpart is away from the part by the gap, exaggerated, toward its own material; where they overlap, it is within
        // the part.
        Assert.Equal(pair.Gaps.Count, drawing.Part.Sum(l => l.Count));
        Assert.All(
            pair.Gaps.Zip(drawing.Part.SelectMany(l => l), drawing.Counterpart.SelectMany(l => l)),
            g =>
            {
                Assert.Equal(Lying(g.First.Place), g.Second);
                Assert.Equal(drawing.Factor * g.First.GapMm, (g.Second - g.Third).Dot(new(g.First.Normal.Y, -g.First.Normal.X)), 1e-6);
            });
        Assert.InRange(drawing.Factor * drawing.LargestMm, 1, 0.1 * (drawing.Extent.Right - drawing.Extent.Left));
        var worst = MatchVerdictText.Farthest(detail.Stored.Report.Verdict)!;
        Assert.Equal((Lying(worst.Place), MatchVerdictText.At(worst)), drawing.Worst);
        Assert.Contains(Shown.SignedMm(worst.MatingErrorMm, worst.Interval95Mm), drawing.Worst!.Value.Text, StringComparison.Ordinal);

        // A tap tells the gap there, away from points and contacts, which tell their own.
        var plot = (GapPlot)seat.See("pair");
        var (at, feature, mm) = drawing.Seat.MaxBy(
            s => drawing.Points.Select(p => p.At).Concat(drawing.Contacts.Select(c => c.At)).Min(p => p.DistanceTo(s.At)));
        seat.User.Tap(plot, plot.View.At(at));
        Assert.Equal($"{feature}: gap {Shown.SignedMm(mm)} mm", plot.Values?.Replace('\u00a0', ' '));

        static Point2 Lying(Point2 place) => new(place.Y, -place.X);
    });

    [Fact]
    public Task The_path_beside_a_program_follows_the_line_that_is_found_and_leads_to_the_line_of_a_move() => Seat.AtAsync(seat =>
    {
        var detail = Arrive(seat);
        seat.Tap("tab-program").See("program-path");
        var (plot, list) = ((PathPlot)seat.See("program-path"), (ListBox)seat.See("program"));
        Assert.Equal(seat.Station.Store.Content(detail.Stored.Correction.ProgramSha256!), detail.Lines!.Modified.ToArray());
        Assert.Equal(detail.Lines.Count, plot.Picture!.Program.Count);

        seat.Type("program-find", "N160").Tap("program-find-down");
        Assert.StartsWith("N160 ", ((ProgramLine)list.SelectedItem!).Modified, StringComparison.Ordinal);
        Assert.Equal(BlockRange.Between(list.SelectedIndex, list.SelectedIndex), plot.Picture.Selection);
        Assert.Null(seat.Find("program-not-found"));
        seat.Type("program-find", "G99999").Tap("program-find-up");
        Assert.Equal("It is in neither program.", seat.TextOf("program-not-found"));
        Assert.StartsWith("N160 ", ((ProgramLine)list.SelectedItem!).Modified, StringComparison.Ordinal);

        // What is tapped in the path is lit in the text, and seen there.
        var motion = plot.Picture.Program.Path.Motions.Length - 1;
        plot.Picture.LightMotion(motion);
        seat.User.Settle();
        Assert.Equal(plot.Picture.Program.Path.Motions.BlockOf(motion), list.SelectedIndex);
        Assert.NotNull(list.ContainerFromIndex(list.SelectedIndex));

        // A job that cannot be read any more leaves the text.
        File.WriteAllText(seat.Station.Settings.Jobs[0].File, "{");
        var without = new CorrectionDetail(detail.Stored, TimeProvider.System);
        Assert.Null(without.PictureAsync().GetAwaiter().GetResult());
    });

    [Fact]
    public void Without_a_seat_the_picture_is_that_of_the_key_points()
    {
        var report = SampleReport.Of(j => j);
        var piece = StoredPiece.Predicted(
            new(1, CorrectionState.Proposed, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1), report);
        Assert.NotNull(GapDrawing.AtSeat(piece, report.Pair, report.Verdict.Worst));
        Assert.Null(GapDrawing.AtSeat(piece, null, report.Verdict.Worst));
        Assert.Null(GapDrawing.AtSeat(piece, report.Pair! with { Gaps = [] }, null));
        Assert.Null(GapDrawing.AtSeat(piece, report.Pair, null)!.Worst);
    }

    // "Worst" is false of a place if another one may be further off.
    [Fact]
    public void The_worst_place_is_the_one_of_which_the_most_must_be_feared()
    {
        var verdict = SampleReport.Of(j => j).Verdict;
        var (point, between) = (verdict.Worst! with { MatingErrorMm = -0.02, Interval95Mm = 0.01 }, verdict.WorstBetween!);
        Assert.Same(point, Farthest(point, between with { MatingErrorMm = 0.01, Interval95Mm = 0.0199 }));
        var further = between with { MatingErrorMm = 0.01, Interval95Mm = 0.0201 };
        Assert.Same(further, Farthest(point, further));
        var unknown = between with { MatingErrorMm = 0, Interval95Mm = null, IsKnown = false };
        Assert.Same(unknown, Farthest(point, unknown));
        Assert.Equal($"least known: {unknown.Feature}", MatchVerdictText.At(unknown));
        Assert.Same(point, Farthest(point, null));
        Assert.Null(Farthest(null, null));

        ErrorLeft? Farthest(ErrorLeft? worst, ErrorLeft? between) =>
            MatchVerdictText.Farthest(verdict with { Worst = worst, WorstBetween = between });
    }

    // A proof that fails is said in the head, although the rest of the proof is among the details.
    [Fact]
    public void What_is_not_proved_is_said_first()
    {
        var correction = new Correction(
            1, CorrectionState.Proposed, 1, "cmm", "part-0001.csv", DateTimeOffset.UnixEpoch, new string('0', 64), 1);
        var report = SampleReport.Of(j => j);
        Assert.False(new CorrectionDetail(new(correction, [], report, null), TimeProvider.System).IsDisproved);
        var detail = new CorrectionDetail(
            new(correction, [], report with { Proof = report.Proof with { Holds = false } }, null), TimeProvider.System);
        Assert.Equal((true, Severity.Alarm), (detail.IsDisproved, detail.VerdictSeverity));
        Assert.Equal("The proof of the program does not hold. Do not use it.", detail.Verdict);
        Assert.Contains(detail.Facts, f => f.Severity == Severity.Alarm && f.Text == detail.Proof);
    }

    // What is drawn of a program that is understood in part would look like all of it.
    [Fact]
    public void A_path_that_ends_where_the_program_is_not_understood_is_not_drawn_as_the_whole()
    {
        const string Cut = "G17 G90 G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X10\n";
        Assert.NotEmpty(SurfacePath.Of(Encoding.ASCII.GetBytes(Cut + "M30\n"), NcDialects.FanucMill).Passes);
        Assert.Throws<InputException>(() => SurfacePath.Of(Encoding.ASCII.GetBytes(Cut + "GOTO 99\nM30\n"), NcDialects.FanucMill));
        Assert.NotNull(
            OpenedProgram.Read(
                Encoding.ASCII.GetBytes(Cut + "GOTO 99\nM30\n"), NcDialects.FanucMill, TestContext.Current.CancellationToken).Problem);
    }

    private static CorrectionDetail Arrive(Seat seat)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        return ((CompensationViewModel)seat.Shell.Current!).Detail!;
    }
}
