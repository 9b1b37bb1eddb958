namespace ErrorMatching.Cell.Tests;

/// <summary>What slots hold, and who may send to them.</summary>
public abstract class StoreSlotTests(StoreKind kind) : StoreTest(kind)
{
    [Fact]
    public void A_slot_follows_its_correction_from_uploading_to_released()
    {
        var store = Open();
        Assert.Equal(new SlotHolding("mill", "1", null, null, null), store.Slot("mill", "1"));
        var first = Approve(store, "one", "G1");
        first = Up(store, first);
        Assert.Equal(new SlotHolding("mill", "1", first.Id, null, null), store.Slot("mill", "1"));
        first = store.Step(first, CorrectionState.Verified, "cell", "read back");
        Assert.Equal(new SlotHolding("mill", "1", first.Id, Hash("G1"), null), store.Slot("mill", "1"));
        store.Step(first, CorrectionState.Released, "anna", "cut");
        Assert.Equal(new SlotHolding("mill", "1", null, Hash("G1"), null), store.Slot("mill", "1"));

        var second = store.Step(Up(store, Approve(store, "two", "G2")), CorrectionState.Verified, "cell", "read back");
        Assert.Equal(new SlotHolding("mill", "1", second.Id, Hash("G2"), Hash("G1")), store.Slot("mill", "1"));
    }

    [Fact]
    public void A_slot_that_is_taken_is_not_given_to_another()
    {
        var store = Open();
        var (first, second) = (Approve(store, "one", "G1"), Approve(store, "two", "G2"));
        Up(store, first);
        Assert.Equal(first.Id, Assert.Throws<SlotTakenException>(() => Up(store, second)).Holder);
        Assert.Equal(second, store.Find(second.Id));
        Assert.Equal(first.Id, store.Slot("mill", "1").Correction);
    }

    [Theory]
    [InlineData(CorrectionState.Approved), InlineData(CorrectionState.Failed)]
    public void What_was_not_sent_gives_its_slot_back(CorrectionState to)
    {
        var store = Open();
        store.Step(Up(store, Approve(store, "one", "G1")), to, "cell", "the machine is away");
        Assert.Equal(new SlotHolding("mill", "1", null, null, null), store.Slot("mill", "1"));
        Up(store, Approve(store, "two", "G2"));
    }

    [Fact]
    public void A_revert_brings_the_program_before_and_keeps_the_slot_until_it_is_freed()
    {
        var store = Open();
        Release(store, "one", "G1");
        var second = Release(store, "two", "G2");
        second = store.Step(second, CorrectionState.Reverted, "anna", "wrong tool");
        Assert.Equal(new SlotHolding("mill", "1", second.Id, Hash("G1"), null), store.Slot("mill", "1"));
        var third = Approve(store, "three", "G3");
        Assert.Throws<SlotTakenException>(() => Up(store, third));
        store.FreeSlot("mill", "1", second.Id, "anna", "sent");
        Assert.Null(store.Slot("mill", "1").Correction);
        Up(store, third);
    }

    [Fact]
    public void A_revert_knows_what_the_machine_held_before_the_first_program_of_the_cell()
    {
        var store = Open();
        var first = store.Step(
            Approve(store, "one", "G1"),
            CorrectionState.Uploading,
            "cell",
            "in line",
            c => c with { PreviousSha256 = Hash("G0") },
            [Bytes("G0")]);
        first = store.Step(first, CorrectionState.Verified, "cell", "read back");
        Assert.Equal(Hash("G0"), store.Slot("mill", "1").PreviousSha256);
        store.Step(first, CorrectionState.Reverted, "anna", "wrong tool");
        Assert.Equal(Hash("G0"), store.Slot("mill", "1").ProgramSha256);
    }

    [Fact]
    public void What_lies_under_a_newer_program_is_not_reverted()
    {
        var store = Open();
        var first = Release(store, "one", "G1");
        Release(store, "two", "G2");
        Assert.Equal(
            StoreError.Conflict,
            Assert.Throws<StoreException>(() => store.Step(first, CorrectionState.Reverted, "anna", "wrong tool")).Error);
        Assert.Equal(first, store.Find(first.Id));
        Assert.Equal(Hash("G2"), store.Slot("mill", "1").ProgramSha256);
    }

    [Fact]
    public void A_revert_waits_for_a_slot_that_another_correction_has()
    {
        var store = Open();
        var first = Release(store, "one", "G1");
        var second = Up(store, Approve(store, "two", "G2"));
        Assert.Equal(
            second.Id, Assert.Throws<SlotTakenException>(() => store.Step(first, CorrectionState.Reverted, "anna", "wrong tool")).Holder);
    }

    [Fact]
    public void One_process_at_a_time_may_send_to_a_slot()
    {
        var (here, there) = (Open(), Open());
        var taken = here.TryLockSlot("mill", "1");
        Assert.NotNull(taken);
        Assert.True(taken.IsHeld, "Who took it does not have it.");
        Assert.Null(here.TryLockSlot("mill", "1"));
        Assert.Null(there.TryLockSlot("mill", "1"));
        using (var other = there.TryLockSlot("mill", "2"))
        {
            Assert.NotNull(other);
            Assert.True(other.IsHeld, "Another slot's right is not held.");
        }

        taken.Dispose();
        Assert.False(taken.IsHeld, "Who gave it back still has it.");
        using var again = there.TryLockSlot("mill", "1");
        Assert.NotNull(again);
        Assert.True(again.IsHeld, "Who took it next does not have it.");
        Assert.Null(here.TryLockSlot("mill", "1"));
    }

    [Fact]
    public void A_slot_is_freed_of_the_correction_that_has_it_and_of_no_other()
    {
        var store = Open();
        var first = Release(store, "one", "G1");
        var second = Up(store, Approve(store, "two", "G2"));
        var entries = store.ChangeCount();
        store.FreeSlot("mill", "1", first.Id, "anna", "cut");
        Assert.Equal((second.Id, entries), (store.Slot("mill", "1").Correction, store.ChangeCount()));
        store.FreeSlot("mill", "1", second.Id, "anna", "cut");
        Assert.Null(store.Slot("mill", "1").Correction);
        Assert.Equal(
            ("anna", "freed", "slot 1 of mill", "cut"),
            store.AuditEntries(entries, 9).Single() is var e ? (e.Who, e.What, e.Subject, e.Basis) : default);
    }

    [Fact]
    public void Names_of_slots_are_not_mixed_up()
    {
        var store = Open();
        using var one = store.TryLockSlot("a b", "c");
        using var two = store.TryLockSlot("a", "b c");
        Assert.NotNull(one);
        Assert.NotNull(two);
        Assert.True(one.IsHeld && two.IsHeld, "One of two rights that were given is not held.");
    }

    [Fact]
    public void One_process_at_a_time_may_run_a_cell()
    {
        var (here, there) = (Open(), Open());
        var taken = here.TryLockCell("line 1");
        Assert.NotNull(taken);
        Assert.True(taken.IsHeld, "Who runs the cell does not have it.");
        Assert.Null(there.TryLockCell("line 1"));
        taken.Dispose();
        Assert.False(taken.IsHeld, "Who ended still has the cell.");
        using var again = there.TryLockCell("line 1");
        Assert.NotNull(again);
        Assert.True(again.IsHeld, "Who runs the cell next does not have it.");
    }
}
