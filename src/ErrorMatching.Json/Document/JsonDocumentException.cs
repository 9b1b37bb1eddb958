namespace ErrorMatching.Json;

/// <summary>An unusable JSON document, with all its problems.</summary>
public sealed class JsonDocumentException : Exception
{
    /// <summary>Creates an exception with its problems.</summary>
    /// <param name="file">The file name, as given by the caller.</param>
    /// <param name="problems">At least one problem, in the order of the document.</param>
    public JsonDocumentException(string file, IReadOnlyList<JsonProblem> problems)
        : base(string.Join('\n', (problems ?? throw new ArgumentNullException(nameof(problems))).Select(p => $"{file}:{p}")))
    {
        (File, Problems) = (file, problems);
    }

    /// <summary>The file name, as given by the caller.</summary>
    public string File { get; }

    /// <summary>All problems, in the order of the document.</summary>
    public IReadOnlyList<JsonProblem> Problems { get; }
}
