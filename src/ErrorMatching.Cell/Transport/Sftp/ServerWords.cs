namespace ErrorMatching.Cell;

/// <summary>What a server said, as far as a message may repeat it.</summary>
internal static class ServerWords
{
    private const int Most = 200;

    /// <summary>The words without control characters, shortened.</summary>
    public static string Of(string said) =>
        string.Concat(said.Take(Most).Select(c => char.IsControl(c) || char.IsSurrogate(c) ? ' ' : c)).Trim()
        + (said.Length > Most ? "..." : "");
}
