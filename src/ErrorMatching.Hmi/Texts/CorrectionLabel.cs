using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>What a correction is called on the screen: its number, and the serial number of its piece or the file that it came as.</summary>
public static class CorrectionLabel
{
    /// <summary>The label; the file alone where it has no number, since the store does not have it.</summary>
    public static string Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        var piece = correction.Serial ?? correction.FileName;
        return correction.Id == 0 ? piece : $"#{Shown.Id(correction.Id)} · {piece}";
    }

    /// <summary>How much a correction asks for attention: one that failed is an alarm, one that is proposed waits for a person, and one that is reverted did not come to what it was approved for.</summary>
    public static Severity SeverityOf(CorrectionState state) => state switch { CorrectionState.Failed => Severity.Alarm, CorrectionState.Proposed or CorrectionState.Reverted => Severity.Attention, _ => Severity.Quiet };

    /// <summary>Where its program goes, is or was, in a sentence: machine, slot and file; null where none goes to a machine.</summary>
    public static string? Target(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        var key = correction.State switch
        {
            CorrectionState.Proposed or CorrectionState.Approved or CorrectionState.Uploading or CorrectionState.Failed => "Target.Goes",
            CorrectionState.Verified => "Target.Is",
            CorrectionState.Released => "Target.Was",
            CorrectionState.Reverted => "Target.TakenBack",
            _ => null,
        };
        return key is null || correction.ProgramSha256 is null ? null : Texts.Current.With(key, $"{correction.Machine}/{correction.Slot}", correction.Program ?? "");
    }
}
