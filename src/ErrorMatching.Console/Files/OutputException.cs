namespace ErrorMatching.Console;

/// <summary>A file that cannot be written, or must not be.</summary>
internal sealed class OutputException(string file, bool isInput, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>The file as the user named it.</summary>
    public string File => file;

    /// <summary>True if the file is one of the inputs, which are never changed.</summary>
    public bool IsInput => isInput;
}
