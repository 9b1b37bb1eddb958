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
