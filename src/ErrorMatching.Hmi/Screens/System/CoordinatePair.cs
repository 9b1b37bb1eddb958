namespace ErrorMatching.Hmi;

/// <summary>Points that stand beside each other in the system set-up: a small screen shows twice as many.</summary>
/// <param name="First">The first one.</param>
/// <param name="Second">The one behind it; null if there is none, or three coordinates take the width.</param>
/// <param name="Columns">How many have room side by side.</param>
public sealed record CoordinatePair(CoordinateRow First, CoordinateRow? Second, int Columns)
{
    /// <summary>Points beside each other, line by line in their order.</summary>
    public static IEnumerable<CoordinatePair> Of(IReadOnlyCollection<CoordinateRow> rows)
    {
        var columns = rows.Any(r => r.HasZ) ? 1 : 2;
        return rows.Chunk(columns).Select(r => new CoordinatePair(r[0], r.Length > 1 ? r[1] : null, columns));
    }
}
