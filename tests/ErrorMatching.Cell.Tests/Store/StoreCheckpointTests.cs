namespace ErrorMatching.Cell.Tests;

/// <summary>A process that begins goes on from the checkpoint of the audit trail. With it, somebody
/// who can write the store, but lacks the key, gets nothing sent that the whole trail would not send; nor does setting the store back, or
/// parts of it, get anything sent.</summary>
public abstract class StoreCheckpointTests(StoreKind kind) : CheckpointTest(kind)
{
    [Fact]
    public void A_process_that_begins_does_not_read_what_the_checkpoint_covers()
    {
        var (approved, _) = Filled();

        // What was written over an old entry shows whether anybody reads it. The database refuses that, as long as it has its triggers.
        using (var first = NewProcess()) ChangeOldEntry(first);
        using var later = NewProcess();
        Assert.StartsWith("not-sent(form-differs(", Refused(later, approved), StringComparison.Ordinal);
        Assert.Null(later.Outside.WhyWhole);

        Tamper(later, "DELETE FROM audit_checkpoint");
        using var whole = NewProcess();
        Assert.Equal("not-sent(trail-broken(2))", Refused(whole, approved));
    }

    [Fact]
    public void What_is_before_the_checkpoint_is_read_meanwhile_and_nothing_is_sent_once_it_differs()
    {
        var (approved, _) = Filled();
        using (var first = NewProcess()) ChangeOldEntry(first);
        using var later = NewProcess();
        Refused(later, approved);
        Assert.Null(later.Outside.LookBehind(1));
        var found = later.Outside.LookBehind(1);
        Assert.Equal("trail-broken(2)", Stated.As(found));
        Assert.Equal(found, later.Outside.LookBehind(1));
        Assert.Equal("not-sent(trail-broken(2))", Refused(later, approved));

        // It makes no new checkpoint, and the next process reads the whole trail.
        later.Outside.KeepCheckpoint(Stop, 0);
        using var next = NewProcess();
        Assert.Equal("not-sent(trail-broken(2))", Refused(next, approved));
    }

    [Theory]
    [InlineData("UPDATE audit_checkpoint SET state = replace(state, 'proposed', 'approved')")]
    [InlineData("UPDATE audit_checkpoint SET state = ''")]
    [InlineData("UPDATE audit_checkpoint SET seq = seq - 1, hash = (SELECT hash FROM audit WHERE seq = audit_checkpoint.seq - 1)")]
    [InlineData("UPDATE audit_checkpoint SET seq = 999999999")]
    public void A_checkpoint_that_somebody_else_wrote_is_not_used_and_is_found(string sql)
    {
        var (approved, proposed) = Filled();
        using var later = NewProcess();
        Tamper(later, "INSERT INTO content (sha256, bytes) VALUES (@own, @bytes)",
            "UPDATE correction SET state = 'approved', version = version + 1 WHERE id = 2", sql);
        later.Outside.DemandRecorded(approved);
        Assert.True(later.Outside.WhyWhole?.Is(RecordedCheckpoint.Foreign), later.Outside.WhyWhole?.Sentence);
        Assert.StartsWith("not-sent(state-differs(2, approved, ", Refused(later, later.Find(proposed.Id)!), StringComparison.Ordinal);

        Tamper(later, "UPDATE correction SET state = 'proposed', version = version - 1 WHERE id = 2");
        Assert.Equal((AuditFaultKind.RowDiffers, true), FaultOfCheckpoint(later) is { } fault
            ? (fault.Kind, fault.Statement.Is(RecordedCheckpoint.Foreign)) : default);

        // The next one that the cell makes holds again.
        later.Outside.KeepCheckpoint(Stop, 0);
        Assert.Null(FaultOfCheckpoint(later));
        using var next = NewProcess();
        next.Outside.DemandRecorded(approved);
        Assert.Null(next.Outside.WhyWhole);
    }

    [Fact]
    public void An_earlier_checkpoint_that_is_put_back_with_the_rows_of_then_sends_nothing()
    {
        var (approved, _) = Filled();
        using var store = NewProcess();
        var (then, code) = (Kept(store), store.Read("SELECT row_code FROM correction WHERE id = 1", r => r.GetString(0))[0]);
        store.Step(approved, CorrectionState.Rejected, "cell", "dirty");
        store.Outside.KeepCheckpoint(Stop, 0);
        Assert.NotEqual(then, Kept(store));
        then.Keep(store.Database, AuditKey);
        Tamper(store, $"UPDATE correction SET state = 'approved', version = version - 1, changed_at = "
            + $"{CodedRow.Number(StoredTime.Of(approved.ChangedAt))}, row_code = '{code}' WHERE id = 1");
        using var later = NewProcess();
        Assert.Equal(approved, later.Find(1));
        Assert.StartsWith("not-sent(state-differs(1, approved, ", Refused(later, approved), StringComparison.Ordinal);
        Assert.Null(later.Outside.WhyWhole);
    }

    [Fact]
    public void A_checkpoint_beyond_the_end_of_a_store_that_was_set_back_is_not_used()
    {
        var (_, proposed) = Filled();
        using var store = NewProcess();
        var then = store.AuditHead();
        store.Step(proposed, CorrectionState.Approved, "cell", Policy);
        store.Outside.KeepCheckpoint(Stop, 0);
        Tamper(store, Kind.RemoveTriggersSql, $"DELETE FROM audit WHERE seq > {CodedRow.Number(then.Seq)}",
            $"UPDATE audit_head SET seq = {CodedRow.Number(then.Seq)}, hash = '{then.Hash}', seal = '{then.Seal}'");
        using var later = NewProcess();
        Refused(later, later.Find(2)!);
        Assert.True(later.Outside.WhyWhole?.Is(RecordedCheckpoint.Astray));
    }
}
