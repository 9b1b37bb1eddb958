using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The forms of why a cell reads its whole audit trail instead of going on from a checkpoint.</summary>
internal static class RecordedCheckpoint
{
    /// <summary>There is no checkpoint.</summary>
    internal static readonly SentenceForm Missing = new(
        "checkpoint-missing", "The store has no checkpoint of its audit trail: all of the trail is read before the first program is sent.");

    /// <summary>It was made by other code, which may judge entries differently.</summary>
    internal static readonly SentenceForm OfOtherBuild = new(
        "checkpoint-of-other-build",
        "Another build of the program made the checkpoint of the audit trail: all of the trail is read before the first program is sent.");

    /// <summary>Somebody without the key wrote it: the number of its entry.</summary>
    internal static readonly SentenceForm Foreign = new(
        "checkpoint-foreign",
        "The checkpoint of the audit trail, at entry {0:0}, is not what the cell wrote there: somebody else wrote to the store. It is not "
            + "used, and all of the trail is read.");

    /// <summary>It belongs to another trail, or the store was set back: the number of its entry.</summary>
    internal static readonly SentenceForm Astray = new(
        "checkpoint-astray",
        "The checkpoint of the audit trail is of entry {0:0}, and that entry is missing or another one. It is not used, and all of the "
            + "trail is read.");

    /// <summary>All forms.</summary>
    public static IReadOnlyList<SentenceForm> All { get; } = [Missing, OfOtherBuild, Foreign, Astray];
}
