using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>An unusable input of a free-form job, with its location.</summary>
public sealed class FreeformException : Exception
{
    /// <summary>An error in a file.</summary>
    /// <param name="code">A stable identifier for scripts, such as <c>unknown-entity</c>.</param>
    /// <param name="file">The file name, as given by the caller.</param>
    /// <param name="problem">The finding and the expectation, in one sentence.</param>
    /// <param name="line">Line from 1; null for the whole file.</param>
    /// <param name="column">Column or cell from 1; null for the whole line.</param>
    public FreeformException(string code, string file, string problem, int? line = null, int? column = null)
        : base(Place(file, line, column) + ": " + problem) => (Code, File, Problem, Line, Column) = (code, file, problem, line, column);

    /// <summary>A stable identifier for scripts.</summary>
    public string Code { get; }

    /// <summary>The file name, as given by the caller.</summary>
    public string File { get; }

    /// <summary>The finding and the expectation, without the location.</summary>
    public string Problem { get; }

    /// <summary>Line from 1; null for the whole file.</summary>
    public int? Line { get; }

    /// <summary>Column or cell from 1; null for the whole line.</summary>
    public int? Column { get; }

    private static string Place(string file, int? line, int? column) => (line, column) switch
    {
        (null, _) => file,
        (_, null) => string.Create(CultureInfo.InvariantCulture, $"{file}, line {line}"),
        _ => string.Create(CultureInfo.InvariantCulture, $"{file}, line {line}, column {column}"),
    };
}
