namespace ErrorMatching.Cell;

/// <summary>A file that matches a gauge's pattern and is left where it is.</summary>
/// <param name="Name">Its name, made safe for display.</param>
/// <param name="Reason">Why, and what to do, in a setter's terms.</param>
public sealed record LeftFile(string Name, string Reason);
