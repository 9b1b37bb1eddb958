using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Why a correction, decided or not, cannot go to its machine yet.</summary>
/// <param name="Text">In a sentence.</param>
/// <param name="Severity">Attention if it waits for a decision.</param>
/// <param name="First">Number of the correction that it waits for, to be handled first.</param>
internal sealed record WaitReason(string Text, Severity Severity, long First)
{
    // More than this add nothing: the first one is decided first.
    private const int Most = 5;

    /// <summary>What a correction waits for; null if it waits for nothing or is not in a queue.</summary>
    /// <param name="status">The state of the cell.</param>
    /// <param name="id">Number of the correction.</param>
    public static WaitReason? Of(CellStatus status, long id)
    {
        ArgumentNullException.ThrowIfNull(status);
        if (status.Slots.FirstOrDefault(s => s.Line.Any(c => c.Id == id)) is not { } slot)
        {
            return null;
        }

        return slot.UndecidedBefore(id) is [var first, ..] behind
            ? new(Texts.Current.Counted("Wait.Behind", behind.Count, Numbers(behind)), Severity.Attention, first.Id)
            : slot.Held is { } held && slot.Approved.Any(c => c.Id == id)
                ? new(Texts.Current.With("Wait.Slot", Number(held)), Severity.Quiet, held.Id)
            : slot.Delivery is { } delivery && delivery.Correction == id
                ? new(RecordedText.Of(delivery.Statement), Severity.Quiet, id)
            : null;
    }

    /// <summary>The numbers of corrections as a list for display.</summary>
    /// <param name="corrections">The corrections.</param>
    public static string Numbers(IReadOnlyList<Correction> corrections)
    {
        ArgumentNullException.ThrowIfNull(corrections);
        return Texts.Current.Listed(corrections.Take(Most).Select(Number)) + (corrections.Count > Most ? " …" : "");
    }

    private static string Number(Correction correction) => "#" + Shown.Id(correction.Id);
}
