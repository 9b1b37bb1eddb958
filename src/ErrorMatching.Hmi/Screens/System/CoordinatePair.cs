namespace ErrorMatching.Hmi;

/// <summary>Points side by side in the system setup, so that a small screen shows twice as many.</summary>
/// <param name="First">The first one.</param>
/// <param name="Second">The next one; null if there is none, or if three coordinates take up the width.</param>
/// <param name="Columns">Number that fits side by side.</param>
internal sealed record CoordinatePair(CoordinateRow First, CoordinateRow? Second, int Columns)
{
    /// <summary>Arranges points side by side, line by line in order.</summary>
    public static IEnumerable<CoordinatePair> Of(IReadOnlyCollection<CoordinateRow> rows)
    {
        var columns = rows.Any(r => r.HasZ) ? 1 : 2;
        return rows.Chunk(columns).Select(r => new CoordinatePair(r[0], r.Length > 1 ? r[1] : null, columns));
    }
}
