namespace ErrorMatching.Cell;

/// <summary>A measurement that is given again, to be computed anew: it is of the same piece as before, so whatever was measured since, it is compared with the same part, and was cut by the same program.</summary>
internal sealed class GivenAgain
{
    private readonly CellStore _store;
    private readonly Correction _first;

    private GivenAgain(CellStore store, Correction first) => (_store, _first) = (store, first);

    /// <summary>What cut it, where corrections add up; null where that was not found out before.</summary>
    public CutProgram? Cut => _first.SumsSha256 is null ? null : new(CutProgram.Before(_store, _first), null);

    /// <summary>The part that it was compared with; null if there was none.</summary>
    public Correction? Part => _first.PartSha256 is { } part ? _store.OfMeasurement(part).LastOrDefault(c => c.Piece == "part") : null;

    /// <summary>Finds out whether a measurement is given again.</summary>
    /// <param name="store">The store.</param>
    /// <param name="known">Its correction, with job and piece.</param>
    /// <returns>Null if it came in by itself, or is taken for another piece than before.</returns>
    public static GivenAgain? Of(CellStore store, Correction known) =>
        known.MeasuredAs is { } id && store.Find(id) is { } first && first.Job == known.Job && first.Piece == known.Piece ? new(store, first) : null;
}
