namespace ErrorMatching.Cell.Tests;

/// <summary>Who has to be decided about before a correction can be sent: nobody overtakes.</summary>
public sealed class SlotStatusTests
{
    [Fact]
    public void What_is_approved_waits_behind_what_nobody_has_decided_about_and_behind_nothing_else()
    {
        var slot = Of(
            CorrectionState.Proposed,
            CorrectionState.Approved,
            CorrectionState.Failed,
            CorrectionState.Computed,
            CorrectionState.Approved,
            CorrectionState.Proposed);
        Assert.Equal([(2L, "1"), (5L, "1, 3")], slot.HeldUp.Select(h => (h.Correction.Id, string.Join(", ", h.Behind.Select(c => c.Id)))));
        Assert.Equal([1L, 3], slot.UndecidedBefore(6).Select(c => c.Id));
        Assert.Empty(slot.UndecidedBefore(1));
        Assert.Empty(slot.UndecidedBefore(7));
        Assert.Equal([2L, 5], slot.Approved.Select(c => c.Id));
        Assert.Equal((6, 5), (slot.Waiting, slot.Next.Count));
    }

    [Fact]
    public void What_is_first_is_held_up_by_nobody() =>
        Assert.Empty(Of(CorrectionState.Approved, CorrectionState.Approved, CorrectionState.Proposed).HeldUp);

    private static SlotStatus Of(params CorrectionState[] line) => new(
        null!,
        null!,
        new("vmc1", "A", null, null, null),
        null,
        [.. line.Select((s, i) => new Correction(i + 1, s, 1, "gauge", "file", DateTimeOffset.UnixEpoch, "", 0) { Job = "job" })]);
}
