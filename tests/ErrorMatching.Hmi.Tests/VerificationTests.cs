using System.Globalization;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi.Tests;

[Trait("Length", "Long")]
public sealed class VerificationTests
{
    // The station reads reports: errors below 1 mm and normals, each coordinate rounded to the ninth decimal, so half of 1e-9 off.
    // Four of these make an error along the normal.
    private const double RoundedMm = 2e-9;

    private static readonly string[] Sides = ["errors", "assembly", "improvement", "trend", "error-points", "piece-details"];

    [Fact]
    public Task What_a_measured_counterpart_shows_is_what_the_console_says_of_the_same_files() => Seat.AtAsync(seat =>
    {
        var console = Console();
        seat.Cell.Run();
        CutAndMeasure(seat, 1, 0);
        seat.SignIn(DemoCell.Operator).Tap("nav-verification").See("piece-title");
        var detail = ((VerificationViewModel)seat.Shell.Current!).Detail!;
        Assert.Equal(("#1 · 0001", "Measured"), (seat.TextOf("piece-title"), seat.TextOf("piece-kind")));
        seat.Tap("tab-piece-details");
        Assert.Equal(
            "With compensation: as measured on #2 · 0001. Without: the uncompensated counterpart that the job names, as measured in "
                + "counterpart.csv.",
            seat.TextOf("piece-origin"));
        Assert.Equal(
            $"Better by {Shown.Percent(100 * (1 - (console.Result.RmsAfterMm / console.Result.RmsBeforeMm)))}: root mean square "
                + $"{Shown.Mm(console.Result.RmsBeforeMm)} → {Shown.Mm(console.Result.RmsAfterMm)}\u00a0mm, largest error "
                + $"{Shown.Mm(console.Result.MaxBeforeMm)} → {Shown.Mm(console.Result.MaxAfterMm)}\u00a0mm.",
            seat.TextOf("piece-summary"));

        Assert.Equal(
            console.Result.Points.Select(p => (p.Label, Shown.SignedMm(p.BeforeError.NormalMm), Shown.SignedMm(p.AfterError.NormalMm))),
            detail.Points.Select(p => (p.Point, p.Before, p.After)));
        Assert.Equal(
            console.Result.Features.Select(
                f => (
                    f.Name,
                    Shown.Mm(f.After).TrimStart('−'),
                    f.ImprovementPercent < -0.5
                        ? "Worse by " + Shown.Percent(-f.ImprovementPercent)
                        : Shown.Percent(f.ImprovementPercent))),
            detail.Features.Select(f => (f.Feature, f.After.TrimStart('+', '−'), f.Improvement)));

        // Deviations have their sign and are the counterpart's alone; the paper's comparison in x leaves out point 5,
        // where the curve is furthest off.
        Assert.All(
            detail.Features, f => Assert.Equal(f.Quantity.StartsWith("largest", StringComparison.Ordinal), f.Wanted == Shown.Nothing));
        var (curve, comparison) = (
            detail.Features.Single(f => f.Feature == "C1" && f.Quantity == "largest in X"),
            detail.Features.Single(f => f.Feature == "C1 in x"));
        Assert.Equal(Shown.SignedMm(console.Result.Points.Single(p => p.Label == "5").AfterError.Vector.X), curve.After);
        Assert.Equal("largest in X, points 6..14", comparison.Quantity);
        Assert.Equal(Shown.SignedMm(console.Result.Points.Skip(7).Select(p => p.AfterError.Vector.X).MaxBy(Math.Abs)), comparison.After);
        Assert.Contains(detail.Features, f => f.Before.StartsWith('−'));
        seat.Tap("tab-improvement").See("improvement-note");

        // The paper's improvement, through the whole cell.
        Assert.Equal("81 %", detail.Features.Single(f => f.Feature == "L1-L2").Improvement);
        Assert.Equal(
            console.Result.Points.Select(p => p.AfterError.NormalMm),
            detail.Errors.Lines.Single(l => l.Kind == SeriesKind.After).Values.Select(v => v!.Value),
            (one, other) => Math.Abs(one - other) < RoundedMm);

        // A line leads along a feature and not on to the next one.
        Assert.Equal(
            ["2a", "5"], detail.Errors.Beginnings.Where(b => b < detail.Points.Count).Order().Select(b => detail.Errors.Labels[b]));

        // The job allows 0.05 mm to either side; the paper's corner is off by 0.391.
        Assert.All(detail.Points, p => Assert.Equal(("−0.0500", "+0.0500"), (p.Low, p.High)));
        Assert.True(detail.Points.Single(p => p.Point == "4").IsOutside);
        Assert.Equal(console.Result.Points.Count(p => Math.Abs(p.AfterError.NormalMm) > 0.05), detail.Points.Count(p => p.IsOutside));
        Assert.StartsWith(
            $"{detail.Points.Count(p => p.IsOutside)} of 16 points are outside ±0.05: points "
                + $"{detail.Points.First(p => p.IsOutside).Point}, ",
            seat.TextOf("piece-verdict"),
            StringComparison.Ordinal);
        Assert.EndsWith(
            "Risk that a point is outside its limits: more than 99.9 %.", seat.TextOf("piece-verdict"), StringComparison.Ordinal);
        Assert.Equal(Severity.Alarm, detail.Severity);

        // What the match predicted is missed where the counterpart lies elsewhere by more than twice the gauge's 5.4 um,
        // which the job states.
        using var match = System.Text.Json.JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        var predicted = match.RootElement.GetProperty("keyPoints")
            .EnumerateArray()
            .ToDictionary(p => p.GetProperty("point").GetString()!, p => p.GetProperty("predictedMm").GetDouble());
        var missed = console.Result.Points.Select(p => (p.Label, Mm: Math.Abs(p.AfterError.NormalMm - predicted[p.Label])))
            .Where(p => p.Mm > 0.0108)
            .ToArray();
        var worst = missed.MaxBy(p => p.Mm);
        Assert.True(missed.Length > 6);
        Assert.DoesNotContain("Hollow", detail.TrendCaption, StringComparison.Ordinal);
        seat.Tap("tab-piece-details");
        Assert.Equal(
            $"Prediction missed by more than twice the gauge's standard uncertainty: {missed.Length} "
                + $"({string.Join(", ", missed.Take(6).Select(p => p.Label))} …); largest miss {Shown.Mm(worst.Mm)}\u00a0mm at "
                + $"{worst.Label}.",
            seat.TextOf("piece-missed"));
        var outside = detail.Points.Where(p => p.IsOutside).Select(p => p.Point).Intersect(missed.Select(p => p.Label));
        Assert.Equal(
            $"Someone must decide whether to use this piece; the station does not. Before the next one, find out why "
                + $"{string.Join(", ", outside)} did not match the prediction: clamping, worn tool, chip under the probe.",
            seat.TextOf("piece-to-do"));
    });

    [Fact]
    public Task Until_a_counterpart_is_measured_the_prediction_is_shown_and_gives_way_by_itself() =>
        Seat.AtAsync(prepare: WantedGap.In, test: seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Setter).Tap("nav-verification");
        Assert.NotNull(seat.See("verification-empty"));
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(() => seat.Find("piece-kind") is not null, "The piece does not appear by itself.");
        Assert.Equal("Predicted", seat.TextOf("piece-kind"));
        using var report = System.Text.Json.JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        var detail = ((VerificationViewModel)seat.Shell.Current!).Detail!;
        Assert.Equal(
            report.RootElement.GetProperty("keyPoints")
                .EnumerateArray()
                .Select(
                    p => (
                        Shown.SignedMm(p.GetProperty("uncompensatedMm").GetDouble()),
                        Shown.SignedMm(p.GetProperty("predictedMm").GetDouble(), p.GetProperty("interval95Mm").GetDouble()))),
            detail.Points.Select(p => (p.Before, p.After)));

        Assert.Equal(WantedGap.Outside, detail.Points.Where(p => p.IsOutside).Select(p => p.Point));
        Assert.Equal("2 points outside their limits: 1, 2. Within limits without compensation: 2.", seat.TextOf("piece-verdict"));
        seat.Tap("tab-piece-details");
        Assert.StartsWith("Expected to be better by ", seat.TextOf("piece-summary"), StringComparison.Ordinal);

        // It is shown as soon as it is computed, and put forward a moment later.
        seat.WaitFor(
            () => seat.TextOf("piece-to-do")?.StartsWith(
                "Before cutting, read the warnings of the correction: 1, 2 will stay outside. Next: ", StringComparison.Ordinal) is true,
            "What to do is not said.");
        Assert.Null(seat.Find("piece-missed"));

        // A tap leads to those warnings, and they are what is seen.
        seat.Tap("piece-warnings").See("warnings");
        Assert.Equal(("#1 · 0001", ScreenKeys.Compensation), (seat.TextOf("detail-title"), seat.Shell.Chosen!.Screen.Key));
        seat.Tap("nav-verification").See("piece-kind");

        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.DeliverCounterpart(1, 0);
        seat.WaitFor(() => seat.TextOf("piece-kind") == "Measured", "The measured counterpart is not shown by itself.");
        Assert.Equal("#1 · 0001", seat.TextOf("piece-title"));
    });

    [Fact]
    public Task Each_piece_is_a_place_of_the_trend_in_order_and_a_chosen_one_stays() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        CutAndMeasure(seat, 1, 0);
        seat.Cell.FinishPiece();
        seat.WaitFor(1, CorrectionState.Released);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(3, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-verification").See("piece-title");

        // What is measured says more than what is predicted, though that is newer.
        Assert.Equal(("#1 · 0001", "Measured"), (seat.TextOf("piece-title"), seat.TextOf("piece-kind")));
        var screen = (VerificationViewModel)seat.Shell.Current!;
        var trend = screen.Detail!.Trend;
        Assert.Equal(["0001", "0002"], trend.Labels);
        Assert.Equal([false, true], trend.IsHollow);

        // Hollow marks are explained where there are any.
        Assert.Contains("Hollow marks: predicted.", screen.Detail.TrendCaption, StringComparison.Ordinal);
        Assert.Equal(Console().Result.RmsAfterMm, trend.Lines.Single(l => l.Kind == SeriesKind.AfterMean).Values[0]!.Value, RoundedMm);
        Assert.Equal(Console().Result.MaxBeforeMm, trend.Lines.Single(l => l.Kind == SeriesKind.Before).Values[0]!.Value, RoundedMm);

        // One is told from the counterpart that the job names, the other from the one as designed: no line leads from one to the other.
        Assert.Equal(["1", "", "1", ""], trend.Lines.Select(l => string.Join(' ', l.Beginnings)));
        Assert.EndsWith("\nwithout: counterpart.csv, as measured", trend.Values[0], StringComparison.Ordinal);
        Assert.EndsWith("\nwithout: as designed", trend.Values[1], StringComparison.Ordinal);
        seat.Tap("tab-trend");
        Assert.EndsWith(
            "The “without” lines break where they start to refer to another counterpart. Tap a piece to see which one.",
            seat.TextOf("trend-caption"),
            StringComparison.Ordinal);
        Assert.Equal(
            [false, true],
            new[] { SeriesKind.Before, SeriesKind.After }.Select(k => IsJoined(seat, (SeriesPlot)seat.See("plot-trend"), 0, k)));
        seat.Tap("piece-3");
        seat.WaitFor(() => seat.TextOf("piece-title") == "#3 · 0002", "The chosen one is not shown.");
        seat.Cell.Deliver(3, 0.02);
        seat.WaitFor(() => seat.Find("piece-4") is not null, "The next one is not listed.");
        Assert.Equal("#3 · 0002", seat.TextOf("piece-title"));
    });

    [Fact]
    public Task Exact_values_are_under_the_finger_and_one_looks_closer() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        CutAndMeasure(seat, 1, 0);
        seat.SignIn(DemoCell.Operator).Tap("nav-verification").Tap("tab-errors").See("plot-errors");
        var plot = (SeriesPlot)seat.See("plot-errors");
        var places = plot.Drawing!.Lines.SelectMany(l => l.Values.Select((v, i) => plot.View.ToScreen(new(i, v ?? 0))));
        Assert.All(
            places,
            p => Assert.True(plot.Inside.Deflate(5).Contains(new Avalonia.Point(p.X, p.Y)), $"A mark at {p} is cut off at {plot.Inside}."));

        // Between the last point of a feature and the first one of the next nothing is drawn, and between two of the same something is.
        Assert.Equal([true, false, true], new[] { 0, 1, 2 }.Select(i => IsJoined(seat, plot, i)));
        var row = ((VerificationViewModel)seat.Shell.Current!).Detail!.Points[6];
        var at = plot.View.ToScreen(new(6, 0));
        seat.User.Click(plot, new(at.X + 3, at.Y - 20));
        Assert.Equal(
            $"Point {row.Point}\nwithout {row.Before}\u00a0mm\nwith {row.After}\u00a0mm\nlimits −0.0500 to +0.0500\u00a0mm", plot.Values);
        var scale = plot.View.ScaleX;

        // The axis says its unit; what is drawn ends before the buttons.
        Assert.All(["mm", "+0.2", "−0.4", "0"], w => Assert.Contains(w, Words(plot)));
        Assert.True(plot.Inside.Right <= Avalonia.VisualExtensions.TranslatePoint(seat.See("plot-errors-nearer"), default, plot)!.Value.X);
        seat.Tap("tab-trend");
        var trend = Words((SeriesPlot)seat.See("plot-trend"));
        Assert.All(["mm", "0.10", "0.50", "0"], w => Assert.Contains(w, trend));
        Assert.DoesNotContain(trend, w => w.StartsWith('+'));
        seat.Tap("tab-errors").See("plot-errors");
        seat.Tap("plot-errors-nearer");
        Assert.True(plot.View.ScaleX > scale);

        // So near, the limits have room on the axis between its numbers.
        Assert.All(["mm", "+0.05", "−0.05", "+0.10", "−0.30", "0"], w => Assert.Contains(w, Words(plot)));
        seat.User.Press(Avalonia.Input.Key.Tab);
        plot.Focus();
        seat.User.Press(Avalonia.Input.Key.PageDown);
        Assert.StartsWith(
            $"Point {((VerificationViewModel)seat.Shell.Current!).Detail!.Points[7].Point}\n", plot.Values, StringComparison.Ordinal);
    });

    [Fact]
    public Task Nothing_is_cut_off() => Seat.AtAsync(seat =>
    {
        var pictures = new Pictures(seat);
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator).WaitFor(() => seat.Shell.Banner is null, "The cell is not seen to run.");
        seat.Tap("nav-verification").See("verification-empty");
        pictures.Take("verification-empty", isPictured: false);
        CutAndMeasure(seat, 1, 0);
        for (var serial = 2; serial <= 3; serial++)
        {
            seat.Cell.FinishPiece();
            seat.WaitFor((2 * serial) - 3, CorrectionState.Released);
            CutAndMeasure(seat, serial, 0.01);
        }

        seat.WaitFor(
            () => seat.TextOf("piece-title") == "#5 · 0003" && seat.TextOf("piece-kind") == "Measured", "The last piece is not shown.");
        pictures.Take("verification");
        foreach (var side in Sides)
        {
            seat.Tap("tab-" + side);
            pictures.Take("verification-" + side, isPictured: false);
        }

        pictures.MustBeClean();
    });

    [Fact]
    public Task What_became_worse_is_said_in_words_and_stands_out() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);

        // As if the counterpart had slipped by a millimeter.
        var lines = File.ReadAllLines(Path.Combine(AppContext.BaseDirectory, "samples", "complex-mating", "counterpart.csv"))
            .Select(l => l.Split(','))
            .ToArray();
        var slipped = lines.Skip(1).Select(l => string.Create(
            CultureInfo.InvariantCulture, $"{l[0]},{double.Parse(l[1], CultureInfo.InvariantCulture) - 1:0.0000},{l[2]}"));
        var outside = Path.Combine(seat.Cell.MachineFolder, "counterpart-0001.csv");
        File.WriteAllLines(outside, slipped.Prepend(string.Join(',', lines[0])));
        File.Move(outside, Path.Combine(seat.Station.Settings.Gauges[0].Incoming!, "counterpart-0001.csv"));
        seat.WaitFor(2, CorrectionState.Recorded);

        seat.SignIn(DemoCell.Operator).Tap("nav-verification").Tap("tab-improvement").See("improvements");
        var result = ((VerificationViewModel)seat.Shell.Current!).Detail!.Features;
        Assert.Contains(result, f => f.IsWorse);
        Assert.StartsWith("Worse by ", seat.TextOf("piece-worse"), StringComparison.Ordinal);
        Assert.Contains("attention", seat.See("piece-worse").Classes);
        Assert.All(result, f => Assert.Equal(f.IsWorse, f.Improvement.StartsWith("Worse by ", StringComparison.Ordinal)));
        Assert.All(
            Percents(), t => Assert.Equal(t.Text!.StartsWith("Worse by ", StringComparison.Ordinal), t.Classes.Contains("attention")));
        Assert.DoesNotContain(Percents(), t => t.Text!.Contains('−', StringComparison.Ordinal));
        seat.Tap("language").WaitFor(
            () => Percents().Any(t => t.Text!.StartsWith("變差 ", StringComparison.Ordinal) && t.Classes.Contains("attention")),
            "It is not said in Chinese.");

        IEnumerable<TextBlock> Percents() => seat.See("improvements")
            .GetVisualDescendants()
            .OfType<TextBlock>()
            .Where(t => t.Text?.EndsWith(" %", StringComparison.Ordinal) == true);
    });

    private static HashSet<string> Words(SeriesPlot plot) => [.. ((IDrawnWords)plot).DrawnWords.Select(d => d.Words)];

    // What the verb verify of the console calls, of the sample's files.
    // Something in the color of a line in the middle between a place and the next.
    private static bool IsJoined(Seat seat, SeriesPlot plot, int place, SeriesKind kind = SeriesKind.After)
    {
        var color = ((Avalonia.Media.ISolidColorBrush)(kind == SeriesKind.After ? plot.AfterBrush : plot.BeforeBrush)!).Color;
        var x = plot.View.ToScreen(new(place + 0.5, 0)).X;
        return Enumerable.Range((int)plot.Inside.Top, (int)plot.Inside.Height).Any(
            y => Avalonia.VisualExtensions.TranslatePoint(plot, new(x, y), seat.Window)!.Value is var at
            && seat.User.PixelAt(new((int)at.X, (int)at.Y)) is var p
                && Math.Abs(p.R - color.R) + Math.Abs(p.G - color.G) + Math.Abs(p.B - color.B) < 12);
    }

    private static VerifyReport Console()
    {
        var folder = Path.Combine(AppContext.BaseDirectory, "samples", "complex-mating");
        var files = new JobFiles(Path.Combine(folder, "job.json"));
        var part = files.Part(null);
        var (program, bytes) = files.Program(null);
        return VerifyRun.Report(
            new(
                files.Job,
                files.Theoretical(),
                part,
                files.Counterpart(new(Path.Combine(folder, "counterpart.csv")), part),
                files.Counterpart(new(Path.Combine(folder, "counterpart-after.csv")), part),
                program,
                bytes),
            out _)!;
    }

    // A part is measured, its counterpart is cut and measured: corrections 2 n - 1 and 2 n.
    private static void CutAndMeasure(Seat seat, int serial, double spread)
    {
        seat.Cell.Deliver(serial, spread);
        seat.WaitFor((2 * serial) - 1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve((2 * serial) - 1, DemoCell.Setter, null);
        seat.WaitFor((2 * serial) - 1, CorrectionState.Verified);
        seat.Cell.DeliverCounterpart(serial, spread);
        seat.WaitFor(2 * serial, CorrectionState.Recorded);
    }
}
