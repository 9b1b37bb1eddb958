namespace ErrorMatching.Hmi;

/// <summary>The counterparts of one workpiece that are outside their limits, as one entry, so that they do not crowd out others.</summary>
/// <param name="Newest">The one measured last.</param>
/// <param name="More">Number of the others.</param>
internal sealed record OutsidePieces(StoredPiece Newest, int More)
{
    /// <summary>A text with the number of the others; null if there are none.</summary>
    public string? Others => More == 0 ? null : Texts.Current.Counted("Outside.More", More, Shown.Count(More));

    /// <summary>Groups pieces by workpiece.</summary>
    /// <param name="pieces">The pieces, newest first within each workpiece.</param>
    public static IEnumerable<OutsidePieces> Of(IEnumerable<StoredPiece> pieces) =>
        pieces.GroupBy(p => p.JobName, StringComparer.Ordinal).Select(g => new OutsidePieces(g.First(), g.Count() - 1));
}
