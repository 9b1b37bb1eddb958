namespace ErrorMatching.Measurement;

/// <summary>What the pieces measured so far say about the next one.</summary>
/// <remarks>The error of a process is what a piece shows minus what its program corrected. It may repeat, drift, walk or step, and single
/// pieces may be outliers. Nobody states which: the lot is explained by a bank of Kalman filters over all these possibilities, and each
/// counts by how well it explains the pieces. The mean of all points and what differs from it are followed apart, because tools and heat
/// move all points alike.</remarks>
/// <param name="ExpectedMm">The expected error of the next piece at each point if nothing is corrected.</param>
/// <param name="UncertaintyMm">Standard uncertainty of each.</param>
/// <param name="DriftMm">Change of the mean of all points from piece to piece.</param>
/// <param name="DriftUncertaintyMm">Standard uncertainty of the drift.</param>
/// <param name="NoiseMm">Standard deviation of one measured point about the error of the process.</param>
/// <param name="Pieces">What was found at each piece.</param>
public sealed record Lot(
    IReadOnlyList<double> ExpectedMm,
    IReadOnlyList<double> UncertaintyMm,
    double DriftMm,
    double DriftUncertaintyMm,
    double NoiseMm,
    IReadOnlyList<LotFinding> Pieces)
{
    /// <summary>Estimates the error of the next piece.</summary>
    /// <param name="pieces">The pieces in the order of cutting, at least one, with at least one point.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of one measured point, more than 0.</param>
    /// <param name="ahead">Number of pieces that are cut before it, and not measured yet.</param>
    /// <exception cref="ArgumentException">There is no piece or no point, or the pieces have different numbers of points.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is not a positive number.</exception>
    public static Lot Estimate(IReadOnlyList<LotPiece> pieces, double uncertaintyMm, int ahead = 0)
    {
        ArgumentNullException.ThrowIfNull(pieces);
        if (!(uncertaintyMm > 0) || double.IsInfinity(uncertaintyMm))
        {
            throw new ArgumentOutOfRangeException(nameof(uncertaintyMm), uncertaintyMm, "A standard uncertainty is more than 0.");
        }

        if (pieces.Count == 0 || pieces[0].ErrorsMm.Count == 0
            || pieces.Any(p => p.ErrorsMm.Count != pieces[0].ErrorsMm.Count || p.CorrectionsMm.Count != p.ErrorsMm.Count))
        {
            throw new ArgumentException("A lot has pieces with the same points, at least one.", nameof(pieces));
        }

        var points = pieces[0].ErrorsMm.Count;
        var unit = uncertaintyMm * uncertaintyMm;
        var mean = new LotFilter(1, 1, uncertaintyMm, unit / points);
        var shape = points > 1 ? new LotFilter(points, points - 1, uncertaintyMm, unit) : null;
        var expected = new List<double>();
        foreach (var piece in pieces)
        {
            expected.Add(mean.Expected[0]);
            double[] values = [.. piece.ErrorsMm.Zip(piece.CorrectionsMm, (e, c) => e - c)];
            var level = values.Average();
            mean.Add([level], piece.IsAfterToolChange);
            shape?.Add([.. values.Select(v => v - level)], piece.IsAfterToolChange);
        }

        mean.GoOn(ahead);
        shape?.GoOn(ahead);
        return new(
            [.. Enumerable.Range(0, points).Select(i => mean.Expected[0] + (shape?.Expected[i] ?? 0))],
            [.. Enumerable.Range(0, points).Select(i => Math.Sqrt(mean.VarianceAt(0) + (shape?.VarianceAt(i) ?? 0)))],
            mean.Drift[0],
            Math.Sqrt(mean.DriftVarianceAt(0)),
            Math.Sqrt((mean.NoiseMm * mean.NoiseMm) + (shape is null ? 0 : shape.NoiseMm * shape.NoiseMm * (points - 1) / points)),
            [
                .. pieces.Select((piece, k) => new LotFinding(
                    piece.ErrorsMm.Average() - piece.CorrectionsMm.Average(),
                    expected[k],
                    Math.Max(mean.Probability(k, LotEvent.Step), shape?.Probability(k, LotEvent.Step) ?? 0),
                    Math.Max(mean.Probability(k, LotEvent.Outlier), shape?.Probability(k, LotEvent.Outlier) ?? 0)))]);
    }
}

/// <summary>What was found at a piece.</summary>
/// <param name="ShownMm">Mean of the errors that it would have without corrections, mm.</param>
/// <param name="ExpectedMm">What was expected of that mean before the piece, mm.</param>
/// <param name="StepProbability">Probability that the process moved before this piece and stays there.</param>
/// <param name="OutlierProbability">Probability that only this piece is off.</param>
public sealed record LotFinding(double ShownMm, double ExpectedMm, double StepProbability, double OutlierProbability)
{
    /// <summary>What most likely happened.</summary>
    public LotEvent Event => StepProbability > 0.5 ? LotEvent.Step : OutlierProbability > 0.5 ? LotEvent.Outlier : LotEvent.None;
}
