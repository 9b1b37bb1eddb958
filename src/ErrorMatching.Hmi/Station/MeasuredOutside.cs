using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Looks at the counterparts of each mating that were measured last, which of them have points outside of their limits. To be asked by one thread at a time, and not by the screen's.</summary>
/// <param name="settings">The cell's configuration.</param>
internal sealed class MeasuredOutside(CellSettings settings)
{
    private readonly IReadOnlyList<MatingChoice> _matings = MatingChoice.Of(settings);
    private readonly Dictionary<string, long> _since = new(StringComparer.Ordinal);
    private Dictionary<long, KeptPiece?> _read = [];

    /// <summary>Those that have, of each mating in the order of the configuration the newest first: what was measured last when this was asked for the first time, and all since. A newer measurement of the same piece takes the place of an older one, also where all of its points are within.</summary>
    /// <param name="store">The store.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlyList<KeptPiece> Now(CellStore store)
    {
        // What is not among the last any more is forgotten: the station may run for months.
        Dictionary<long, KeptPiece?> read = [];
        KeptPiece[] outside = [.. _matings.SelectMany(m => Measured(store, m)
            .Select(c => read[c.Id] = _read.TryGetValue(c.Id, out var known) ? known : Read(store, c)).OfType<KeptPiece>()
            .DistinctBy(p => p.Counterpart!.PartSha256 ?? Shown.Id(p.LastId))
            .Where(p => !p.IsWithin))];
        _read = read;
        return outside;
    }

    // As many as the verification lists at most. What was measured before the station was started, all but the last, is no news of it.
    private IEnumerable<Correction> Measured(CellStore store, MatingChoice mating)
    {
        Correction[] measured = [.. store.Reported(mating.Jobs, KeptPieces.Most).Where(c => c.Piece == "counterpart" && c.State is not (CorrectionState.Rejected or CorrectionState.Superseded))];
        if (!_since.TryGetValue(mating.Name, out var since))
        {
            _since[mating.Name] = since = measured is [var newest, ..] ? newest.Id : 0;
        }

        return measured.Where(c => c.Id >= since);
    }

    // A counterpart that is compensated by itself has the report of a match, and nothing was verified.
    private static KeptPiece? Read(CellStore store, Correction counterpart) =>
        KeptVerification.Read(store.Content(counterpart.ReportSha256!)) is { } v ? new(counterpart, counterpart, v.JobName, v.Result, v.Boundaries, v.IsBeforeMeasured) { Before = v.Before } : null;
}
