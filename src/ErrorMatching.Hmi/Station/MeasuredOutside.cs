using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Looks at the counterpart of each mating that was measured last, whether it has points outside of their limits. To be asked by one thread at a time, and not by the screen's.</summary>
/// <param name="settings">The cell's configuration.</param>
internal sealed class MeasuredOutside(CellSettings settings)
{
    private readonly IReadOnlyList<MatingChoice> _matings = MatingChoice.Of(settings);
    private readonly Dictionary<string, (long Newest, KeptPiece? Piece)> _read = new(StringComparer.Ordinal);

    /// <summary>Those that have, in the order of the configuration. A newer measurement takes the place of an older one, also where all of its points are within.</summary>
    /// <param name="store">The store.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlyList<KeptPiece> Now(CellStore store) => [.. _matings.Select(m => Last(store, m)).OfType<KeptPiece>().Where(p => !p.IsWithin)];

    private KeptPiece? Last(CellStore store, MatingChoice mating)
    {
        Correction[] measured = [.. store.Reported(mating.Jobs, KeptPieces.Most).Where(c => c.Piece == "counterpart" && c.State is not (CorrectionState.Rejected or CorrectionState.Superseded))];
        if (measured is not [var newest, ..])
        {
            return null;
        }

        if (!_read.TryGetValue(mating.Name, out var last) || last.Newest != newest.Id)
        {
            _read[mating.Name] = last = (newest.Id, measured.Select(c => Read(store, c)).FirstOrDefault(p => p is not null));
        }

        return last.Piece;
    }

    // A counterpart that is compensated by itself has the report of a match, and nothing was verified.
    private static KeptPiece? Read(CellStore store, Correction counterpart) =>
        KeptVerification.Read(store.Content(counterpart.ReportSha256!)) is { } v ? new(counterpart, counterpart, v.JobName, v.Result, v.Boundaries, v.IsBeforeMeasured) { Before = v.Before } : null;
}
