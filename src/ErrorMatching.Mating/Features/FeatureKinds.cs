namespace ErrorMatching.Mating;

/// <summary>All kinds of features.</summary>
public static class FeatureKinds
{
    /// <summary>The kinds in the order in which they are offered. To add a kind, add a line here and a folder next to this
    /// file.</summary>
    public static IReadOnlyList<FeatureKind> All { get; } =
    [
        LineKind.Instance,
        TriangleKind.Instance,
        CurveKind.Instance,
        CircleKind.Instance,
        SlotKind.Instance,
    ];

    /// <summary>Finds a kind by its word; null if there is none.</summary>
    public static FeatureKind? Find(string word) => All.FirstOrDefault(k => k.Word == word);

    /// <summary>The kind of a word that the schema of a job allows.</summary>
    /// <exception cref="ArgumentException">No kind has the word.</exception>
    public static FeatureKind Of(string word) =>
        Find(word) ?? throw new ArgumentException($"Found the kind \"{word}\"; expected one of {string.Join(", ", All)}.", nameof(word));
}
