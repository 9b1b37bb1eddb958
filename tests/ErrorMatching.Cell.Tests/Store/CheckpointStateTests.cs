namespace ErrorMatching.Cell.Tests;

/// <summary>What a checkpoint has: the state of the whole trail, without what nobody may send any more.</summary>
public sealed class CheckpointStateTests() : CheckpointTest(new SqliteKind())
{
    [Fact]
    public void A_trail_that_is_as_written_is_read_to_the_checkpoint_and_no_further()
    {
        var (approved, _) = Filled();
        using var later = NewProcess();
        later.Outside.DemandRecorded(approved);
        for (var i = 0; i < 20; i++) Assert.Null(later.Outside.LookBehind(7));
        later.Outside.DemandRecorded(approved);
    }

    [Fact]
    public void A_checkpoint_of_another_key_is_not_used()
    {
        var (approved, _) = Filled();
        using var later = NewProcess();
        Kept(later).Keep(later.Database, [.. AuditKey.Reverse()]);
        later.Outside.DemandRecorded(approved);
        Assert.True(later.Outside.WhyWhole?.Is(RecordedCheckpoint.Foreign));
    }

    [Fact]
    public void A_checkpoint_of_another_build_is_not_used_and_is_no_fault()
    {
        var (approved, _) = Filled();
        using var later = NewProcess();
        var kept = Kept(later);
        var build = typeof(CellStore).Module.ModuleVersionId.ToString();
        var other = kept with { State = kept.State.Replace(build, Guid.NewGuid().ToString(), StringComparison.Ordinal) };
        Assert.NotEqual(kept, other);
        other.Keep(later.Database, AuditKey);
        later.Outside.DemandRecorded(approved);
        Assert.True(later.Outside.WhyWhole?.Is(RecordedCheckpoint.OfOtherBuild));
        Assert.Null(FaultOfCheckpoint(later));
    }

    [Fact]
    public void A_checkpoint_of_another_store_with_the_same_key_is_not_used()
    {
        var (approved, _) = Filled();
        using var other = CellStore.Open(Kind.NewSettings(), Clock, AuditKey);
        Fill(other);
        other.Audit("cell", "noted", "something else");
        other.Outside.KeepCheckpoint(Stop, 1);
        using var later = NewProcess();
        Kept(other).Keep(later.Database, AuditKey);
        later.Outside.DemandRecorded(approved);
        Assert.True(later.Outside.WhyWhole?.Is(RecordedCheckpoint.Astray), later.Outside.WhyWhole?.Sentence);
        Assert.True(FaultOfCheckpoint(later)?.Statement.Is(RecordedCheckpoint.Astray));
    }

    [Fact]
    public void An_approval_that_was_not_allowed_stays_so_behind_a_checkpoint()
    {
        var (_, proposed) = Filled();
        using var store = NewProcess();
        var approved = store.Step(proposed, CorrectionState.Approved, "eve", "looks right");
        store.Outside.KeepCheckpoint(Stop, 0);
        using var later = NewProcess();
        Assert.Contains("who-was-nobody", Refused(later, approved), StringComparison.Ordinal);
        Assert.Null(later.Outside.WhyWhole);
    }

    [Fact]
    public void Who_may_approve_is_known_behind_a_checkpoint()
    {
        var (_, proposed) = Filled();
        using var store = NewProcess();
        var users = new UserBook(store, Clock, new PasswordHashes(10));
        users.AddFirst("Anna", "correct horse battery");
        users.Add(users.SignIn("Anna", "correct horse battery"), "Ben", Role.Operator, "staple of the ox");
        store.Outside.KeepCheckpoint(Stop, 0);
        using var later = NewProcess();
        var approved = later.Step(proposed, CorrectionState.Approved, "Anna", "looks right");
        later.Outside.DemandRecorded(approved);
        approved = later.Step(later.Step(approved, CorrectionState.Uploading, "cell", "in line"), CorrectionState.Approved, "Ben", "again");
        Assert.Contains("who-was-of-role(operator, ", Refused(later, approved), StringComparison.Ordinal);
        Assert.Null(later.Outside.WhyWhole);
    }

    [Fact]
    public void Only_the_last_program_of_a_slot_is_kept_in_mind_and_the_others_are_looked_up_when_they_are_asked_for()
    {
        using var store = NewProcess();
        var released = Enumerable.Range(0, 5).Select(i => Sent(store, $"piece {i}")).ToArray();
        store.Outside.KeepCheckpoint(Stop, 0);
        var state = Kept(store).State;
        Assert.Equal([5L], released.Where(c => state.Contains(c.ProgramSha256!, StringComparison.Ordinal)).Select(c => c.Id));
        using var later = NewProcess();
        later.Outside.DemandRecorded(released[4]);
        later.Outside.DemandRecorded(released[1]);

        // A step of one that was forgotten: the trail is read again, and says what it always says.
        using var again = NewProcess();
        again.Outside.DemandRecorded(released[4]);
        var reverted = again.Step(released[4], CorrectionState.Reverted, "cell", "chatter");
        again.FreeSlot("mill", "1", 5, "cell", "free");
        Assert.Equal(CorrectionState.Reverted, reverted.State);
        again.Outside.KeepCheckpoint(Stop, 0);
        Assert.DoesNotContain(released[4].ProgramSha256!, Kept(again).State, StringComparison.Ordinal);
        IsWhole(again);
    }

    // The law: whatever was done, and wherever checkpoints were made, the state is that of the whole trail.
    [Theory]
    [InlineData(1), InlineData(2)]
    public void The_state_behind_a_checkpoint_is_that_of_the_whole_trail(int seed)
    {
        var random = new Random(seed);
        var store = NewProcess();
        try
        {
            var users = new UserBook(store, Clock, new PasswordHashes(1));
            users.AddFirst("Anna", "correct horse battery");
            for (var i = 0; i < 80; i++)
            {
                Act(store, random, i);
                if (random.Next(9) > 0) continue;
                store.Outside.KeepCheckpoint(Stop, 0);
                store.Dispose();
                store = NewProcess();
            }

            store.Outside.KeepCheckpoint(Stop, 0);
            Assert.Null(store.Outside.WhyWhole);
            IsWhole(store);
        }
        finally
        {
            store.Dispose();
        }
    }

    [Fact]
    public void A_checkpoint_is_made_after_so_many_entries_and_not_before()
    {
        using var store = NewProcess();
        Note(store, OutsideChanges.Rhythm - 2);
        store.Outside.KeepCheckpoint(Stop);
        Assert.Equal(0, Count(store));
        Note(store, 1);
        store.Outside.KeepCheckpoint(Stop);
        var first = Kept(store);
        Assert.Equal(OutsideChanges.Rhythm, first.Seq);
        Note(store, OutsideChanges.Rhythm - 1);
        store.Outside.KeepCheckpoint(Stop);
        Assert.Equal(first, Kept(store));
        Note(store, 1);
        store.Outside.KeepCheckpoint(Stop);
        Assert.Equal(2 * OutsideChanges.Rhythm, Kept(store).Seq);
    }

    [Fact]
    public void A_store_of_which_nobody_has_the_key_gets_no_checkpoint()
    {
        using var store = CellStore.Open(Settings, Clock);
        store.Outside.KeepCheckpoint(Stop, 0);
        Assert.Equal(0, Count(store));
    }

    [Fact]
    public void Reading_that_is_told_to_stop_goes_on_where_it_was()
    {
        using var store = NewProcess();
        Note(store, 3000);
        using var later = NewProcess();
        Assert.Throws<OperationCanceledException>(() => later.Outside.KeepCheckpoint(new(true), 0));
        Assert.Equal(0, Count(later));
        later.Outside.KeepCheckpoint(Stop, 0);
        IsWhole(later);
    }

    private void Act(CellStore store, Random random, int number)
    {
        var open = store.Search(new HistoryQuery { Most = 1000 }).Where(c => CorrectionSteps.From(c.State).Count > 0).ToArray();
        if (open.Length == 0 || random.Next(4) == 0)
        {
            store.Archive(Arrival($"file {number}", $"file {number}"));
            return;
        }

        var c = open[random.Next(open.Length)];
        var to = CorrectionSteps.From(c.State)[random.Next(CorrectionSteps.From(c.State).Count)];
        if (to is CorrectionState.Superseded or CorrectionState.Failed && random.Next(2) == 0) return;
        var by = to == CorrectionState.Approved ? new[] { "cell", "Anna", "eve" }[random.Next(3)] : "cell";
        var program = $"program {c.Id}";
        try
        {
            store.Step(
                c, to, by, by == "cell" ? Policy : "seen",
                x => x with
                {
                    Machine = "mill",
                    Slot = c.Id % 2 == 0 ? "1" : "2",
                    ProgramSha256 = to == CorrectionState.Computed ? Hash(program) : x.ProgramSha256,
                },
                to == CorrectionState.Computed ? [Bytes(program)] : null);
            if (to == CorrectionState.Reverted) store.FreeSlot("mill", c.Id % 2 == 0 ? "1" : "2", c.Id, "cell", "free");
        }
        catch (Exception e) when (e is SlotTakenException or ArgumentException or StoreException { Error: StoreError.Conflict })
        {
            // Another one has the slot, or there is nothing to send.
        }
    }
}
