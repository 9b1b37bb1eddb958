using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The section of a report that shows what the pieces of a lot did, and why the next correction is what it is.</summary>
public static class LotSection
{
    /// <summary>The section; none for the first piece.</summary>
    /// <param name="result">The compensation.</param>
    public static IEnumerable<PageSection> Of(CompensationResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        return result.Lot is not { } lot ? [] : [new("lot", "The pieces so far", html => Write(html, result.Pieces, lot))];
    }

    /// <summary>The word for what happened at a piece.</summary>
    internal static string Word(LotEvent happened) => happened switch
    {
        LotEvent.None => "as expected",
        LotEvent.Step => "the process moved",
        LotEvent.Outlier => "an outlier",
        _ => throw new ArgumentOutOfRangeException(nameof(happened), happened, "Unknown event."),
    };

    private static void Write(HtmlText html, SurfaceLot pieces, Lot lot)
    {
        using (html.In("figure"))
        {
            new LotPlot(pieces, lot).Write(html);
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
                new("Piece"), new("Corrected, µm", true), new("Left, mean, µm", true), new("Left, standard deviation, µm", true),
                new("Without corrections, µm", true), new("Expected of it, µm", true), new("What happened"),
            ],
            Enumerable.Range(0, pieces.Pieces.Count),
            (row, k) =>
        {
            var (values, found) = (pieces.Pieces[k].Values, lot.Pieces[k]);
            var left = DeviationStatistics.Of([.. values.ErrorsMm]);
            row.Header((k + 1).ToString(CultureInfo.InvariantCulture));
            row.Number(Micrometres.SignedOfMm(values.CorrectionsMm.Average()));
            row.Number(Micrometres.SignedOfMm(left.MeanMm));
            row.Number(Micrometres.OfMm(left.StandardDeviationMm));
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
}
