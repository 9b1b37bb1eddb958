using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Measurement;

/// <summary>What a lot says, in sentences.</summary>
public static class LotWords
{
    // A drift of this many of its standard uncertainties is worth a word.
    private const double Significant = 2;

    /// <summary>Count of the pieces before, the mean that the piece shows and the expected one in um, and the probability in
    /// percent.</summary>
    public static SentenceForm Outlier { get; } = new(
        "lot-outlier",
        "This piece does not fit the {0} before it: it shows a mean of {1} µm where {2} µm were expected. It hardly counts (an outlier by "
            + "{3} %). If it is a new tool or clamping, the next piece will confirm it; if a touch went wrong, measure this piece again.");

    /// <summary>Number of the piece, count of all, probability in percent, the mean that it shows and the expected one in um.</summary>
    public static SentenceForm Moved { get; } = new(
        "lot-step",
        "The process moved before piece {0} of {1} ({2} %): a mean of {3} µm where {4} µm were expected. A new tool or another clamping "
            + "does that.");

    /// <summary>What a person should look at: the last piece is an outlier, or the process moved before one of the last two.</summary>
    /// <param name="lot">The lot.</param>
    /// <returns>Forms with their values as texts.</returns>
    public static IReadOnlyList<(SentenceForm Form, string[] Values)> Warnings(Lot lot)
    {
        ArgumentNullException.ThrowIfNull(lot);
        var (last, count) = (lot.Pieces[^1], lot.Pieces.Count);
        return
        [
            .. last.Event == LotEvent.Outlier
                ? [(Outlier, new[] { Whole(count - 1), Um(last.ShownMm), Um(last.ExpectedMm), Percent(last.OutlierProbability) })]
                : Array.Empty<(SentenceForm, string[])>(),
            .. Steps(lot).Where(k => k >= count - 2).Select(k => (Moved, Step(lot, k))),
        ];
    }

    /// <summary>The state of the lot, and older steps.</summary>
    /// <param name="lot">The lot.</param>
    public static IEnumerable<string> Notes(Lot lot)
    {
        ArgumentNullException.ThrowIfNull(lot);
        return Steps(lot)
            .Where(k => k < lot.Pieces.Count - 2)
            .Select(k => Moved.With([.. Step(lot, k)]).Sentence)
            .Append(string.Create(
                CultureInfo.InvariantCulture,
                $"The compensation follows {lot.Pieces.Count} pieces. Without it the next piece is expected to be off by a mean of "
                    + $"{Um(lot.ExpectedMm.Average())} µm; standard uncertainty of a point "
                    + $"{Math.Sqrt(lot.UncertaintyMm.Average(u => u * u)) * 1000:0.00} µm, noise of one measurement "
                    + $"{lot.NoiseMm * 1000:0.00} µm.{Drift(lot)}"));
    }

    private static IEnumerable<int> Steps(Lot lot) =>
        Enumerable.Range(0, lot.Pieces.Count).Where(k => lot.Pieces[k].Event == LotEvent.Step);

    private static string[] Step(Lot lot, int k) =>
        [
            Whole(k + 1), Whole(lot.Pieces.Count), Percent(lot.Pieces[k].StepProbability), Um(lot.Pieces[k].ShownMm),
            Um(lot.Pieces[k].ExpectedMm),
        ];

    private static string Drift(Lot lot) => Math.Abs(lot.DriftMm) > Significant * lot.DriftUncertaintyMm
        ? string.Create(
            CultureInfo.InvariantCulture,
            $" The mean drifts by {Um(lot.DriftMm)} ± {2 * lot.DriftUncertaintyMm * 1000:0.00} µm a piece.")
        : "";

    private static string Whole(int count) => count.ToString(CultureInfo.InvariantCulture);

    private static string Percent(double share) => ReportNumber.WholePercent(share * 100);

    private static string Um(double mm) => (mm * 1000).ToString("+0.00;-0.00;0.00", CultureInfo.InvariantCulture);
}
