using System.Globalization;
using ErrorMatching.Measurement;

namespace ErrorMatching.Freeform;

/// <summary>What a lot says, in sentences.</summary>
public static class LotWords
{
    // A drift of this many of its standard uncertainties is worth a word.
    private const double Significant = 2;

    /// <summary>Adds the findings at the last piece to the warnings, and the state of the lot to the notes.</summary>
    internal static void Tell(SurfaceLot pieces, Lot lot, List<string> notes, List<string> warnings)
    {
        var last = lot.Pieces[^1];
        if (last.Event == LotEvent.Outlier)
        {
            warnings.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"This piece does not fit the {lot.Pieces.Count - 1} before it: it shows a mean of {Um(last.ShownMm)} um where "
                    + $"{Um(last.ExpectedMm)} um were expected. It hardly counts (an outlier by {last.OutlierProbability:0%}). If it is "
                    + $"a new tool or clamping, the next piece will confirm it; if a touch went wrong, measure this piece again."));
        }

        foreach (var (piece, number) in lot.Pieces.Select((p, k) => (p, k + 1)).Where(p => p.p.Event == LotEvent.Step))
        {
            var sentence = string.Create(
                CultureInfo.InvariantCulture,
                $"The process moved before piece {number} of {lot.Pieces.Count} ({piece.StepProbability:0%}): a mean of "
                    + $"{Um(piece.ShownMm)} um where {Um(piece.ExpectedMm)} um were expected. A new tool or another clamping does that.");
            (number >= lot.Pieces.Count - 1 ? warnings : notes).Add(sentence);
        }

        notes.Add(string.Create(
            CultureInfo.InvariantCulture,
            $"The compensation follows {pieces.Pieces.Count} pieces. Without it the next piece is expected to be off by a mean of "
                + $"{Um(lot.ExpectedMm.Average())} um; standard uncertainty of a point "
                + $"{Math.Sqrt(lot.UncertaintyMm.Average(u => u * u)) * 1000:0.00} um, noise of one measurement {lot.NoiseMm * 1000:0.00} "
                + $"um.{Drift(lot)}"));
    }

    private static string Drift(Lot lot) => Math.Abs(lot.DriftMm) > Significant * lot.DriftUncertaintyMm
        ? string.Create(
            CultureInfo.InvariantCulture,
            $" The mean drifts by {Um(lot.DriftMm)} +- {2 * lot.DriftUncertaintyMm * 1000:0.00} um a piece.")
        : "";

    private static string Um(double mm) => (mm * 1000).ToString("+0.00;-0.00;0.00", CultureInfo.InvariantCulture);
}
