using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The last pieces of a mating in the store. Each report is read only once, because it never changes.</summary>
public sealed class KeptPieces
{
    /// <summary>How many measurements of a mating are considered when its last pieces are listed.</summary>
    public const int Most = 60;

    private readonly Dictionary<string, (KeptReport? Match, KeptVerification? Verification)> _read = new(StringComparer.Ordinal);

    /// <summary>The pieces in order of arrival. Slow: do not call it on the UI thread.</summary>
    /// <param name="store">The store.</param>
    /// <param name="jobs">The cell's jobs that share the mating's file: those of parts and those of counterparts.</param>
    /// <param name="most">How many measurements are considered.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlyList<KeptPiece> Read(CellStore store, IReadOnlyList<string> jobs, int most)
    {
        ArgumentNullException.ThrowIfNull(store);
        var pieces = new List<KeptPiece>();

        // Rejected and superseded corrections were never cut.
        foreach (var correction in store.Reported(jobs, most)
            .Where(c => c.State is not (CorrectionState.Rejected or CorrectionState.Superseded))
            .OrderBy(c => c.Turn)
            .ThenBy(c => c.Id))
        {
            var (match, verification) = Report(store, correction.ReportSha256!);
            if (match is not null)
            {
                pieces.Add(KeptPiece.Predicted(correction, match));
            }
            else if (verification is not null)
            {
                // A measurement replaces the piece's prediction.
                var at = pieces.FindLastIndex(p => p.Correction.MeasurementSha256 == correction.PartSha256);
                var measured = new KeptPiece(
                    at >= 0 ? pieces[at].Correction : correction,
                    correction,
                    verification.JobName,
                    verification.Result,
                    verification.Boundaries,
                    verification.IsBeforeMeasured)
                {
                    Before = verification.Before,
                    Match = at >= 0 ? pieces[at].Match : null
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

    private (KeptReport? Match, KeptVerification? Verification) Report(CellStore store, string sha256)
    {
        if (!_read.TryGetValue(sha256, out var report))
        {
            var json = store.Content(sha256);
            report = (KeptReport.Read(json), KeptVerification.Read(json));
            _read[sha256] = report;
        }

        return report;
    }
}
