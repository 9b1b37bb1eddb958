using System.Text;
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

        cell.DropText("f_cp_2.csv", Counterpart + "\n");
        var second = await feedback.Until(4, CorrectionState.Verified);
        Assert.Equal(first.ProgramSha256, second.BaseSha256);

        // The normal of the displaced path is another one by a little, and its corners lie a little beyond the ends that were measured.
        Assert.InRange(second.SumMm!.Value / first.SumMm.Value, 1.99, 2.03);
        var sums = CorrectionSums.FromJson(feedback.Store.Content(second.SumsSha256!));
        Assert.InRange(sums.Largest!.LengthMm, 0.2, second.SumMm.Value);
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
        cell.DropText("f_cp_2.csv", Counterpart + "\n");
        Assert.Equal("over-sum-limit", (await feedback.Until(3, CorrectionState.Refused)).Code);
        Assert.Equal(feedback.Store.Find(2)!.ProgramSha256, RunningCell.Hash(cell.Machine["m1"].Files[RunningCell.Program]));
    }

    /// <summary>A cell with one feedback job that accumulates, in the folders of another rig.</summary>
    private sealed class FeedbackCell : IAsyncDisposable
    {
        private readonly RunningCell _cell;
        private readonly CellSettings _settings;
        private readonly CancellationTokenSource _stop = new();
        private Task _run = Task.CompletedTask;

        public FeedbackCell(RunningCell cell, double sumLimitMm = 5)
        {
            _cell = cell;
            File.WriteAllText(cell.PathOf("job/feedback.json"), File.ReadAllText(cell.PathOf("job/feedback.json")).Replace(
                "\"alignment\"",
                """
                "recognition": { "part": [{ "in": "file-name", "pattern": "_part" }], "counterpart": [{ "in": "file-name", "pattern": "_cp" }] },
                  "alignment"
                """,
                StringComparison.Ordinal)

                // What was corrected lies away from the drawing by the sum of corrections.
                .Replace("\"mapMm\": 0.5", "\"mapMm\": 3", StringComparison.Ordinal));
            _settings = CellSettingsReader.Parse(
                Encoding.UTF8.GetBytes(FormattableString.Invariant($$"""
                {
                  "kind": "cell", "name": "Feedback", "store": { "kind": "sqlite", "file": "feedback.db" }, "keys": "keys", "logs": "logs",
                  "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename", "everyMs": 20 }],
                  "machines": [{ "name": "m1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "m1" }, "slots": [{ "name": "A", "program": "P1.NC" }] }],
                  "jobs": [{ "name": "f", "job": "job/feedback.json", "gauges": ["cmm"], "recognize": { "fileName": "^f_" }, "machine": "m1", "slot": "A", "accumulates": true }],
                  "policy": { "approve": "automatic", "sumLimitMm": {{sumLimitMm}} }
                }
                """)),
                cell.PathOf("feedback-cell.json"));
            Store = CellStore.Open(_settings.Store, TimeProvider.System);
        }

        public CellStore Store { get; }

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
