namespace ErrorMatching.Mating;

/// <summary>A key of a feature in a job that not all kinds have.</summary>
/// <param name="Name">The key: <c>method</c>.</param>
/// <param name="Words">The words that it takes; empty for a number, or <c>auto</c> to have it chosen.</param>
public sealed record FeatureKey(string Name, IReadOnlyList<string> Words)
{
    /// <summary>What holds where the job does not have it: the first of its words; empty for a number, which then is chosen.</summary>
    public string Default => Words.Count > 0 ? Words[0] : "";
}
