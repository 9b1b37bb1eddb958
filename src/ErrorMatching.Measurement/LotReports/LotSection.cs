using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Measurement;

/// <summary>The section of a report that shows what the pieces of a lot did, and why the next correction is what it is.</summary>
public static class LotSection
{
    /// <summary>The section; none for the first piece.</summary>
    /// <param name="pieces">The pieces.</param>
    /// <param name="lot">What they say about the next one; null for a first piece.</param>
    /// <param name="shown">What a piece shows, as a column is named: its errors against what was wanted of it, or against its
    /// design.</param>
    public static IEnumerable<PageSection> Of(MeasuredLot pieces, Lot? lot, string shown = "Left on it") =>
        lot is null ? [] : [new("lot", "The pieces so far", html => Write(html, pieces, lot, shown))];

    /// <summary>The word for what happened at a piece.</summary>
    internal static string Word(LotEvent happened) => happened switch
    {
        LotEvent.None => "as expected",
        LotEvent.Step => "the process moved",
        LotEvent.Outlier => "an outlier",
        _ => throw new ArgumentOutOfRangeException(nameof(happened), happened, "Unknown event."),
    };

    private static void Write(HtmlText html, MeasuredLot pieces, Lot lot, string shown)
    {
        using (html.In("figure"))
        {
            new LotPlot(pieces, lot, shown).Write(html);
            html.Put(
                "figcaption",
                "The next program corrects what is expected of the next piece. How much a piece counts follows from the noise and the "
                    + "changes that all pieces show; an outlier hardly counts, and after a step the pieces before it hardly do.");
        }

        HtmlTable.Write(
            html,
            "lot-table",
            "The pieces, in the order of cutting",
            [
                new("Piece"), new("Corrected, µm", true), new($"{shown}, mean, µm", true), new($"{shown}, standard deviation, µm", true),
                new("Without corrections, µm", true), new("Expected of it, µm", true), new("What happened"),
            ],
            Enumerable.Range(0, pieces.Pieces.Count),
            (row, k) =>
        {
            var (values, found) = (pieces.Pieces[k].Values, lot.Pieces[k]);
            var (mean, deviation) = Left(values.ErrorsMm);
            row.Header((k + 1).ToString(CultureInfo.InvariantCulture));
            row.Number(Micrometres.SignedOfMm(values.CorrectionsMm.Average()));
            row.Number(Micrometres.SignedOfMm(mean));
            row.Number(Micrometres.OfMm(deviation));
            row.Number(Micrometres.SignedOfMm(found.ShownMm));
            row.Number(Micrometres.SignedOfMm(found.ExpectedMm));
            row.Text(found.Event switch
            {
                LotEvent.Step => string.Create(CultureInfo.InvariantCulture, $"{Word(found.Event)} before it ({found.StepProbability:0%})"),
                LotEvent.Outlier => string.Create(CultureInfo.InvariantCulture, $"{Word(found.Event)} ({found.OutlierProbability:0%})"),
                _ => Word(found.Event),
            });
        });
    }

    private static (double Mean, double Deviation) Left(IReadOnlyList<double> errors)
    {
        var mean = errors.Average();
        return (mean, errors.Count > 1 ? Math.Sqrt(errors.Sum(e => (e - mean) * (e - mean)) / (errors.Count - 1)) : 0);
    }
}
