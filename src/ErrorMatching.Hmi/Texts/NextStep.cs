using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The next step for a correction, who takes it, and what a person has to do: the same sentence on every screen.</summary>
internal static class NextStep
{
    /// <summary>The next step, in one line.</summary>
    /// <param name="settings">The cell's configuration.</param>
    /// <param name="status">The state of the cell; null before it is known.</param>
    /// <param name="correction">The current correction.</param>
    /// <returns>The sentence; null if there is no next step, or if it is unknown.</returns>
    public static string? Of(CellSettings settings, CellStatus? status, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(correction);
        var texts = Texts.Current;
        return correction.State switch
        {
            CorrectionState.Proposed => texts["Next.Decide"],
            CorrectionState.Failed => texts[correction.ProgramSha256 is null ? "Message.FailedUncomputed.Next" : "Message.Failed.Next"],
            CorrectionState.Approved when status is not null && WaitReason.Of(status, correction.Id) is { } wait => wait.Text,
            CorrectionState.Approved or CorrectionState.Uploading => texts.With(WayOf(status, correction), correction.Machine!),
            CorrectionState.Verified => CutOf(settings, correction),
            CorrectionState.Released =>
                GaugesOf(settings, correction) is { Length: > 0 } gauges ? texts.With("Next.Measure", gauges) : null,
            CorrectionState.Reverted when status?.Slots.Any(s => s.Held?.Id == correction.Id) == true => texts["Message.TakenBack.Next"],
            CorrectionState.Reverted => texts["Next.TakenBack"],
            CorrectionState.Archived or CorrectionState.Recognized or CorrectionState.Computed or CorrectionState.Superseded
                or CorrectionState.Recorded or CorrectionState.Refused or CorrectionState.Rejected => null,
        };
    }

    // What delays sending, if no decision is needed.
    private static string WayOf(CellStatus? status, Correction correction) => status switch
    {
        { IsRunning: false } => "Next.NotRunning",
        { Heartbeat.Troubles: { } troubles } when troubles.Any(
            t => t.Where == CellTrouble.OfSlot(correction.Machine!, correction.Slot!)
                || t.Where == CellTrouble.OfMachine(correction.Machine!)) => "Next.Away",
        _ => "Next.Sent",
    };

    // A machine with a ready file reports itself that the piece is cut.
    private static string CutOf(CellSettings settings, Correction correction)
    {
        var says = settings.Machines.FirstOrDefault(
            m => m.Name == correction.Machine)?.Slots.FirstOrDefault(s => s.Name == correction.Slot)?.ReadyFile is not null;
        return GaugesOf(settings, correction) is { Length: > 0 } gauges
            ? Texts.Current.With(says ? "Next.Cut" : "Next.CutRelease", correction.Machine!, gauges)
            : Texts.Current.With(says ? "Next.CutOnly" : "Next.CutReleaseOnly", correction.Machine!);
    }

    // The gauges that measure what a mating's program cut: those of a job with the same file that takes counterparts. Whether a
    // surface is measured again is up to the shop.
    private static string GaugesOf(CellSettings settings, Correction correction)
    {
        var mating = settings.Jobs.FirstOrDefault(j => j.Name == correction.Job && !j.IsFreeform);
        return string.Join(
            " / ",
            settings.Jobs.Where(j => j.File == mating?.File && j.Piece is null or PieceWords.Counterpart)
                .SelectMany(j => j.Gauges)
                .Distinct(StringComparer.Ordinal));
    }
}
