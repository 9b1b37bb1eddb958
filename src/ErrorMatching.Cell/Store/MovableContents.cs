using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Finds the contents that nothing in the store needs any more.</summary>
/// <remarks>Kept are the contents of corrections that have not ended, that are not old enough, that are among the last of their slots,
/// whose program a slot holds, that were sent last for a job or are its last measured part; of those on whose program such a correction
/// builds; and the programs of slots. A content that several corrections name stays as long as one of them keeps it.</remarks>
internal static class MovableContents
{
    /// <summary>The columns of a correction that name contents.</summary>
    public static readonly string[] Named =
    [
        "measurement_sha256", "job_sha256", "base_sha256", "part_sha256", "program_sha256", "report_sha256", "page_sha256", "sums_sha256",
        "previous_sha256", "undo_sha256",
    ];

    private const string Plain = "(content.form IS NULL OR content.form = 'brotli')";

    private static readonly string Slots =
        "SELECT program_sha256 FROM slot WHERE program_sha256 IS NOT NULL UNION SELECT previous_sha256 FROM slot WHERE previous_sha256 IS "
            + "NOT NULL";

    private static readonly string Sql = $"""
        WITH kept AS (
            SELECT id FROM correction WHERE changed_at >= @Before 
                OR NOT {CorrectionRow.IsIn("state", CorrectionSteps.Where(s => s.IsSettled))}
            UNION SELECT id FROM (
                SELECT id, row_number() OVER (PARTITION BY machine, slot ORDER BY id DESC) AS place FROM correction
                WHERE slot IS NOT NULL) AS line WHERE place <= @KeepLast
            UNION SELECT correction.id FROM correction JOIN slot ON slot.machine = correction.machine AND slot.slot = correction.slot
                AND (slot.correction = correction.id OR slot.program_sha256 = correction.program_sha256)
            UNION SELECT max(id) FROM correction WHERE piece = '{PieceWords.Part}'
                AND {CorrectionRow.IsIn("state", CorrectionState.Recorded)} GROUP BY job
            UNION SELECT step.correction FROM step JOIN (
                SELECT max(sent.id) AS id FROM step AS sent JOIN correction ON correction.id = sent.correction
                WHERE {CorrectionRow.IsIn("sent.to_state", CorrectionState.Verified)}
                    AND {CorrectionRow.IsIn("correction.state", CorrectionSteps.Where(s => s.IsSent))}
                GROUP BY correction.job) AS last ON last.id = step.id
        ), needed AS MATERIALIZED (
            SELECT id FROM kept
            UNION SELECT made.id FROM kept JOIN correction AS one ON one.id = kept.id AND one.sums_sha256 IS NOT NULL
                JOIN correction AS made ON made.program_sha256 = one.base_sha256 AND made.job = one.job AND made.sums_sha256 IS NOT NULL
        ), flagged AS MATERIALIZED (
            SELECT {string.Join(", ", Named)}, CASE WHEN id IN (SELECT id FROM needed) THEN 1 ELSE 0 END AS keeps FROM correction
        )
        SELECT named.sha256, length(content.bytes) FROM (
            {string.Join(" UNION ALL ", Named.Select(c => $"SELECT {c} AS sha256, keeps FROM flagged WHERE {c} IS NOT NULL"))}) AS named
        JOIN content ON content.sha256 = named.sha256 AND {Plain}
        WHERE named.sha256 NOT IN ({Slots})
        GROUP BY named.sha256, length(content.bytes) HAVING max(named.keeps) = 0 ORDER BY named.sha256
        """;

    /// <summary>Finds them all in one snapshot.</summary>
    /// <returns>The contents in the order of their hashes, and the number of the last step that was looked at.</returns>
    public static (IReadOnlyList<MovableContent> Contents, long LastStep) Of(CellDatabase database, ThinPolicy policy) =>
        database.Snapshot((connection, transaction) => (
            Rows.Query(
                connection,
                Sql,
                r => MovableContent.Of(r.GetString(0), r.GetInt64(1)),
                [("Before", StoredTime.Of(policy.Before)), ("KeepLast", policy.KeepLast)],
                transaction),
            Rows.Query(connection, "SELECT COALESCE(max(id), 0) FROM step", r => r.GetInt64(0), null, transaction)[0]));

    /// <summary>The hashes that corrections name which took a step since, and those of the slots: they stay.</summary>
    public static IReadOnlySet<string> NeededSince(StoreTransaction transaction, long lastStep)
    {
        var since = Named.Select(
            c => $"SELECT {c} FROM correction WHERE {c} IS NOT NULL AND id IN (SELECT correction FROM step WHERE id > @lastStep)");
        return transaction.Query(string.Join(" UNION ", since.Append(Slots)), r => r.GetString(0), [("lastStep", lastStep)])
            .ToHashSet(StringComparer.Ordinal);
    }
}

/// <summary>A content that may be moved. Its hash is two numbers, so that millions of them need little memory.</summary>
/// <param name="High">The first half of its hash.</param>
/// <param name="Low">The second half.</param>
/// <param name="Bytes">Its length as stored.</param>
internal readonly record struct MovableContent(UInt128 High, UInt128 Low, long Bytes)
{
    private const int Half = 32;

    /// <summary>Its hash as 64 lowercase hexadecimal digits.</summary>
    public string Sha256 => string.Create(CultureInfo.InvariantCulture, $"{High:x32}{Low:x32}");

    /// <summary>A content by its hash.</summary>
    public static MovableContent Of(string sha256, long bytes) => new(
        UInt128.Parse(sha256.AsSpan(0, Half), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture),
        UInt128.Parse(sha256.AsSpan(Half), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture),
        bytes);
}
