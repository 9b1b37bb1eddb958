using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The forms of what the cell states about archives.</summary>
public static class RecordedThinning
{
    /// <summary>The word of the audit trail's entries about an archive.</summary>
    internal const string Thinned = "thinned";

    /// <summary>The subject of such an entry: the archive's name.</summary>
    public static SentenceForm Archive { get; } = new("archive", "archive {0}");

    /// <summary>What was moved: number of contents, stored bytes, SHA-256 of the archive, the date of the policy, and how many corrections
    /// of each slot stay.</summary>
    public static SentenceForm Moved { get; } = new(
        "contents-moved",
        "{0:0} contents with {1:0} bytes were moved there; SHA-256 of the file {2}. They belong to corrections from before "
            + "{3:yyyy-MM-dd} that are not among the last {4:0} of their slots, and that nothing needs any more.");

    internal static readonly SentenceForm Unrecorded = new(
        "archive-unrecorded",
        "Content {0} is said to be in the archive {1}, and no entry of the audit trail says that it was moved there.");

    internal static readonly SentenceForm Lacks = new("archive-lacks", "Content {0} is not in the archive {1} as it was kept.");

    internal static readonly SentenceForm Unusable = new("archive-unusable", "The archive {0} cannot be used: {1}");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } = [Archive, Moved, Unrecorded, Lacks, Unusable];
}
