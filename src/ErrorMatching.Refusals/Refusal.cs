namespace ErrorMatching.Refusals;

/// <summary>Why an input or a result must not be used.</summary>
/// <param name="Code">A stable identifier for scripts, such as <c>block-not-found</c>; listed in docs/reference-console.md.</param>
/// <param name="Message">What was found, what is expected and what to do, in a setter's words. It names a block or feature concerned,
/// but not a file or a line that <see cref="Place"/> names.</param>
/// <param name="Place">Where the input is at fault.</param>
public sealed record Refusal(string Code, string Message, InputPlace Place)
{
    /// <summary>Creates a refusal that concerns no place, or names it in its message.</summary>
    public Refusal(string code, string message)
        : this(code, message, InputPlace.None)
    {
    }

    /// <summary>What was found, as the middle of a sentence; empty if the message has no such part.</summary>
    public string Found { get; init; } = "";

    /// <summary>What is expected, as the end of a sentence without a period; empty if the message has no such part.</summary>
    public string Expected { get; init; } = "";

    /// <summary>The values in the message, in their order, for a text in another language.</summary>
    public IReadOnlyList<string> Values { get; init; } = [];

    /// <summary>True if the message names the file itself, as one about a whole file may do.</summary>
    public bool NamesFile => Place is { Line: null, File: { } file } && Message.Contains(file, StringComparison.Ordinal);

    /// <summary>The message with its place in front: file, line, column and path, or only the file if the message names a block.</summary>
    public string Sentence
    {
        get
        {
            var place = NamesFile ? "" : Place.Block is null ? Place.ToString() : Place.File ?? "";
            return place.Length == 0 ? Message : $"{place}: {Message}";
        }
    }

    /// <summary>A refusal of the form "found ...; expected ...".</summary>
    /// <param name="code">A stable identifier for scripts.</param>
    /// <param name="found">The finding, as the middle of a sentence.</param>
    /// <param name="expected">The expectation or remedy, as the end of a sentence without a period.</param>
    /// <param name="place">Where the input is at fault.</param>
    public static Refusal Of(string code, string found, string expected, InputPlace? place = null) =>
        new(code, $"found {found}; expected {expected}.", place ?? InputPlace.None) { Found = found, Expected = expected };

    /// <summary>The same refusal about a file, if it names none yet.</summary>
    public Refusal In(string file) => Place.File is null ? this with { Place = Place with { File = file } } : this;

    /// <summary>The sentence.</summary>
    public override string ToString() => Sentence;
}
