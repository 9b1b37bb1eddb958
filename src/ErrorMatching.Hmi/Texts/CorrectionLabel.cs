using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Label of a correction: its number, and the serial number of its piece or the name of its file.</summary>
internal static class CorrectionLabel
{
    /// <summary>The label; only the file name if the correction is not in the store and so has no number.</summary>
    public static string Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        var piece = correction.Serial ?? correction.FileName;
        return correction.Id == 0 ? piece : $"#{Shown.Id(correction.Id)} · {piece}";
    }

    /// <summary>Severity of a correction: a failed one is an alarm. A proposed one waits for a person. A reverted one did not
    /// achieve what it was approved for.</summary>
    public static Severity SeverityOf(CorrectionState state) => state switch
    {
        CorrectionState.Failed => Severity.Alarm,
        CorrectionState.Proposed or CorrectionState.Reverted => Severity.Attention,
        CorrectionState.Archived or CorrectionState.Recognized or CorrectionState.Computed or CorrectionState.Approved
            or CorrectionState.Uploading or CorrectionState.Verified or CorrectionState.Released or CorrectionState.Superseded
            or CorrectionState.Recorded or CorrectionState.Refused or CorrectionState.Rejected => Severity.Quiet,
    };

    /// <summary>Where its program goes, is or was, in a sentence: machine, slot and file; null if none goes to a machine.</summary>
    public static string? Target(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        var key = correction.State switch
        {
            CorrectionState.Proposed or CorrectionState.Approved or CorrectionState.Uploading or CorrectionState.Failed => "Target.Goes",
            CorrectionState.Verified => "Target.Is",
            CorrectionState.Released => "Target.Was",
            CorrectionState.Reverted => "Target.TakenBack",
            CorrectionState.Archived or CorrectionState.Recognized or CorrectionState.Computed or CorrectionState.Superseded
                or CorrectionState.Recorded or CorrectionState.Refused or CorrectionState.Rejected => null,
        };
        return key is null || correction.ProgramSha256 is null
            ? null
            : Texts.Current.With(key, $"{correction.Machine}/{correction.Slot}", correction.Program ?? "");
    }
}
