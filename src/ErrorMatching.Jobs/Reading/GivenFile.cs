using System.Diagnostics.CodeAnalysis;

namespace ErrorMatching.Jobs;

/// <summary>A file that is named beside the job, with its content where the caller has it already.</summary>
/// <param name="File">Its name, for messages, reports and rules about the source; the path to read it from where the content is not given.</param>
/// <param name="Bytes">Its content; null if it is to be read.</param>
public sealed record GivenFile(string File, ReadOnlyMemory<byte>? Bytes = null)
{
    /// <summary>The file of a path; null for none.</summary>
    [return: NotNullIfNotNull(nameof(path))]
    public static GivenFile? At(string? path) => path is null ? null : new(path);
}
