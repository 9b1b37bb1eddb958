using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>A job that cannot be used, with everything that is wrong in it.</summary>
public sealed class JobException : Exception
{
    /// <summary>An error with its problems.</summary>
    /// <param name="file">Name of the file, as the caller knows it.</param>
    /// <param name="problems">At least one problem, in the order of the document.</param>
    /// <param name="cause">The error that led here, if there was one.</param>
    public JobException(string file, IReadOnlyList<JsonProblem> problems, Exception? cause = null)
        : base(string.Join('\n', (problems ?? throw new ArgumentNullException(nameof(problems))).Select(p => $"{file}:{p}")), cause)
    {
        (File, Problems) = (file, problems);
    }

    /// <summary>Name of the file, as the caller knows it.</summary>
    public string File { get; }

    /// <summary>Everything that is wrong, in the order of the document;
    /// each with code, JSON path, line, column, what was found and what is expected.</summary>
    public IReadOnlyList<JsonProblem> Problems { get; }
}
