using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Asks for the signature that brings back the program which a slot held before a correction, and says which one that is.</summary>
internal static class RevertSigning
{
    /// <summary>True where it can be brought back: its own is at the machine, or was cut and is still there.</summary>
    public static bool IsPossible(KeptCorrection? kept) => kept is { IsInSlot: true, Correction: { State: CorrectionState.Verified or CorrectionState.Released, PreviousSha256: not null } };

    /// <summary>The signature.</summary>
    /// <param name="shell">Who signs, and where.</param>
    /// <param name="kept">The correction.</param>
    public static SigningViewModel Of(ShellViewModel shell, KeptCorrection kept)
    {
        var (station, correction) = (shell.Station, kept.Correction);
        return new(
            station, shell.Who!, Act.Revert, kept.Subject, needsReason: true, (by, reason, cancellation) => new SlotReversal(station.Settings, station.Store, station.Open, station.Clock).RevertAsync(correction.Id, by.Name, reason!, cancellation))
        {
            Correction = correction,
            Told = () => kept.Before is { } before ? Texts.Current.With("Revert.Before", CorrectionLabel.Of(before)) : Texts.Current["Revert.BeforeUnknown"],
        };
    }
}
