using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Asks for the signature to restore the program that a slot held before a correction, and tells which one that is.</summary>
internal static class RevertSigning
{
    /// <summary>True if it can be restored: the correction's program is at the machine, or was cut and is still in the slot.</summary>
    public static bool IsPossible(StoredCorrection? kept) =>
        kept is { IsInSlot: true, Correction.RevertedSha256: not null }
            && CorrectionSteps.Allows(kept.Correction.State, CorrectionState.Reverted);

    /// <summary>Creates the signing dialog.</summary>
    /// <param name="shell">The shell that shows it, and its current user.</param>
    /// <param name="kept">The correction.</param>
    public static SigningViewModel Of(ShellViewModel shell, StoredCorrection kept)
    {
        var (station, correction) = (shell.Station, kept.Correction);
        return new(
            station,
            shell.Who!,
            Act.Revert,
            kept.Subject,
            needsReason: true,
            (by, reason, cancellation) => new SlotReversal(
                station.Settings, station.Store, station.Open, station.Clock).RevertAsync(correction.Id, by.Name, reason!, cancellation))
        {
            Correction = correction,
            Told = () => correction.UndoSha256 is not null ? Texts.Current["Revert.Offset"]
                : kept.Before is { } before
                ? Texts.Current.With("Revert.Before", CorrectionLabel.Of(before))
                : Texts.Current["Revert.BeforeUnknown"],
        };
    }
}
