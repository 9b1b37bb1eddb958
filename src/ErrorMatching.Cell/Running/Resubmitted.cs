namespace ErrorMatching.Cell;

/// <summary>A measurement that is resubmitted for recalculation. It is of the same piece as before: it is compared with the same part and
/// was cut by the same program, whatever has been measured since.</summary>
internal sealed class Resubmitted
{
    private readonly CellStore _store;
    private readonly Correction _first;

    private Resubmitted(CellStore store, Correction first) => (_store, _first) = (store, first);

    /// <summary>The program that cut it, if corrections accumulate; null if that was not determined before.</summary>
    public CutProgram? Cut => _first.SumsSha256 is null ? null : new(CutProgram.Before(_store, _first), null);

    /// <summary>The part that it was compared with; null if there was none.</summary>
    public Correction? Part => _first.PartSha256 is { } part ? _store.OfMeasurement(part).LastOrDefault(c => c.Piece == "part") : null;

    /// <summary>Determines whether a measurement was resubmitted.</summary>
    /// <param name="store">The store.</param>
    /// <param name="known">Its correction, with job and piece.</param>
    /// <returns>Null if it arrived from its gauge, or is now recognized as another piece.</returns>
    public static Resubmitted? Of(CellStore store, Correction known) =>
        known.MeasuredAs is { } id && store.Find(id) is { } first && first.Job == known.Job && first.Piece == known.Piece
            ? new(store, first)
            : null;
}
