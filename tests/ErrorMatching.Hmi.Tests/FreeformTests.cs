using System.Text.Json;
using Avalonia;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

public sealed class FreeformTests
{
    private static readonly string[] Sides = ["solid", "compare", "surface-errors", "statistics", "plan", "finishing", "surface-details"];
    private static readonly string Job = Path.Combine(AppContext.BaseDirectory, "samples", "surface-one", "job.json");

    [Fact]
    public Task Before_anything_is_measured_the_plan_is_shown_and_a_measured_surface_takes_its_place_by_itself() => Seat.AtAsync(seat =>
    {
        var files = new FreeformFiles(Job);
        var plan = files.Plan(files.Surface());
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator).Tap("nav-freeform").See("plan");
        Assert.NotNull(seat.Find("freeform-empty"));
        Assert.Equal(
            $"{plan.Points.Count} points on {plan.Curves} curves; the stylus travels "
                + $"{Shown.Count((long)Math.Round(plan.TravelMm))}\u00a0mm.",
            seat.TextOf("plan-caption"));
        var drawing = ((SurfacePlot)seat.See("plan")).Drawing!;
        Assert.Equal(plan.Points.Select(p => (p.Position.X, p.Position.Y)), drawing.Points.Select(p => (p.At.X, p.At.Y)));
        Assert.Equal(
            $"Point 3\nx {Shown.Mm(plan.Points[2].Position.X)}\u00a0mm\ny {Shown.Mm(plan.Points[2].Position.Y)}\u00a0mm\nz "
                + $"{Shown.Mm(plan.Points[2].Position.Z)}\u00a0mm",
            drawing.Points[2].Values);
        var plot = (SurfacePlot)seat.See("plan");
        var third = plot.View.ToScreen(drawing.Points[2].At);
        seat.User.Click(plot, new(third.X + 3, third.Y - 2));
        Assert.Equal(drawing.Points[2].Values, plot.Values);

        // In another language it does not go away and come back.
        var screen = (FreeformViewModel)seat.Shell.Current!;
        var english = screen.Plan;
        Texts.Current.Language = Language.TraditionalChinese;
        Assert.Same(english, screen.Plan);
        seat.WaitFor(
            () => seat.TextOf("plan-caption")!.Contains($"共 {plan.Points.Count} 點", StringComparison.Ordinal),
            $"It says {seat.TextOf("plan-caption")}.");
        Texts.Current.Language = Language.English;
        seat.WaitFor(
            () => screen.Plan is not null && seat.TextOf("plan-caption")!.Contains("points on", StringComparison.Ordinal),
            "The plan stays in Chinese.");

        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(() => seat.Find("surface-title") is not null, "The measured surface does not appear by itself.");
        Assert.Equal("#1 · 0001", seat.TextOf("surface-title"));
        Assert.Null(seat.Find("plan"));

        // What waits for a person looks so in this list too, and where it is chosen.
        var icon = seat.See("surface-1").GetVisualDescendants().OfType<Avalonia.Controls.Shapes.Path>().Single();
        Assert.Equal(Application.Current!.FindResource(seat.Window.ActualThemeVariant, "Attention"), icon.Stroke);
    });

    [Fact]
    public Task Every_figure_is_that_of_the_console_for_the_same_files() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        var correction = seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-freeform").See("surface-title");
        var figures = ((FreeformViewModel)seat.Shell.Current!).Detail!.Figures;

        // What the verb surface compensate of the console calls.
        var console = SurfaceRun.Compensate(
            new(Job),
            new() { Measured = [new(Path.Combine(Path.GetDirectoryName(Job)!, "measured.csv"))] },
            CancellationToken.None).Result!;
        var result = console.Report.Result;
        Assert.Equal(seat.Station.Store.Content(correction.ProgramSha256!), console.Program.ToArray());
        Assert.Equal(
            new[]
            {
                result.Before,
                result.Mirror.Statistics,
                result.ToolRadius.Statistics
            }.Select(
                s => (
                    Shown.SignedMicrometers(s.MeanMm),
                    Shown.Micrometers(s.StandardDeviationMm),
                    Shown.Micrometers(s.ProfileIsoMm),
                    Shown.Micrometers(s.ProfileRangeMm))),
            figures.Statistics.Select(s => (s.Mean, s.Deviation, s.Profile, s.Range)));
        Assert.Equal(["As measured", "Expected, mirrored – chosen", "Expected, tool radius"], figures.Statistics.Select(s => s.Name));
        Assert.Equal(
            result.Samples.Select(s => $"Point {s.Point}\nmeasured {Shown.SignedMicrometers(s.ErrorMm)}\u00a0µm"),
            figures.Measured.Points.Select(p => p.Values));
        Assert.Equal(
            result.ToolRadius.Errors.Select(e => Math.Round(e, 9)),
            figures.ToolRadius.Points.Zip(
                result.ToolRadius.Errors,
                (p, e) => p.Values.EndsWith($" {Shown.SignedMicrometers(e)}\u00a0µm", StringComparison.Ordinal)
                    ? Math.Round(e, 9)
                    : double.NaN));
        var map = ErrorMap.Of(result);
        Assert.All(map.BeforeMm.Zip(figures.Measured.ValuesMm!), v => Assert.Equal(v.First, v.Second, 1e-11));
        Assert.All(map.ToolRadiusMm.Zip(figures.ToolRadius.ValuesMm!), v => Assert.Equal(v.First, v.Second, 1e-11));
        Assert.True(figures.LimitMm >= result.Samples.Max(s => Math.Abs(s.ErrorMm)));

        var path = console.Report.ToolPath;
        seat.Tap("tab-finishing").See("finishing-program");
        Assert.StartsWith(
            $"{Shown.Count(path.Passes)} passes of {Shown.Count(path.Points)} points, ",
            seat.TextOf("surface-proof"),
            StringComparison.Ordinal);
        Assert.Equal(
            $"FINISH.MPF: {Shown.Count(Nc.NcProgram.Read(console.Program).BlockCount)} blocks, {Shown.Count(console.Program.Length)} bytes",
            seat.TextOf("program-size"));
    });

    // The sample's job states 0.02 mm.
    [Fact]
    public Task The_verdict_is_the_first_line_in_both_languages_and_what_is_signed_for() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-freeform").See("surface-title");
        Assert.StartsWith("Expected in tolerance: profile ", seat.TextOf("surface-verdict"), StringComparison.Ordinal);
        Assert.EndsWith("\u00a0µm. Cut it.", seat.TextOf("surface-verdict"), StringComparison.Ordinal);
        Assert.True(Top("surface-verdict") < Top("surface-title"));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(
            () => seat.TextOf("surface-verdict")!.StartsWith("預期符合公差：輪廓度", StringComparison.Ordinal),
            $"It says {seat.TextOf("surface-verdict")}.");
        Texts.Current.Language = Language.English;
        seat.Tap("nav-compensation").See("detail-verdict");
        var detail = ((CompensationViewModel)seat.Shell.Current!).Detail!;
        Assert.StartsWith("Expected in tolerance: profile ", detail.Verdict, StringComparison.Ordinal);
        Assert.Equal((new Fact(detail.Verdict!, Severity.Quiet), true), (detail.Facts[0], detail.IsWithin));

        double Top(string id) => seat.See(id).TransformToVisual(seat.Window)!.Value.Transform(default).Y;
    });

    [Fact]
    public Task The_compensation_shows_a_surface_too() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("detail-map");
        using var report = JsonDocument.Parse(seat.Station.Store.Content(seat.Station.Store.Find(1)!.ReportSha256!));
        var before = report.RootElement.GetProperty("before");

        // The colors are told together with the maps, without scrolling.
        var (legend, scroll) = (seat.See("detail-legend"), seat.See("surface-scroll"));
        Assert.True(
            new Rect(scroll.Bounds.Size).Contains(new Rect(legend.Bounds.Size).TransformToAABB(legend.TransformToVisual(scroll)!.Value)),
            "The legend is below the edge.");
        Assert.Null(seat.Find("tab-points"));
        seat.Tap("tab-decisions").See("detail-surface-summary");
        Assert.StartsWith(
            $"Standard deviation {Shown.Micrometers(before.GetProperty("standardDeviationUm").GetDouble() / 1000)}\u00a0µm, expected ",
            seat.TextOf("detail-surface-summary"),
            StringComparison.Ordinal);
        Assert.Contains("Chordal error at most", seat.TextOf("detail-proof"), StringComparison.Ordinal);

        // One unit for one quantity: what the program is displaced by is said in mm wherever it stands.
        var largest = Shown.Mm(seat.Station.Store.Find(1)!.LargestMm);
        Assert.Contains(
            $"by at most {largest}\u00a0mm", ((CompensationViewModel)seat.Shell.Current!).Detail!.Surface!.How, StringComparison.Ordinal);
        Assert.StartsWith($"Largest displacement {largest}\u00a0mm at ", seat.TextOf("detail-largest"), StringComparison.Ordinal);
        Assert.False(seat.Find("detail-missing") is { IsEffectivelyVisible: true });
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(() => seat.TextOf("detail-largest") is "最大位移 0.0248\u00a0mm，位於 點 9 及其附近", $"It says {seat.TextOf("detail-largest")}.");
        Texts.Current.Language = Language.English;

        // A mating behind it has its own sides again.
        seat.Tap("tab-surface");
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(() => seat.Find("correction-2") is not null, "The part is not listed.");
        seat.Tap("correction-2").See("pair");
        Assert.Null(seat.Find("tab-surface"));
        Assert.False(seat.Find("detail-missing") is { IsEffectivelyVisible: true });
    });

    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task What_is_not_needed_to_decide_is_under_the_details(Language language) => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-freeform").See("map");
        Texts.Current.Language = language;
        string[] ids = ["surface-summary", "surface-tolerance", "surface-how", "surface-origin"];
        Assert.All(ids, id => Assert.Null(seat.Find(id)));
        seat.Tap("tab-surface-details");
        seat.WaitFor(() => ((FreeformViewModel)seat.Shell.Current!).Detail!.Language == language, "It stays in the other language.");
        var detail = ((FreeformViewModel)seat.Shell.Current!).Detail!;
        Assert.Equal(
            [detail.Figures.Summary, detail.Figures.Tolerance, detail.Figures.How, detail.Origin], ids.Select(id => seat.TextOf(id)));

        // An icon at the side's name only if there is a warning.
        Assert.Equal(detail.Figures.HasWarnings, seat.Find("surface-warnings") is not null);
    });

    // The job of this cell names no tool: its program stops with an alarm, and wherever it is looked at that is said first,
    // in both languages.
    [Fact]
    public Task A_program_without_a_tool_call_is_said_to_stop_before_anything_else() => Seat.AtAsync(seat =>
    {
        var job = Path.Combine(Path.GetDirectoryName(seat.Cell.Settings.File)!, "..", "surface-one", "job.json");
        const string tool = ", \"tool\": { \"number\": 3, \"lengthOffset\": 1 } }";
        Assert.Contains(tool, File.ReadAllText(job), StringComparison.Ordinal);
        File.WriteAllText(job, File.ReadAllText(job).Replace(tool, " }", StringComparison.Ordinal));
        seat.Cell.Run();
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-freeform").See("surface-title");
        Assert.StartsWith("The program calls no tool and stops with an alarm", seat.TextOf("surface-missing"), StringComparison.Ordinal);
        Assert.True(Top("surface-missing") < Top("map"));
        Assert.Empty(((FreeformViewModel)seat.Shell.Current!).Detail!.Figures.Warnings);
        seat.Tap("nav-compensation").See("detail-map");
        Assert.StartsWith("The program calls no tool and stops with an alarm", seat.TextOf("detail-missing"), StringComparison.Ordinal);
        Assert.True(Top("detail-missing") < Top("detail-map"));
        Texts.Current.Language = Language.TraditionalChinese;
        seat.WaitFor(
            () => seat.TextOf("detail-missing")!.StartsWith("程式沒有換刀指令，會以警報停止", StringComparison.Ordinal),
            $"It says {seat.TextOf("detail-missing")}.");
        Texts.Current.Language = Language.English;

        double Top(string id) => seat.See(id).TransformToVisual(seat.Window)!.Value.Transform(default).Y;
    });

    [Fact]
    public Task A_surface_that_is_chosen_after_a_mating_is_drawn() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        seat.Tap("tab-gap").Tap("correction-2").WaitFor(() => seat.TextOf("detail-title") == "#2 · 0001", "The surface is not shown.");
        var map = (SurfacePlot)seat.See("detail-map");
        seat.WaitFor(() => map is { Drawing: not null, Caption.Length: > 0 }, "The surface stays empty.");
        Assert.Equal(((CompensationViewModel)seat.Shell.Current!).Detail!.Surface!.Measured, map.Drawing);
    });

    [Fact]
    public Task A_job_whose_surface_is_gone_is_said() => Seat.AtAsync(seat =>
    {
        File.Delete(Path.Combine(Path.GetDirectoryName(seat.Cell.Settings.File)!, "..", "surface-one", "surface.igs"));
        seat.SignIn(DemoCell.Operator).Tap("nav-freeform").See("freeform-message");
        Assert.Contains("surface.igs", seat.TextOf("freeform-message"), StringComparison.Ordinal);
    });

    [Fact]
    public Task Nothing_is_cut_off() => Seat.AtAsync(seat =>
    {
        var pictures = new Pictures(seat);
        seat.Cell.Run();
        seat.SignIn(DemoCell.Setter).WaitFor(() => seat.Shell.Banner is null, "The cell is not seen to run.");
        seat.Tap("nav-freeform").See("plan");
        pictures.Take(
            "freeform-empty",
            isPictured: false,
            settled: () => seat.TextOf("plan-caption")!.Contains(
                Texts.Current.Language == Language.English ? "stylus" : "測", StringComparison.Ordinal));
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.See("surface-title");
        bool IsTranslated() => ((FreeformViewModel)seat.Shell.Current!).Detail!.Language == Texts.Current.Language;
        seat.WaitFor(() => seat.See("freeform-approve").IsEffectivelyEnabled, "The pause does not end.");
        pictures.Take("freeform", settled: IsTranslated);
        foreach (var side in Sides)
        {
            seat.Tap("tab-" + side);

            // Two of them are in the manual.
            pictures.Take("freeform-" + side, isPictured: side is "compare" or "solid", settled: IsTranslated);
        }

        seat.Tap("nav-compensation").See("detail-map");
        pictures.Take("compensation-surface", isPictured: false);
        pictures.MustBeClean();
    });
}
