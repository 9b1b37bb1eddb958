namespace ErrorMatching.Hmi;

/// <summary>The counterparts of one workpiece that were measured outside of their limits, told together: many of them do not push away what else waits.</summary>
/// <param name="Newest">The one that was measured last.</param>
/// <param name="More">How many more there are.</param>
public sealed record OutsidePieces(KeptPiece Newest, int More)
{
    /// <summary>That there are more, and where they are; null if there are none.</summary>
    public string? Others => More == 0 ? null : Texts.Current.Counted("Outside.More", More, Shown.Count(More));

    /// <summary>Those of each workpiece.</summary>
    /// <param name="pieces">The pieces, of each workpiece the newest first.</param>
    public static IEnumerable<OutsidePieces> Of(IEnumerable<KeptPiece> pieces) =>
        pieces.GroupBy(p => p.JobName, StringComparer.Ordinal).Select(g => new OutsidePieces(g.First(), g.Count() - 1));
}
