using ErrorMatching.Json;

namespace ErrorMatching.Cell.Tests;

/// <summary>What the verification of a store says of contents that are in archives.</summary>
public sealed class CheckedArchivesTests : PeopleTest
{
    [Fact]
    public void Archives_that_are_there_are_checked_and_of_the_others_nothing_is_claimed()
    {
        var name = Thinned();
        var file = PathOf("cell.db.archives/" + name);
        var whole = new AuditTrail(Store, Keys).Verify();
        Assert.True(whole.Holds, whole.Message);
        Assert.Equal([new(name, true, 3)], whole.Archives);
        Assert.EndsWith("as they were written.", whole.Message, StringComparison.Ordinal);
        Assert.Equal(1, whole.Contents);

        File.Move(file, PathOf("elsewhere"));
        var away = new AuditTrail(Store, Keys).Verify();
        Assert.True(away.Holds, away.Message);
        Assert.Equal([new(name, false, 3)], away.Archives);
        Assert.EndsWith(
            $" 3 contents are in archives that are not here, and were not looked at: {name}.", away.Message, StringComparison.Ordinal);

        // One bit of a content, and a content that is not in it.
        byte[] bytes = File.ReadAllBytes(PathOf("elsewhere"));
        var at = bytes.AsSpan().IndexOf("second"u8);
        Assert.True(at > 0);
        bytes[at] ^= 1;
        File.WriteAllBytes(file, bytes);
        Assert.Equal(
            RecordedThinning.Lacks.With(ContentHash.Sha256("second"u8), name), new AuditTrail(Store, Keys).Verify().Fault!.Statement);
        File.WriteAllText(file, "no archive");
        Assert.Contains(name, new AuditTrail(Store, Keys).Verify().Fault!.Message, StringComparison.Ordinal);
        File.Move(PathOf("elsewhere"), file, overwrite: true);
        Assert.True(new AuditTrail(Store, Keys).Verify().Holds);
    }

    [Fact]
    public async Task An_archive_that_is_not_there_is_a_trouble_of_the_cell()
    {
        await using var cell = new RunningCell();
        Assert.Empty(Store.MissingArchives());
        var name = Thinned();
        Assert.Empty(Store.MissingArchives());
        var flow = new CellFlow(cell.Settings, Store, Clock, Serilog.Core.Logger.None, new(), CancellationToken.None);
        var worker = new RecordWorker(flow);
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        Assert.Empty(flow.Troubles.Open);

        File.Move(PathOf("cell.db.archives/" + name), PathOf("elsewhere"));
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        var trouble = Assert.Single(flow.Troubles.Open);
        Assert.Equal(("archives", "store-archived"), (trouble.Where, trouble.Code));
        Assert.Contains(name, trouble.Message, StringComparison.Ordinal);
        Assert.Equal([trouble.Message], Store.MissingArchives());

        File.Move(PathOf("elsewhere"), PathOf("cell.db.archives/" + name));
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        Assert.Empty(flow.Troubles.Open);
    }

    // Somebody who can write the store, and says that a content is somewhere else.
    [Theory]
    [InlineData("contents-0123456789abcdef.db")]
    [InlineData("../../etc/passwd")]
    [InlineData(null)]
    public void A_row_that_names_an_archive_which_the_trail_does_not_know_is_a_fault(string? other)
    {
        var name = Thinned();
        var hash = ContentHash.Sha256("kept"u8);
        Store.Database.Change((connection, transaction) => Sql.Execute(
            connection,
            "UPDATE content SET bytes = X'', form = 'archive', length = 4, source = @source WHERE sha256 = @hash",
            [("hash", hash), ("source", other ?? name)],
            transaction));

        // The known one has three contents, by the trail, and not four.
        var fault = new AuditTrail(Store, Keys).Verify().Fault!;
        Assert.Equal(AuditFaultKind.RowDiffers, fault.Kind);
        Assert.Contains(other ?? name, fault.Message, StringComparison.Ordinal);
        Assert.Equal(
            other is null ? StoreError.Damaged : StoreError.Archived, Assert.Throws<StoreException>(() => Store.Content(hash)).Error);
    }

    // Three refused files from years ago, and one of today.
    private string Thinned()
    {
        Refuse("first"u8.ToArray());
        Refuse("second"u8.ToArray());
        var c = Store.Archive(new Arrival("gauge", "one.csv", "one", "third"u8.ToArray())).Correction;
        c = Store.Step(c, CorrectionState.Recognized, "cell", "by name", x => x with { Job = "job", Machine = "mill", Slot = "1" });
        Store.Step(c, CorrectionState.Refused, "cell", "no", x => x with { Code = "no", Reason = "no" });
        Clock.Pass(TimeSpan.FromDays(800));
        c = Store.Archive(new Arrival("gauge", "now.csv", "now", "kept"u8.ToArray())).Correction;
        c = Store.Step(c, CorrectionState.Recognized, "cell", "by name", x => x with { Job = "job", Machine = "mill", Slot = "1" });
        Store.Step(c, CorrectionState.Refused, "cell", "no", x => x with { Code = "no", Reason = "no" });
        return Store.Thin(new(Clock.GetUtcNow().AddYears(-2), 1), "os:test", null, TestContext.Current.CancellationToken).Archives.Single();

        void Refuse(byte[] bytes) => Store.Step(
            Store.Archive(new Arrival("gauge", "x.csv", Convert.ToHexString(bytes), bytes)).Correction,
            CorrectionState.Refused,
            "cell",
            "unknown",
            x => x with { Code = "unknown-piece", Reason = "unknown" });
    }
}
