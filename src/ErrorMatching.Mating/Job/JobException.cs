using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>Thrown for a job that cannot be used, with everything that is wrong in it.</summary>
public sealed class JobException : Exception
{
    /// <summary>Creates an exception with its problems.</summary>
    /// <param name="file">Name of the file, as the caller knows it.</param>
    /// <param name="problems">At least one problem, in the order of the document.</param>
    /// <param name="cause">The underlying error, or null.</param>
    public JobException(string file, IReadOnlyList<JsonProblem> problems, Exception? cause = null)
        : base(string.Join('\n', (problems ?? throw new ArgumentNullException(nameof(problems))).Select(p => $"{file}:{p}")), cause)
    {
        (File, Problems) = (file, problems);
    }

    /// <summary>Name of the file, as the caller knows it.</summary>
    public string File { get; }

    /// <summary>All problems in the order of the document, each with code, JSON path, line, column, what was found and what is
    /// expected.</summary>
    public IReadOnlyList<JsonProblem> Problems { get; }
}
