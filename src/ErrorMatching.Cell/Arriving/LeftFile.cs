namespace ErrorMatching.Cell;

/// <summary>A file that fits a gauge's pattern and is left where it is.</summary>
/// <param name="Name">Its name, as it may be shown.</param>
/// <param name="Reason">Why, and what to do, in a setter's words.</param>
public sealed record LeftFile(string Name, string Reason);
