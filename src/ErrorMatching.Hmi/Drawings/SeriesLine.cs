namespace ErrorMatching.Hmi;

/// <summary>One line of a series plot.</summary>
/// <param name="Kind">Its meaning.</param>
/// <param name="Name">Its name in the legend.</param>
/// <param name="Values">The value at each place; null if there is none.</param>
internal sealed record SeriesLine(SeriesKind Kind, string Name, IReadOnlyList<double?> Values)
{
    /// <summary>Places that this line does not join to the previous place, in addition to those of the whole drawing.</summary>
    public IReadOnlySet<int> Beginnings { get; init; } = new HashSet<int>();
}
