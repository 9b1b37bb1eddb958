using System.Text;
using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class AccumulatingTests
{
    private static readonly string Counterpart = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "counterpart.csv"));

    [Fact]
    public async Task Corrections_that_accumulate_start_from_the_program_that_cut_the_piece_and_keep_their_sums()
    {
        await using var cell = new RunningCell();
        await using var feedback = new FeedbackCell(cell);
        feedback.Start();
        cell.Drop("f_part.csv", 0);
        Assert.Equal("part-recorded", (await feedback.Until(1, CorrectionState.Recorded)).Code);
        cell.DropText("f_cp_1.csv", Counterpart);
        var first = await feedback.Until(2, CorrectionState.Verified);
        Assert.Equal((cell.OriginalHash, feedback.Store.Find(1)!.MeasurementSha256), (first.BaseSha256, first.PartSha256));
        Assert.Equal(first.LargestMm, first.SumMm);
        Assert.InRange(CorrectionSums.FromJson(feedback.Store.Content(first.SumsSha256!)).Largest!.LengthMm, 0.1, first.SumMm!.Value);
        new CorrectionDecisions(feedback.Store).Release(2, "olga", null);

        // The same measurement again would be added a second time.
        cell.DropText("f_cp_again.csv", Counterpart);
        var again = await feedback.Until(3, CorrectionState.Refused);
        Assert.Equal("already-known", again.Code);

        // One piece that is off by as much again may be a chip; two of them are the process.
        cell.DropText("f_cp_2.csv", NextCounterpart.Of(feedback.Store.Content(first.ReportSha256!), 2, 1));
        var outlier = await feedback.Until(4, CorrectionState.Verified);
        Assert.Equal(first.ProgramSha256, outlier.BaseSha256);
        Assert.InRange(outlier.SumMm!.Value / first.SumMm.Value, 0.8, 1.2);
        Assert.Contains(
            feedback.Store.AuditEntries(0, 1000), e => Stated.As(e.Basis).Contains("lot-outlier(1, ", StringComparison.Ordinal));
        new CorrectionDecisions(feedback.Store).Release(4, "olga", null);
        cell.DropText("f_cp_3.csv", NextCounterpart.Of(feedback.Store.Content(outlier.ReportSha256!), 2, 2));

        // Its verdict does not say to cut it.
        await feedback.Until(5, CorrectionState.Proposed);
        new CorrectionDecisions(feedback.Store).Approve(5, "sam", null);
        var second = await feedback.Until(5, CorrectionState.Verified);
        Assert.Equal(outlier.ProgramSha256, second.BaseSha256);

        // At a point that no corner is near, the sum has grown by what the first counterpart was off: (0.2325, 0.2965) in the sample.
        var (once, twice) = (SumsOf(feedback, first), SumsOf(feedback, second));
        Assert.Equal(0.3768, At3b(twice) - At3b(once), 0.003);
        Assert.InRange(twice.Largest!.LengthMm, 0.2, second.SumMm!.Value);
        Assert.InRange(At3b(SumsOf(feedback, outlier)) - At3b(once), -0.04, 0.04);
    }

    private static CorrectionSums SumsOf(FeedbackCell cell, Correction correction) =>
        CorrectionSums.FromJson(cell.Store.Content(correction.SumsSha256!));

    private static double At3b(CorrectionSums sums) => sums.Points.Single(p => p.Point == "3b").LengthMm;

    // Without the word in its name, the same piece hardly counts (above).
    [Fact]
    public async Task A_changed_tool_is_believed_at_once_if_the_file_says_so()
    {
        await using var cell = new RunningCell();
        await using var feedback = new FeedbackCell(cell);
        feedback.Start();
        cell.Drop("f_part.csv", 0);
        await feedback.Until(1, CorrectionState.Recorded);
        cell.DropText("f_cp_1.csv", Counterpart);
        var first = await feedback.Until(2, CorrectionState.Verified);
        new CorrectionDecisions(feedback.Store).Release(2, "olga", null);
        cell.DropText("f_cp_2_new-tool.csv", NextCounterpart.Of(feedback.Store.Content(first.ReportSha256!), 2, 1));
        var second = await feedback.Until(3, CorrectionState.Proposed);
        var (once, twice) = (SumsOf(feedback, first), SumsOf(feedback, second));
        Assert.Equal(0.3768, At3b(twice) - At3b(once), 0.04);
        using var report = JsonDocument.Parse(feedback.Store.Content(second.ReportSha256!));
        var pieces = report.RootElement.GetProperty("lot").GetProperty("pieces");
        Assert.Equal(
            [false, true],
            pieces.EnumerateArray().Select(p => p.TryGetProperty("toolChanged", out var changed) && changed.GetBoolean()));
    }

    [Fact]
    public async Task A_counterpart_without_its_part_is_refused()
    {
        await using var cell = new RunningCell();
        await using var feedback = new FeedbackCell(cell);
        feedback.Start();
        cell.DropText("f_cp_1.csv", Counterpart);
        Assert.Equal("part-unmeasured", (await feedback.Until(1, CorrectionState.Refused)).Code);
    }

    [Fact]
    public async Task The_sum_is_limited()
    {
        await using var cell = new RunningCell();
        await using var feedback = new FeedbackCell(cell, sumLimitMm: 0.9);
        feedback.Start();
        cell.Drop("f_part.csv", 0);
        await feedback.Until(1, CorrectionState.Recorded);
        cell.DropText("f_cp_1.csv", Counterpart);
        Assert.InRange((await feedback.Until(2, CorrectionState.Verified)).SumMm!.Value, 0.46, 0.9);
        new CorrectionDecisions(feedback.Store).Release(2, "olga", null);
        cell.DropText("f_cp_2.csv", NextCounterpart.Of(feedback.Store.Content(feedback.Store.Find(2)!.ReportSha256!), 2, 1));
        var outlier = await feedback.Until(3, CorrectionState.Verified);
        new CorrectionDecisions(feedback.Store).Release(3, "olga", null);
        cell.DropText("f_cp_3.csv", NextCounterpart.Of(feedback.Store.Content(outlier.ReportSha256!), 2, 2));
        Assert.Equal("over-sum-limit", (await feedback.Until(4, CorrectionState.Refused)).Code);
        Assert.Equal(outlier.ProgramSha256, RunningCell.Hash(cell.Machine["m1"].Files[RunningCell.Program]));
    }

    [Fact]
    public async Task A_surface_goes_on_from_the_report_of_the_program_that_cut_it()
    {
        await using var cell = new RunningCell();
        var text = File.ReadAllText(Repository.PathTo("samples", "surface-one", "job.json"))
            .Replace("\"scallopMm\": 0.001, \"chordMm\": 0.001", "\"scallopMm\": 0.05, \"chordMm\": 0.01", StringComparison.Ordinal)
            .Replace("\"semi-finishing\"", "\"finishing\"", StringComparison.Ordinal);
        File.WriteAllText(cell.PathOf("job/feedback.json"), text);
        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), cell.PathOf("job/surface.igs"));
        var measured = File.ReadAllText(Repository.PathTo("samples", "surface-one", "after.csv"));
        await using var surface = new FeedbackCell(cell, isSurface: true);
        surface.Start();
        cell.DropText("f_1.csv", measured);
        var first = await surface.Until(1, CorrectionState.Verified);
        Assert.Equal(1, Pieces(first));

        // While nobody says that it cut, nobody knows which program cut the next piece.
        cell.DropText("f_2.csv", measured + "\n");
        Assert.Equal("not-released", (await surface.Until(2, CorrectionState.Refused)).Code);
        new CorrectionDecisions(surface.Store).Release(1, "olga", null);
        cell.DropText("f_3.csv", measured + "\n\n");
        var second = await surface.Until(3, CorrectionState.Verified);
        Assert.Equal(2, Pieces(second));
        Assert.NotNull(second.SumsSha256);
        Assert.Equal(first.ReportSha256, CorrectionRequests.OfRecalculation(surface.Store, second, surface.Job).Previous!.Sha256);

        // The same measurement again would count twice.
        new CorrectionDecisions(surface.Store).Release(3, "olga", null);
        cell.DropText("f_4.csv", measured + "\n\n");
        Assert.Equal("already-known", (await surface.Until(4, CorrectionState.Refused)).Code);

        int Pieces(Correction correction)
        {
            using var report = JsonDocument.Parse(surface.Store.Content(correction.ReportSha256!));
            return report.RootElement.GetProperty("lot").GetProperty("pieces").GetArrayLength();
        }
    }

    /// <summary>A cell with one job that accumulates, in the folders of another rig.</summary>
    private sealed class FeedbackCell : IAsyncDisposable
    {
        private readonly RunningCell _cell;
        private readonly CellSettings _settings;
        private readonly CancellationTokenSource _stop = new();
        private Task _run = Task.CompletedTask;

        public FeedbackCell(RunningCell cell, double sumLimitMm = 5, bool isSurface = false)
        {
            _cell = cell;
            if (!isSurface)
            {
                Decide(cell);
            }

            _settings = CellSettingsReader.Parse(
                Encoding.UTF8.GetBytes(FormattableString.Invariant($$"""
                {
                  "kind": "cell", "name": "Feedback", "store": { "kind": "sqlite", "file": "feedback.db" }, "keys": "keys", "logs": "logs",
                  "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename", "everyMs": 20 }],
                  "machines": [{ "name": "m1", "dialect": "{{(isSurface ? "siemens-840d" : "delta-nc300")}}", "transport": { "kind": "folder", "folder": "m1" }, "slots": [{ "name": "A", "program": "{{(isSurface ? "P1.MPF" : "P1.NC")}}" }] }],
                  "jobs": [{ "name": "f", "job": "job/feedback.json", "gauges": ["cmm"], "recognize": { "fileName": "^f_(cp_[0-9]+(?<toolChanged>_new-tool)?)?" }, "machine": "m1", "slot": "A", "accumulates": true }],
                  "policy": { "approve": "automatic", "sumLimitMm": {{sumLimitMm}} }
                }
                """)),
                cell.PathOf("feedback-cell.json"));
            Store = CellStore.Open(_settings.Store, TimeProvider.System);
        }

        private static void Decide(RunningCell cell) =>
            File.WriteAllText(cell.PathOf("job/feedback.json"), File.ReadAllText(cell.PathOf("job/feedback.json")).Replace(
                "\"alignment\"",
                """
                "recognition": { "part": [{ "in": "file-name", "pattern": "_part" }], "counterpart": [{ "in": "file-name", "pattern": "_cp" }] },
                  "alignment"
                """,
                StringComparison.Ordinal)

                // Point 2 is at a corner that the tool leaves round: 0.146 mm stay, and what stays outside its limits waits for a person.
                .Replace("[\"N120\"], \"toleranceMm\": [-0.05, 0.05]", "[\"N120\"], \"toleranceMm\": [-0.2, 0.2]", StringComparison.Ordinal)

                // What was corrected lies away from the drawing by the sum of corrections.
                .Replace("\"mapMm\": 0.5", "\"mapMm\": 3", StringComparison.Ordinal));

        public CellStore Store { get; }

        public CellJobSettings Job => _settings.Jobs[0];

        public void Start() =>
            _run = Task.Run(
                () => new CellRunner(_settings, Store, m => _cell.Machine[m.Name], TimeProvider.System, Serilog.Core.Logger.None)
                {
                    Pace = _cell.Pace
                }.RunAsync(_stop.Token));

        public async Task<Correction> Until(long id, CorrectionState state)
        {
            await RunningCell.Until(() => Store.Find(id)?.State == state, () => $"Correction {id}: {Store.Find(id)}");
            return Store.Find(id)!;
        }

        public async ValueTask DisposeAsync()
        {
            await _stop.CancelAsync();
            await _run;
            Store.Dispose();
            _stop.Dispose();
        }
    }
}
