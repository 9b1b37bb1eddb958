using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The last pieces of a mating in the store. Each report is read only once, because it never changes.</summary>
internal sealed class StoredPieces
{
    /// <summary>How many measurements of a mating are considered when its last pieces are listed.</summary>
    public const int Most = 60;

    private readonly Dictionary<string, StoredReport> _read = new(StringComparer.Ordinal);

    /// <summary>The pieces in order of arrival. Slow: do not call it on the UI thread.</summary>
    /// <param name="store">The store.</param>
    /// <param name="jobs">The cell's jobs that share the mating's file: those of parts and those of counterparts.</param>
    /// <param name="most">How many measurements are considered.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlyList<StoredPiece> Read(CellStore store, IReadOnlyList<string> jobs, int most)
    {
        ArgumentNullException.ThrowIfNull(store);
        var pieces = new List<StoredPiece>();

        // What was set aside was never cut.
        foreach (var correction in store.Corrections.Reported(jobs, most)
            .Where(c => !c.IsSetAside)
            .OrderBy(c => c.Turn)
            .ThenBy(c => c.Id))
        {
            var report = Report(store, correction.ReportSha256!);
            if (report.Match is { } match)
            {
                pieces.Add(StoredPiece.Predicted(correction, match));
            }
            else if (report.Verification is { } verification)
            {
                // A measurement replaces the piece's prediction.
                var at = pieces.FindLastIndex(p => p.Correction.MeasurementSha256 == correction.PartSha256);
                var predicted = at >= 0 ? pieces[at] : null;
                var measured = StoredPiece.Measured(predicted?.Correction ?? correction, correction, verification) with
                {
                    Match = predicted?.Match
                };
                if (at >= 0)
                {
                    pieces[at] = measured;
                }
                else
                {
                    pieces.Add(measured);
                }
            }
        }

        return pieces;
    }

    private StoredReport Report(CellStore store, string sha256)
    {
        if (!_read.TryGetValue(sha256, out var report))
        {
            _read[sha256] = report = StoredReport.Read(store.Content(sha256));
        }

        return report;
    }
}
