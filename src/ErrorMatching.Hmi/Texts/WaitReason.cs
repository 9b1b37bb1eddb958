using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Why a correction that somebody has decided about, or is to decide about, cannot go to its machine yet.</summary>
/// <param name="Text">In a sentence.</param>
/// <param name="Severity">Attention where it goes on only when somebody decides.</param>
/// <param name="First">Number of the correction that it waits for, and that is to be looked at first.</param>
public sealed record WaitReason(string Text, Severity Severity, long First)
{
    // More of them say nothing more: the first is decided about first.
    private const int Most = 5;

    /// <summary>What a correction waits for; null if nothing is in its way, or it stands in no line.</summary>
    /// <param name="status">How the cell is.</param>
    /// <param name="id">Number of the correction.</param>
    public static WaitReason? Of(CellStatus status, long id)
    {
        ArgumentNullException.ThrowIfNull(status);
        if (status.Slots.FirstOrDefault(s => s.Line.Any(c => c.Id == id)) is not { } slot)
        {
            return null;
        }

        return slot.UndecidedBefore(id) is [var first, ..] behind ? new(Texts.Current.Counted("Wait.Behind", behind.Count, Numbers(behind)), Severity.Attention, first.Id)
            : slot.Held is { } held && slot.Approved.Any(c => c.Id == id) ? new(Texts.Current.With("Wait.Slot", Number(held)), Severity.Quiet, held.Id)
            : null;
    }

    /// <summary>The numbers of corrections in a row, as they stand on the screen.</summary>
    /// <param name="corrections">The corrections.</param>
    public static string Numbers(IReadOnlyList<Correction> corrections)
    {
        ArgumentNullException.ThrowIfNull(corrections);
        return Texts.Current.Listed(corrections.Take(Most).Select(Number)) + (corrections.Count > Most ? " …" : "");
    }

    private static string Number(Correction correction) => "#" + Shown.Id(correction.Id);
}
