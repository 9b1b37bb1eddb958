using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Finds the measured counterparts of each mating that have points outside their limits. Call it from one thread at a
/// time, and not from the UI thread.</summary>
/// <param name="settings">The cell's configuration.</param>
internal sealed class MeasuredOutside(CellSettings settings)
{
    private readonly IReadOnlyList<MatingChoice> _matings = MatingChoice.Of(settings);
    private readonly Dictionary<string, long> _since = new(StringComparer.Ordinal);
    private Dictionary<long, StoredPiece?> _read = [];

    /// <summary>The counterparts outside their limits, by mating in the order of the configuration, newest first. It considers
    /// the last measurement at the first call and all later ones. A newer measurement of the same piece replaces an older one,
    /// even if all of its points are within their limits.</summary>
    /// <param name="store">The store.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlyList<StoredPiece> Now(CellStore store)
    {
        // Only recent measurements stay cached: the station may run for months.
        Dictionary<long, StoredPiece?> read = [];
        StoredPiece[] outside = [.. _matings.SelectMany(m => Measured(store, m)
            .Select(c => read[c.Id] = _read.TryGetValue(c.Id, out var known) ? known : Read(store, c)).OfType<StoredPiece>()
            .DistinctBy(p => p.Counterpart!.PartSha256 ?? Shown.Id(p.LastId))
            .Where(p => !p.IsWithin))];
        _read = read;
        return outside;
    }

    // As many as the verification lists at most. Of those made before the station started, only the last one is news.
    private IEnumerable<Correction> Measured(CellStore store, MatingChoice mating)
    {
        Correction[] measured = [
            .. store.Corrections.Reported(mating.Jobs, StoredPieces.Most).Where(
                c => c.Piece == PieceWords.Counterpart && !c.IsSetAside)];
        if (!_since.TryGetValue(mating.Name, out var since))
        {
            _since[mating.Name] = since = measured is [var newest, ..] ? newest.Id : 0;
        }

        return measured.Where(c => c.Id >= since);
    }

    // A counterpart compensated on its own has the report of a match, and nothing was verified.
    private static StoredPiece? Read(CellStore store, Correction counterpart) =>
        StoredReport.Read(store.Content(counterpart.ReportSha256!)).Verification is { } verification
            ? StoredPiece.Measured(counterpart, counterpart, verification)
            : null;
}
