namespace ErrorMatching.Mating;

/// <summary>The kinds of features that there are.</summary>
public static class FeatureKinds
{
    /// <summary>All of them, in the order in which they are offered. A new kind is a line here and a folder beside this file.</summary>
    public static IReadOnlyList<FeatureKind> All { get; } =
    [
        LineKind.Instance,
        TriangleKind.Instance,
        CurveKind.Instance,
        CircleKind.Instance,
        SlotKind.Instance,
    ];

    /// <summary>The kind of a word.</summary>
    /// <returns>The kind; null if none has the word.</returns>
    public static FeatureKind? Find(string word) => All.FirstOrDefault(k => k.Word == word);

    /// <summary>The kind of a word that the schema of a job allows.</summary>
    /// <exception cref="ArgumentException">No kind has the word.</exception>
    public static FeatureKind Of(string word) =>
        Find(word) ?? throw new ArgumentException($"Found the kind \"{word}\"; expected one of {string.Join(", ", All)}.", nameof(word));
}
