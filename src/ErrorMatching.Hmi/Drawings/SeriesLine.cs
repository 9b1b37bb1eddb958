namespace ErrorMatching.Hmi;

/// <summary>One line of a plot over a series.</summary>
/// <param name="Kind">What it stands for.</param>
/// <param name="Name">What the legend calls it.</param>
/// <param name="Values">A value for each place of the series; null where there is none.</param>
public sealed record SeriesLine(SeriesKind Kind, string Name, IReadOnlyList<double?> Values)
{
    /// <summary>Places that this line does not lead to from the place before, beside those of the whole drawing.</summary>
    public IReadOnlySet<int> Beginnings { get; init; } = new HashSet<int>();
}
