using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class CellRunnerTests
{
    private static readonly CorrectionState[] WholeWay =
    [
        CorrectionState.Archived, CorrectionState.Recognized, CorrectionState.Computed, CorrectionState.Proposed, CorrectionState.Approved,
        CorrectionState.Uploading, CorrectionState.Verified,
    ];

    [Fact]
    public async Task A_file_becomes_the_machines_program_step_by_step()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var verified = await cell.Until(1, CorrectionState.Verified);
        Assert.Equal(WholeWay, cell.Way(1));
        var program = cell.Machine["m1"].Files[RunningCell.Program];
        Assert.Equal(verified.ProgramSha256, RunningCell.Hash(program));
        Assert.Contains(
            $"ERRORMATCH MEASUREMENT={verified.MeasurementSha256[..16].ToUpperInvariant()}",
            Encoding.ASCII.GetString(program),
            StringComparison.Ordinal);
        Assert.Equal(
            ("a", "part", "S1", "m1", "A", cell.OriginalHash),
            (verified.Job, verified.Piece, verified.Serial, verified.Machine, verified.Slot, verified.BaseSha256));
        Assert.Null(verified.SumsSha256);
        Assert.Equal(1, cell.Store.Slot("m1", "A").Correction);
        Assert.Empty(Directory.EnumerateFiles(cell.PathOf("incoming")));
        Assert.Equal([RunningCell.Program], cell.Machine["m1"].Files.Keys);
    }

    [Fact]
    public async Task The_program_before_is_kept_before_it_is_overwritten()
    {
        await using var cell = new RunningCell();
        var original = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        cell.Machine["m1"].Files[RunningCell.Program] = original;
        cell.Machine["m1"].Around = (what, isDone) => Assert.True(
            isDone
                || what != "rename " + RunningCell.Program
                || cell.Store.Content(cell.Store.Find(1)!.PreviousSha256!).AsSpan().SequenceEqual(original));
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        Assert.Equal(cell.OriginalHash, (await cell.Until(1, CorrectionState.Verified)).PreviousSha256);
    }

    [Fact]
    public async Task A_slot_holds_one_program_until_an_operator_releases_it_and_then_takes_the_next_from_the_original()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Approved);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(2)!.State);
        using var elsewhere = cell.Open();
        new CorrectionDecisions(elsewhere).Release(1, "olga", null);
        var second = await cell.Until(2, CorrectionState.Verified);
        Assert.Equal((cell.OriginalHash, cell.Store.Find(1)!.ProgramSha256), (second.BaseSha256, second.PreviousSha256));
        Assert.Equal(CorrectionState.Released, cell.Store.Find(1)!.State);
    }

    [Fact]
    public async Task A_ready_file_releases_the_program_that_was_verified_and_is_removed()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        cell.Machine["m1"].Files["B.READY"] = [];
        await cell.Until(1, CorrectionState.Released);
        await RunningCell.Until(() => !cell.Machine["m1"].Files.ContainsKey("B.READY"));
        Assert.Null(cell.Store.Slot("m1", "B").Correction);
        Assert.Contains("B.READY", cell.Store.Corrections.StepsOf(1)[^1].Basis.Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_ready_file_that_is_older_than_the_program_releases_nothing()
    {
        await using var cell = new RunningCell();
        cell.Machine["m1"].Files["B.READY"] = [];
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        Assert.False(cell.Machine["m1"].Files.ContainsKey("B.READY"));
        await cell.UntilListedAgain("m1");
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
    }

    [Fact]
    public async Task What_a_person_must_approve_waits_for_it()
    {
        await using var cell = new RunningCell(policy: """{ "approve": "person" }""");
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        await cell.UntilLookedAgain("approval", "slot m1/A");
        Assert.Equal(CorrectionState.Proposed, cell.Store.Find(1)!.State);
        using var elsewhere = cell.Open();
        new CorrectionDecisions(elsewhere).Approve(1, "sam", "looks right");
        await cell.Until(1, CorrectionState.Verified);
        Assert.Contains(("sam", "looks right"), cell.Store.Corrections.StepsOf(1).Select(s => (s.By, s.Basis.Sentence)));
    }

    [Fact]
    public async Task What_a_person_rejects_is_never_sent_and_the_line_goes_on()
    {
        await using var cell = new RunningCell(policy: """{ "approve": "person" }""");
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        cell.Drop("a_S2.csv", 2);
        await RunningCell.Until(() => cell.Store.Corrections.InState(CorrectionState.Proposed).Count == 2);
        using var elsewhere = cell.Open();
        var decisions = new CorrectionDecisions(elsewhere);
        decisions.Approve(2, "sam", null);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(2)!.State);
        decisions.Reject(1, "sam", "measured dirty");
        await cell.Until(2, CorrectionState.Verified);
        Assert.Equal(
            (CorrectionState.Rejected, "rejected", "measured dirty"), cell.Store.Find(1) is { } r ? (r.State, r.Code, r.Reason) : default);
        Assert.DoesNotContain(CorrectionState.Uploading, cell.Way(1));
    }

    [Fact]
    public async Task The_same_measurement_again_is_refused_and_names_the_other()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        cell.Drop("a_S1_again.csv", 1);
        var again = await cell.Until(2, CorrectionState.Refused);
        Assert.Equal("already-known", again.Code);
        Assert.Contains("Correction 1 (a_S1.csv, verified)", again.Reason!.Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_that_no_job_takes_is_refused()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("stranger.csv", 1);
        Assert.Equal("unknown-piece", (await cell.Until(1, CorrectionState.Refused)).Code);
    }

    [Fact]
    public async Task What_was_refused_may_come_again_when_the_reason_is_gone()
    {
        await using var cell = new RunningCell(policy: """{ "approve": "automatic", "limitMm": 0.001 }""");
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        Assert.Equal("over-limit", (await cell.Until(1, CorrectionState.Refused)).Code);
        await cell.StopAsync();
        cell.Policy = """{ "approve": "automatic", "limitMm": 0.5 }""";
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(2, CorrectionState.Verified);
    }

    [Fact]
    public async Task A_measured_first_article_is_recorded_and_sends_nothing()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.DropText("first-article.csv", File.ReadAllText(cell.PathOf("job/counterpart.csv")));
        Assert.Equal("first-article", (await cell.Until(1, CorrectionState.Recorded)).Code);
        Assert.Empty(cell.Machine["m2"].Files);
    }

    [Fact]
    public async Task A_newer_measurement_takes_the_place_of_one_that_is_not_sent_yet()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S0.csv", 0);
        await cell.Until(1, CorrectionState.Verified);
        cell.Drop("a_S1.csv", 1);
        await cell.Until(2, CorrectionState.Approved);
        cell.Drop("a_S1_again.csv", 2);
        await cell.Until(3, CorrectionState.Approved);
        Assert.Equal((CorrectionState.Superseded, "superseded"), cell.Store.Find(2) is { } s ? (s.State, s.Code) : default);
        using var elsewhere = cell.Open();
        new CorrectionDecisions(elsewhere).Release(1, "olga", null);
        await cell.Until(3, CorrectionState.Verified);

        // What was sent stays; the newer one waits in line.
        cell.Drop("a_S1_third.csv", 3);
        await cell.Until(4, CorrectionState.Approved);
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(3)!.State);
    }

    [Fact]
    public async Task Pieces_go_by_serial_number_where_the_job_says_so()
    {
        await using var cell = new RunningCell(order: "serial");
        cell.Start();
        cell.Drop("a_S99.csv", 0);
        await cell.Until(1, CorrectionState.Verified);
        foreach (var (serial, number) in new[] { ("S10", 1), ("S9", 2), ("S11", 3) })
        {
            cell.Drop($"a_{serial}.csv", number);
            await cell.Until(number + 1, CorrectionState.Approved);
        }

        using var elsewhere = cell.Open();
        var decisions = new CorrectionDecisions(elsewhere);
        foreach (var (released, next) in new[] { (1, 3), (3, 2), (2, 4) })
        {
            decisions.Release(released, "olga", null);
            await cell.Until(next, CorrectionState.Verified);
        }
    }

    [Fact]
    public async Task Pieces_go_in_order_of_arrival_otherwise()
    {
        await using var cell = new RunningCell();
        cell.Start();
        foreach (var (serial, number) in new[] { ("S99", 0), ("S10", 1), ("S9", 2) })
        {
            cell.Drop($"a_{serial}.csv", number);
            await RunningCell.Until(() => cell.Store.Find(number + 1)?.State is CorrectionState.Approved or CorrectionState.Verified);
        }

        using var elsewhere = cell.Open();
        var decisions = new CorrectionDecisions(elsewhere);
        foreach (var (released, next) in new[] { (1, 2), (2, 3) })
        {
            decisions.Release(released, "olga", null);
            await cell.Until(next, CorrectionState.Verified);
        }
    }

    [Fact]
    public async Task Two_runners_on_one_store_send_each_program_once()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Start();
        foreach (var number in Enumerable.Range(1, 6))
        {
            cell.Drop($"{"abc"[number % 3]}_S{number}.csv", number);
        }

        await RunningCell.Until(
            () => cell.Store.Corrections.InState(CorrectionState.Verified).Count == 3,
            () => string.Join("\n", Enumerable.Range(1, 6).Select(i => cell.Store.Find(i))));
        await RunningCell.Until(() => cell.Store.Corrections.InState(CorrectionState.Approved).Count == 3);
        Assert.All(Enumerable.Range(1, 6), id => Assert.Equal(cell.Way(id).Distinct(), cell.Way(id)));
        Assert.Equal(2, cell.Machine["m1"].Done.Count(d => d.StartsWith("rename P", StringComparison.Ordinal)));
        Assert.Single(cell.Machine["m2"].Done, d => d.StartsWith("rename P", StringComparison.Ordinal));
        Assert.Null(cell.Store.VerifyAudit());
    }

    [Fact]
    public async Task A_cell_leaves_files_and_jobs_of_another_cell_on_the_same_store_alone()
    {
        await using var cell = new RunningCell();
        var other = cell.Store.Archive(new(
            "another gauge", "a_S9.csv", "key", Encoding.UTF8.GetBytes(RunningCell.Measurement(9)))).Correction;
        var job = cell.Store.Archive(new(
            "another gauge", "x_S8.csv", "key 2", Encoding.UTF8.GetBytes(RunningCell.Measurement(8)))).Correction;
        cell.Store.Step(
            job,
            CorrectionState.Recognized,
            "cell",
            "by another cell",
            c => c with { Job = "another job", Piece = "part", Machine = "m9", Slot = "A" });
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(3, CorrectionState.Verified);
        await cell.UntilLookedAgain("recognition", "computing 1", "computing 2", "approval");
        Assert.Equal(
            (CorrectionState.Archived, CorrectionState.Recognized), (cell.Store.Find(other.Id)!.State, cell.Store.Find(job.Id)!.State));
    }
}
