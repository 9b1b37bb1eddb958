namespace ErrorMatching.Jobs;

/// <summary>A file cannot be written, or must not be.</summary>
public sealed class OutputException(string code, string file, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>Code of a file that cannot be written.</summary>
    public const string Unwritable = "file-unwritable";

    /// <summary>Code of an output that is one of the inputs, which are never changed.</summary>
    public const string IsInput = "output-is-input";

    /// <summary>Code of an output that must not replace an existing file.</summary>
    public const string Exists = "output-exists";

    /// <summary>Code of two outputs with the same name.</summary>
    public const string Twice = "output-twice";

    /// <summary>What is wrong: one of the codes above.</summary>
    public string Code => code;

    /// <summary>The file as the user named it.</summary>
    public string File => file;
}
