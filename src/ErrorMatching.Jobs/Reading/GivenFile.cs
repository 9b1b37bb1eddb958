using System.Diagnostics.CodeAnalysis;
using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>A file given in addition to the job, with its content if the caller has it already.</summary>
/// <param name="File">Its name, for messages, reports and source rules; also the path to read it from if no content is given.</param>
/// <param name="Bytes">Its content; null if it is to be read.</param>
public sealed record GivenFile(string File, ReadOnlyMemory<byte>? Bytes = null)
{
    /// <summary>Its name, stated with <c>/</c> on every system.</summary>
    public string File { get; } = PathText.Of(File);

    /// <summary>The file of a path; null for none.</summary>
    [return: NotNullIfNotNull(nameof(path))]
    public static GivenFile? At(string? path) => path is null ? null : new(path);
}
