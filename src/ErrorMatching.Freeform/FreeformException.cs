using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>An input of a free-form job that cannot be used, with its place.</summary>
public sealed class FreeformException : Exception
{
    /// <summary>An error in a file.</summary>
    /// <param name="code">A stable word for scripts, such as <c>unknown-entity</c>.</param>
    /// <param name="file">Name of the file, as the caller knows it.</param>
    /// <param name="problem">What was found and what is expected, in one sentence.</param>
    /// <param name="line">Line from 1; null if the file as a whole is meant.</param>
    /// <param name="column">Column or cell from 1; null if the line as a whole is meant.</param>
    public FreeformException(string code, string file, string problem, int? line = null, int? column = null)
        : base(Place(file, line, column) + ": " + problem) => (Code, File, Problem, Line, Column) = (code, file, problem, line, column);

    /// <summary>A stable word for scripts.</summary>
    public string Code { get; }

    /// <summary>Name of the file, as the caller knows it.</summary>
    public string File { get; }

    /// <summary>What was found and what is expected, without the place.</summary>
    public string Problem { get; }

    /// <summary>Line from 1; null if the file as a whole is meant.</summary>
    public int? Line { get; }

    /// <summary>Column or cell from 1; null if the line as a whole is meant.</summary>
    public int? Column { get; }

    private static string Place(string file, int? line, int? column) => (line, column) switch
    {
        (null, _) => file,
        (_, null) => string.Create(CultureInfo.InvariantCulture, $"{file}, line {line}"),
        _ => string.Create(CultureInfo.InvariantCulture, $"{file}, line {line}, column {column}"),
    };
}
