namespace ErrorMatching.Json;

/// <summary>A JSON document that cannot be used, with everything that is wrong in it.</summary>
public sealed class JsonDocumentException : Exception
{
    /// <summary>An error with its problems.</summary>
    /// <param name="file">Name of the file, as the caller knows it.</param>
    /// <param name="problems">At least one problem, in the order of the document.</param>
    public JsonDocumentException(string file, IReadOnlyList<JsonProblem> problems)
        : base(string.Join('\n', (problems ?? throw new ArgumentNullException(nameof(problems))).Select(p => $"{file}:{p}")))
    {
        (File, Problems) = (file, problems);
    }

    /// <summary>Name of the file, as the caller knows it.</summary>
    public string File { get; }

    /// <summary>Everything that is wrong, in the order of the document.</summary>
    public IReadOnlyList<JsonProblem> Problems { get; }
}
