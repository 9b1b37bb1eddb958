namespace ErrorMatching.Jobs;

/// <summary>What came of putting a <see cref="PointTable"/> into a draft.</summary>
/// <param name="Draft">The draft with the coordinates; where it was refused, the draft as it was.</param>
/// <param name="Refusal">Why nothing was taken, if so.</param>
public sealed record TakenTable(MatingDraft Draft, PointTableRefusal Refusal = PointTableRefusal.None)
{
    /// <summary>True if points took their labels from the table, in its order.</summary>
    public bool HasNewLabels { get; init; }

    /// <summary>The table's labels that no point had, in its order; of <see cref="PointTableRefusal.LabelTwice"/> those that stand there
    /// more than once.</summary>
    public IReadOnlyList<string> OnlyInTable { get; init; } = [];

    /// <summary>Labels of the features' points that the table says nothing about, in their order.</summary>
    public IReadOnlyList<string> OnlyInFeatures { get; init; } = [];

    /// <summary>How many rows were left for points that wait for their labels, where they are not as many.</summary>
    public int Rows { get; init; }

    /// <summary>How many points these are.</summary>
    public int Points { get; init; }
}
