namespace ErrorMatching.Refusals;

/// <summary>An input that cannot be read or used at all, with everything that is wrong in it.</summary>
public sealed class InputException : Exception
{
    /// <summary>Creates an exception with its reasons.</summary>
    /// <param name="refusals">At least one, in the order of the input.</param>
    /// <param name="cause">The underlying error, or null.</param>
    public InputException(IReadOnlyList<Refusal> refusals, Exception? cause = null)
        : base(string.Join('\n', (refusals ?? throw new ArgumentNullException(nameof(refusals))).Select(r => r.Sentence)), cause)
    {
        ArgumentOutOfRangeException.ThrowIfZero(refusals.Count, nameof(refusals));
        Refusals = refusals;
    }

    /// <summary>Creates an exception about one file.</summary>
    /// <param name="file">The file as the caller knows it; named by each reason that names none.</param>
    /// <param name="refusals">At least one, in the order of the file.</param>
    /// <param name="cause">The underlying error, or null.</param>
    public InputException(string file, IReadOnlyList<Refusal> refusals, Exception? cause = null)
        : this([.. (refusals ?? throw new ArgumentNullException(nameof(refusals))).Select(r => r.In(file))], cause)
    {
    }

    /// <summary>Creates an exception with one reason.</summary>
    /// <param name="refusal">The reason.</param>
    /// <param name="cause">The underlying error, or null.</param>
    public InputException(Refusal refusal, Exception? cause = null)
        : this([refusal], cause)
    {
    }

    /// <summary>All reasons, in the order of the input; at least one.</summary>
    public IReadOnlyList<Refusal> Refusals { get; }

    /// <summary>The code of the first reason.</summary>
    public string Code => Refusals[0].Code;

    /// <summary>The place of the first reason.</summary>
    public InputPlace Place => Refusals[0].Place;

    /// <summary>The message of the first reason, without its place.</summary>
    public string Problem => Refusals[0].Message;

    /// <summary>The file of the first reason, or null.</summary>
    public string? File => Place.File;

    /// <summary>An exception with one reason.</summary>
    /// <param name="code">A stable identifier for scripts, such as <c>unknown-entity</c>.</param>
    /// <param name="file">The file as the caller knows it.</param>
    /// <param name="message">The finding and the expectation, in one sentence.</param>
    /// <param name="line">Line from 1; null for the whole file.</param>
    /// <param name="column">Column or cell from 1; null for the whole line.</param>
    public static InputException At(string code, string file, string message, int? line = null, int? column = null) =>
        new(new Refusal(code, message, new() { File = file, Line = line, Column = column }));
}
