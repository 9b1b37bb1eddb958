namespace ErrorMatching.Measurement;

/// <summary>One measured piece of a lot. Lengths in millimeters, one value for each measured point, in the same order for all
/// pieces.</summary>
/// <param name="ErrorsMm">The errors that it shows, actual minus nominal.</param>
/// <param name="CorrectionsMm">How far the program that cut it had moved each point; zeros for a nominal program.</param>
public sealed record LotPiece(IReadOnlyList<double> ErrorsMm, IReadOnlyList<double> CorrectionsMm)
{
    /// <summary>True if somebody said that the tool was changed before this piece, so that the process may have moved.</summary>
    public bool IsAfterToolChange { get; init; }
}

/// <summary>A measured piece of a lot.</summary>
/// <param name="MeasuredSha256">SHA-256 of its measurement.</param>
/// <param name="NoiseMm">Standard deviation of one measured point, as this piece shows it, mm.</param>
/// <param name="Values">Its errors, and what the program that cut it had corrected.</param>
public sealed record RecordedPiece(string MeasuredSha256, double NoiseMm, LotPiece Values)
{
    /// <summary>A piece that is not the first. What two pieces differ by, apart from a shift of all points, is noise.</summary>
    /// <param name="before">The piece before it, with the same points.</param>
    /// <param name="sha256">SHA-256 of its measurement.</param>
    /// <param name="values">Its values.</param>
    public static RecordedPiece After(RecordedPiece before, string sha256, LotPiece values)
    {
        ArgumentNullException.ThrowIfNull(before);
        ArgumentNullException.ThrowIfNull(values);
        double[] changes = [
            .. values.ErrorsMm.Select((e, i) => e - values.CorrectionsMm[i] - before.Values.ErrorsMm[i] + before.Values.CorrectionsMm[i])];
        var mean = changes.Average();
        var variance = changes.Length > 1 ? changes.Sum(c => (c - mean) * (c - mean)) / (changes.Length - 1) : 0;
        return new(sha256, Math.Sqrt(variance / 2), values);
    }
}
