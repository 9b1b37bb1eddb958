namespace ErrorMatching.Cell.Tests;

/// <summary>A job is changed while corrections wait that were made with it as it was:
/// they are recalculated from the measurements that are kept.</summary>
public sealed class RecalculationTests
{
    private const string ByPerson = """{ "approve": "person" }""";

    [Fact]
    public async Task What_was_made_with_the_job_as_it_was_ends_and_its_measurement_is_computed_with_the_job_as_it_is()
    {
        await using var cell = new RunningCell(ByPerson);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var old = await cell.Until(1, CorrectionState.Proposed);
        Change(cell.PathOf("job/theoretical.csv"));
        var before = cell.Store.ChangeCount();
        var given = Of(cell).Recalculate(1, "olga", "nose was wrong");
        Assert.Equal(
            (2L, CorrectionState.Archived, 1L, "cmm", "a_S1.csv", old.MeasurementSha256),
            (given.Id, given.State, given.MeasuredAs, given.Gauge, given.FileName, given.MeasurementSha256));

        var ended = cell.Store.Find(1)!;
        Assert.Equal((CorrectionState.Superseded, "computed-anew", null), (ended.State, ended.Code, ended.Identity));
        Assert.Equal("computed-anew(2)", Stated.As(ended.Reason));
        Assert.Equal(
            [
                ("olga", "archived", $"file(2, {old.MeasurementSha256})", "given-again(1)"),
                ("olga", "superseded", $"program(1, {old.ProgramSha256})", "computed-anew(2); nose was wrong"),
            ],
            cell.Store.AuditEntries(before, 2).Select(e => (e.Who, e.What, Stated.As(e.Subject), Stated.As(e.Basis))));

        var anew = await cell.Until(2, CorrectionState.Proposed);
        Assert.Equal((old.Job, old.Serial, old.BaseSha256), (anew.Job, anew.Serial, anew.BaseSha256));
        Assert.NotEqual(old.Identity, anew.Identity);
        new CorrectionDecisions(cell.Store).Approve(2, "sam", null);
        await cell.Until(2, CorrectionState.Verified);
        Assert.Equal(await ProgramOfChangedJob(1), RunningCell.Hash(cell.Machine["m1"].Files[RunningCell.Program]));
        Assert.NotEqual(old.ProgramSha256, anew.ProgramSha256);
        Assert.DoesNotContain(CorrectionState.Uploading, cell.Way(1));
        Assert.Null(cell.Store.VerifyAudit());

        // What is at its machine stays there.
        Assert.Equal(DecisionException.WrongState, Refusal(cell, 2).Code);
    }

    [Fact]
    public async Task What_waits_approved_in_line_is_never_sent_and_its_successor_stands_in_its_place()
    {
        await using var cell = new RunningCell();
        cell.Start();
        for (var i = 1; i <= 3; i++)
        {
            cell.Drop($"a_S{i}.csv", i);
            await cell.Until(i, i == 1 ? CorrectionState.Verified : CorrectionState.Approved);
        }

        await cell.StopAsync();
        Change(cell.PathOf("job/theoretical.csv"));
        Of(cell).Recalculate(2, "olga", null);
        new CorrectionDecisions(cell.Store).Release(1, "olga", null);

        // Before anybody has looked at it, it holds its place already.
        Assert.Equal([4L, 3L], cell.Store.Corrections.Line("m1", "A").Select(c => c.Id));
        cell.Start();
        var sent = await cell.Until(4, CorrectionState.Verified);
        Assert.Equal(await ProgramOfChangedJob(2), sent.ProgramSha256);
        Assert.Equal([CorrectionState.Proposed, CorrectionState.Approved, CorrectionState.Superseded], cell.Way(2).TakeLast(3));
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(3)!.State);
        new CorrectionDecisions(cell.Store).Release(4, "olga", null);
        await cell.Until(3, CorrectionState.Verified);
    }

    [Fact]
    public async Task What_failed_at_its_machine_is_recalculated()
    {
        await using var cell = new RunningCell();
        cell.Machine["m1"].Files[RunningCell.Program] = "edited"u8.ToArray();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Failed);
        Change(cell.PathOf("job/theoretical.csv"));
        Of(cell).Recalculate(1, "olga", null);

        // What somebody changed at the machine is looked at by a person all the same.
        Assert.Equal("changed-at-machine", (await cell.Until(2, CorrectionState.Failed)).Code);
        new CorrectionDecisions(cell.Store).Approve(2, "sam", null);
        Assert.Equal(await ProgramOfChangedJob(1), (await cell.Until(2, CorrectionState.Verified)).ProgramSha256);
        Assert.Equal(CorrectionState.Superseded, cell.Store.Find(1)!.State);
    }

    [Fact]
    public async Task A_newer_measurement_of_the_piece_counts_although_the_older_one_is_given_again_behind_it()
    {
        await using var cell = new RunningCell(ByPerson);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var old = await cell.Until(1, CorrectionState.Proposed);
        await cell.StopAsync();
        Change(cell.PathOf("job/theoretical.csv"));
        cell.Store.Archive(new("cmm", "a_S1_again.csv", "newer", System.Text.Encoding.UTF8.GetBytes(RunningCell.Measurement(2))));
        Assert.Equal(3, Of(cell).Recalculate(old.Id, "olga", null).Id);
        cell.Start();
        await cell.Until(2, CorrectionState.Proposed);
        Assert.Equal("superseded", (await cell.Until(3, CorrectionState.Superseded)).Code);
        Assert.Equal(CorrectionState.Proposed, cell.Store.Find(2)!.State);
    }

    [Fact]
    public async Task Without_a_serial_number_a_counterpart_is_compared_with_the_part_that_it_was_compared_with()
    {
        await using var cell = PairedCell.Of(accumulates: false, new("m1"));
        cell.Configuration = cell.Configuration.Replace("automatic", "person", StringComparison.Ordinal);
        cell.Start();
        cell.Drop("part.csv", PairedCell.Part);
        var part = await cell.Until(1, CorrectionState.Recorded);
        cell.Drop("cp.csv", PairedCell.Counterpart);
        Assert.Null((await cell.Until(2, CorrectionState.Proposed)).Serial);
        cell.Drop("part_next.csv", PairedCell.Part + "\n");
        await cell.Until(3, CorrectionState.Recorded);
        Change(cell.PathOf("job/theoretical.csv"));
        Assert.Equal(4, new Recalculation(cell.Settings, cell.Store).Recalculate(2, "olga", null).Id);
        Assert.Equal(part.MeasurementSha256, (await cell.Until(4, CorrectionState.Proposed)).PartSha256);
        Assert.Equal(CorrectionState.Superseded, cell.Store.Find(2)!.State);

        // Once more: the second change is another job again.
        Change(cell.PathOf("job/theoretical.csv"), "-31.951", "-31.952");
        Assert.Equal(
            (5L, 2L),
            (
                new Recalculation(cell.Settings, cell.Store).Recalculate(4, "olga", null) is var twice
                    ? (twice.Id, twice.MeasuredAs!.Value)
                    : default));
        Assert.Equal(part.MeasurementSha256, (await cell.Until(5, CorrectionState.Proposed)).PartSha256);

        // And back to what it was in the beginning.
        Change(cell.PathOf("job/theoretical.csv"), "-31.952", "-31.950");
        new Recalculation(cell.Settings, cell.Store).Recalculate(5, "olga", null);
        Assert.Equal(cell.Store.Find(2)!.ProgramSha256, (await cell.Until(6, CorrectionState.Proposed)).ProgramSha256);
    }

    [Fact]
    public async Task Where_corrections_add_up_the_piece_was_cut_by_the_program_that_cut_it_whatever_was_sent_since()
    {
        await using var cell = PairedCell.Of(accumulates: true, new("m1"));
        cell.Configuration = cell.Configuration.Replace("automatic", "person", StringComparison.Ordinal);
        var decisions = new CorrectionDecisions(cell.Store);
        cell.Start();
        cell.Drop("part.csv", PairedCell.Part);
        await cell.Until(1, CorrectionState.Recorded);
        cell.Drop("cp_1.csv", PairedCell.Counterpart);
        await cell.Until(2, CorrectionState.Proposed);
        decisions.Approve(2, "sam", null);
        var cut = await cell.Until(2, CorrectionState.Verified);
        decisions.Release(2, "olga", null);
        for (var id = 3; id <= 4; id++)
        {
            cell.Drop($"cp_{id}.csv", PairedCell.Counterpart + new string('\n', id));
            Assert.Equal(cut.ProgramSha256, (await cell.Until(id, CorrectionState.Proposed)).BaseSha256);
        }

        // Another program is at the machine by then, and nobody has said yet that its piece is cut.
        decisions.Approve(3, "sam", null);
        await cell.Until(3, CorrectionState.Verified);
        Change(cell.PathOf("job/theoretical.csv"));
        Assert.Equal(5, new Recalculation(cell.Settings, cell.Store).Recalculate(4, "olga", null).Id);
        var anew = await cell.Until(5, CorrectionState.Proposed);
        Assert.Equal((cut.ProgramSha256, cut.PartSha256), (anew.BaseSha256, anew.PartSha256));

        // Twice the same error, not three times.
        Assert.InRange(anew.SumMm!.Value / cut.SumMm!.Value, 1.99, 2.03);
        decisions.Approve(5, "sam", null);
        decisions.Release(3, "olga", null);
        await cell.Until(5, CorrectionState.Verified);
    }

    [Fact]
    public async Task Where_corrections_add_up_the_first_one_starts_from_the_original_as_it_is_now()
    {
        await using var cell = PairedCell.Of(accumulates: true, new("m1"));
        cell.Configuration = cell.Configuration.Replace("automatic", "person", StringComparison.Ordinal);
        cell.Start();
        cell.Drop("part.csv", PairedCell.Part);
        await cell.Until(1, CorrectionState.Recorded);
        cell.Drop("cp.csv", PairedCell.Counterpart);
        await cell.Until(2, CorrectionState.Proposed);
        await File.AppendAllTextAsync(cell.PathOf("job/counterpart.nc"), "\n", TestContext.Current.CancellationToken);
        var original = RunningCell.Hash(
            await File.ReadAllBytesAsync(cell.PathOf("job/counterpart.nc"), TestContext.Current.CancellationToken));
        Assert.Equal([2L], new ChangedJobs(cell.Settings).Among(cell.Store, [cell.Store.Find(2)!]));
        new Recalculation(cell.Settings, cell.Store).Recalculate(2, "olga", null);
        Assert.Equal(original, (await cell.Until(3, CorrectionState.Proposed)).BaseSha256);
    }

    [Fact]
    public async Task What_would_be_the_same_or_is_at_its_machine_stays_as_it_is()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Approved);
        cell.DropText("a_S3.csv", "point,x_mm,y_mm\n1,0,0\n");
        await cell.Until(3, CorrectionState.Refused);
        await cell.StopAsync();
        var before = cell.Store.ChangeCount();
        Assert.Equal(DecisionException.JobUnchanged, Refusal(cell, 2).Code);
        Assert.Equal(DecisionException.UnknownCorrection, Refusal(cell, 9).Code);

        var theoretical = await File.ReadAllTextAsync(cell.PathOf("job/theoretical.csv"), TestContext.Current.CancellationToken);
        Change(cell.PathOf("job/theoretical.csv"));
        Assert.Equal(
            "Correction 1 is verified, and only one that is proposed or approved or failed can be recalculated.",
            Refusal(cell, 1).Message);
        Assert.Equal(DecisionException.WrongState, Refusal(cell, 3).Code);

        await File.WriteAllTextAsync(cell.PathOf("job/theoretical.csv"), "nothing", TestContext.Current.CancellationToken);
        Assert.Equal(DecisionException.JobUnusable, Refusal(cell, 2).Code);

        await File.WriteAllTextAsync(cell.PathOf("job/theoretical.csv"), theoretical, TestContext.Current.CancellationToken);
        Change(cell.PathOf("job/theoretical.csv"));
        var settings = cell.Settings;
        foreach (var other in new[] { settings with { Jobs = [] }, settings with { Gauges = [] } })
        {
            var refusal = Assert.Throws<DecisionException>(() => new Recalculation(other, cell.Store).Recalculate(2, "olga", null));
            Assert.Equal(DecisionException.JobUnusable, refusal.Code);
            Assert.Contains(other.Jobs.Count == 0 ? " job \"a\"" : " gauge \"cmm\"", refusal.Message, StringComparison.Ordinal);
        }

        Assert.Equal(before, cell.Store.ChangeCount());
    }

    [Fact]
    public async Task What_was_measured_again_with_the_job_as_it_is_now_is_not_computed_a_second_time()
    {
        await using var cell = new RunningCell(ByPerson);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Proposed);
        Change(cell.PathOf("job/theoretical.csv"));
        cell.Drop("a_S1B.csv", 1);
        await cell.Until(2, CorrectionState.Proposed);
        var refusal = Refusal(cell, 1);
        Assert.Equal("already-known", refusal.Code);
        Assert.StartsWith("Correction 2 ", refusal.Message, StringComparison.Ordinal);
        Assert.Equal(CorrectionState.Proposed, cell.Store.Find(1)!.State);
    }

    [Fact]
    public async Task Of_several_who_do_it_at_once_one_does_it()
    {
        await using var cell = new RunningCell(ByPerson);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var old = await cell.Until(1, CorrectionState.Proposed);
        await cell.StopAsync();
        Change(cell.PathOf("job/theoretical.csv"));
        var settings = cell.Settings;
        var stores = Enumerable.Range(0, 4).Select(_ => cell.Open()).ToArray();
        using var start = new Barrier(stores.Length);
        var codes = await Task.WhenAll(stores.Select((store, i) => Task.Factory.StartNew(
            () =>
            {
                start.SignalAndWait();
                try
                {
                    return new Recalculation(settings, store).Recalculate(1, $"olga {i}", null).Id.ToString(
                        System.Globalization.CultureInfo.InvariantCulture);
                }
                catch (DecisionException e)
                {
                    return e.Code;
                }
            },
            TestContext.Current.CancellationToken,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default)));
        Assert.Single(codes, "2");
        Assert.All(
            codes.Where(c => c != "2"), c => Assert.True(c is DecisionException.ChangedMeanwhile or DecisionException.WrongState, c));
        Assert.Null(cell.Store.Find(3));

        // Whoever looked before and comes afterwards.
        Assert.Equal(StoreError.Conflict, Assert.Throws<StoreException>(() => cell.Store.Recalculate(old, "sam", null)).Error);
        Assert.Null(cell.Store.Find(3));
    }

    private static Recalculation Of(RunningCell cell) => new(cell.Settings, cell.Store);

    private static DecisionException Refusal(RunningCell cell, long id) =>
        Assert.Throws<DecisionException>(() => Of(cell).Recalculate(id, "olga", null));

    // What a cell computes that never knew the job as it was.
    private static async Task<string> ProgramOfChangedJob(int measurement)
    {
        await using var cell = new RunningCell(ByPerson);
        Change(cell.PathOf("job/theoretical.csv"));
        cell.Start();
        cell.Drop("a_X.csv", measurement);
        return (await cell.Until(1, CorrectionState.Proposed)).ProgramSha256!;
    }

    private static void Change(string file, string was = "-31.950", string now = "-31.951")
    {
        var text = File.ReadAllText(file);
        Assert.Equal(2, text.Split(was).Length);
        File.WriteAllText(file, text.Replace(was, now, StringComparison.Ordinal));
    }
}
