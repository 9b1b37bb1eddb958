namespace ErrorMatching.Jobs;

/// <summary>A file of the user cannot be opened.</summary>
public sealed class InputException(string file, string message, Exception cause) : Exception(message, cause)
{
    /// <summary>The file as the user named it.</summary>
    public string File => file;

    /// <summary>Where a job names it; null for a file from the command line.</summary>
    public NamedPlace? NamedAt { get; init; }
}
