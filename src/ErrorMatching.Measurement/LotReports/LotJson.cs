using ErrorMatching.Reporting;

namespace ErrorMatching.Measurement;

/// <summary>Writes a lot into a report, and reads it.</summary>
public static class LotJson
{
    /// <summary>Writes it into the open object.</summary>
    /// <param name="json">The open object.</param>
    /// <param name="pieces">The pieces.</param>
    /// <param name="lot">What they say about the next one; null for a first piece.</param>
    public static void Write(ReportWriter json, MeasuredLot pieces, Lot? lot)
    {
        ArgumentNullException.ThrowIfNull(json);
        ArgumentNullException.ThrowIfNull(pieces);
        json.Texts("points", pieces.Points);
        json.Numbers("correctionsUm", pieces.CorrectionsMm.Select(c => c * 1000));
        json.List("pieces", Enumerable.Range(0, pieces.Pieces.Count), k =>
        {
            var piece = pieces.Pieces[k];
            json.Text("measuredSha256", piece.MeasuredSha256);
            json.Number("noiseUm", piece.NoiseMm * 1000);
            json.Numbers("errorsUm", piece.Values.ErrorsMm.Select(e => e * 1000));
            json.Numbers("correctionsUm", piece.Values.CorrectionsMm.Select(c => c * 1000));
            if (piece.Values.IsAfterToolChange)
            {
                json.Flag("toolChanged", true);
            }

            if (lot is not null)
            {
                var found = lot.Pieces[k];
                json.Number("shownUm", found.ShownMm * 1000);
                json.Number("expectedUm", found.ExpectedMm * 1000);
                json.Number("stepProbability", found.StepProbability);
                json.Number("outlierProbability", found.OutlierProbability);
            }
        });
        if (lot is not null)
        {
            json.Object("next", () =>
            {
                json.Numbers("expectedUm", lot.ExpectedMm.Select(e => e * 1000));
                json.Numbers("uncertaintyUm", lot.UncertaintyMm.Select(u => u * 1000));
                json.Number("driftUm", lot.DriftMm * 1000);
                json.Number("driftUncertaintyUm", lot.DriftUncertaintyMm * 1000);
                json.Number("noiseUm", lot.NoiseMm * 1000);
            });
        }
    }

    /// <summary>Reads the lot of a report.</summary>
    /// <param name="report">The report of a compensation.</param>
    /// <returns>The pieces, and what they say about the next one; null for what the report does not have.</returns>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static (MeasuredLot? Pieces, Lot? Lot) Read(ReportReader report)
    {
        ArgumentNullException.ThrowIfNull(report);
        if (report.OptionalObject("lot") is not { } json)
        {
            return (null, null);
        }

        var points = json.Labels("points");
        var pieces = json.List("pieces", p => new RecordedPiece(
            p.Text("measuredSha256"),
            p.Micrometers("noiseUm"),
            new(Mm(p, "errorsUm", points.Count), Mm(p, "correctionsUm", points.Count))
            {
                IsAfterToolChange = p.OptionalFlag("toolChanged") ?? false,
            }));
        if (points.Count == 0 || pieces.Count == 0)
        {
            throw json.Refusal(points.Count == 0 ? "points" : "pieces", "too-few-items", "at least one");
        }

        var lot = new MeasuredLot(points, pieces, Mm(json, "correctionsUm", points.Count));
        return (lot, json.OptionalObject("next") is not { } next ? null : new Lot(
            Mm(next, "expectedUm", points.Count),
            Mm(next, "uncertaintyUm", points.Count),
            next.Micrometers("driftUm"),
            next.Micrometers("driftUncertaintyUm"),
            next.Micrometers("noiseUm"),
            json.List("pieces", p => new LotFinding(
                p.Micrometers("shownUm"), p.Micrometers("expectedUm"), p.Number("stepProbability"), p.Number("outlierProbability")))));
    }

    private static double[] Mm(ReportReader json, string name, int count) => [.. json.Numbers(name, count).Select(um => um / 1000)];
}
