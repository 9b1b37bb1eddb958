namespace ErrorMatching.Mating;

/// <summary>A job key that only some kinds of features have.</summary>
/// <param name="Name">The key, such as <c>method</c>.</param>
/// <param name="Words">The words that it accepts; empty for a number, or <c>auto</c> to have it chosen.</param>
public sealed record FeatureKey(string Name, IReadOnlyList<string> Words)
{
    /// <summary>The default: the first of its words; empty for a number, which is then chosen automatically.</summary>
    public string Default => Words.Count > 0 ? Words[0] : "";
}
