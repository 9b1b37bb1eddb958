namespace ErrorMatching.Nc;

/// <summary>A branch on a value that only the machine knows, after both ways were executed.</summary>
/// <param name="Way">The way that the run takes: true where the condition holds, or where block skip is on.</param>
/// <param name="Join">Where both ways meet; null if the other one ends the program.</param>
/// <param name="Differs">True if the motions of the two ways differ.</param>
/// <param name="Blocks">Blocks of the program that move in only one of the ways.</param>
/// <param name="Forgotten">Variables that differ where the ways meet.</param>
internal sealed record Fork(
    bool Way, string? Join, bool Differs, IReadOnlyCollection<int> Blocks, IReadOnlyCollection<VariableKey> Forgotten)
{
    /// <summary>A way that is being tried.</summary>
    public static Fork Tried(bool way) => new(way, null, Differs: false, [], []);
}
