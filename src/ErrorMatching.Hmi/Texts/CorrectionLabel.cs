using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>What a correction is called on the screen: its number, and the serial number of its piece or the file that it came as.</summary>
public static class CorrectionLabel
{
    /// <summary>The label.</summary>
    public static string Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        return $"#{Shown.Id(correction.Id)} · {correction.Serial ?? correction.FileName}";
    }
}
