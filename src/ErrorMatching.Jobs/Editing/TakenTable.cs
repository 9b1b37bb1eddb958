namespace ErrorMatching.Jobs;

/// <summary>The result of putting a <see cref="PointTable"/> into a draft.</summary>
/// <param name="Draft">The draft with the coordinates; unchanged if refused.</param>
/// <param name="Refusal">Why nothing was taken, if refused.</param>
public sealed record TakenTable(MatingDraft Draft, PointTableRefusal Refusal = PointTableRefusal.None)
{
    /// <summary>True if points took their labels from the table, in its order.</summary>
    public bool HasNewLabels { get; init; }

    /// <summary>The table's labels without a point, in its order; the duplicate labels for
    /// <see cref="PointTableRefusal.LabelTwice"/>.</summary>
    public IReadOnlyList<string> OnlyInTable { get; init; } = [];

    /// <summary>Labels of the features' points that are not in the table, in their order.</summary>
    public IReadOnlyList<string> OnlyInFeatures { get; init; } = [];

    /// <summary>Number of rows left for the points, if the numbers differ.</summary>
    public int Rows { get; init; }

    /// <summary>Number of those points.</summary>
    public int Points { get; init; }
}
