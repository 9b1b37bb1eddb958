using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Contents that a store keeps by their SHA-256.</summary>
internal static class StoredContent
{
    private const string Archive = PackedContent.Archive;
    private const string Select = $"SELECT {ContentRow.Columns} FROM content";

    /// <summary>Packs contents, outside of any change: that takes its time.</summary>
    /// <param name="contents">The plain contents.</param>
    /// <param name="correction">The correction that they belong to. Its page is not kept if its report gives the same bytes.</param>
    /// <param name="isPageOfReport">True if the page was just drawn from the report, so that nobody needs to draw it again to know
    /// that.</param>
    public static IReadOnlyList<(string Sha256, PackedContent Content)> Pack(
        IReadOnlyList<ReadOnlyMemory<byte>> contents, Correction? correction = null, bool isPageOfReport = false)
    {
        var named = contents.Select(c => (Sha256: ContentHash.Sha256(c.Span), Plain: c)).ToArray();
        return [.. named.Select(c => (c.Sha256, PageOf(c.Sha256, c.Plain) ?? PackedContent.Of(c.Plain)))];

        PackedContent? PageOf(string sha256, ReadOnlyMemory<byte> plain)
        {
            if (correction?.PageSha256 != sha256 || correction.ReportSha256 is not { } source) return null;
            var report = named.FirstOrDefault(c => c.Sha256 == source).Plain;
            return !report.IsEmpty
                && (isPageOfReport || (ReportPages.Of(report) is { } page && page.AsSpan().SequenceEqual(plain.Span)))
                ? new([], PackedContent.Page, plain.Length, source, ReportPages.Version)
                : null;
        }
    }

    /// <summary>Stores a content unless it is already stored. One that was moved to an archive returns to the store.</summary>
    public static void Keep(StoreTransaction transaction, string sha256, PackedContent content)
    {
        SqlArguments parameters = [
            ("sha256", sha256),
            ("Bytes", content.Bytes),
            ("Form", content.Form),
            ("Length", content.Length),
            ("Source", content.Source),
            ("MadeBy", content.MadeBy),
            ("Archive", Archive),
        ];

        // Two statements: a database asks for the right to update as soon as a statement might, and a station may only insert.
        if (transaction.Execute(
            "INSERT INTO content (sha256, bytes, form, length, source, made_by) VALUES (@sha256, @Bytes, @Form, @Length, @Source, @MadeBy) "
                + "ON CONFLICT (sha256) DO NOTHING",
            parameters) == 1
            || transaction.Value<string>("SELECT form FROM content WHERE sha256 = @sha256", parameters) != Archive) return;
        transaction.Execute(
            "UPDATE content SET bytes = @Bytes, form = @Form, length = @Length, source = @Source, made_by = @MadeBy WHERE sha256 = @sha256 "
                + "AND form = @Archive",
            parameters);
    }

    /// <summary>True if content is stored under a hash. What was moved to an archive must be in it: an absent archive stores
    /// nothing.</summary>
    public static bool Has(CellDatabase database, string sha256)
    {
        var form = database.Read(connection => Rows.First(
            connection, "SELECT COALESCE(form, '') FROM content WHERE sha256 = @sha256", r => r.GetString(0), [("sha256", sha256)]));
        if (form != PackedContent.Archive) return form is not null;
        try
        {
            return Read(database, sha256) is not null;
        }
        catch (StoreException e) when (e.Error is StoreError.Archived or StoreError.Damaged or StoreError.Denied)
        {
            return false;
        }
    }

    /// <summary>The content stored under a hash.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Missing"/>, <see cref="StoreError.Damaged"/>,
    /// <see cref="StoreError.Redrawn"/> or <see cref="StoreError.Archived"/>.</exception>
    public static byte[] Read(CellDatabase database, string sha256)
    {
        var packed = Row(database, sha256);
        return packed.Form == PackedContent.Page ? Drawn(database, sha256, packed) : Plain(database, sha256, packed);
    }

    private static PackedContent Row(CellDatabase database, string sha256) =>
        database.Read(connection => Rows.First(connection, Select + " WHERE sha256 = @sha256", ContentRow.Read, [("sha256", sha256)]))
            ?? throw new StoreException(StoreError.Missing, $"{database.Place} has no content {sha256}.");

    private static byte[] Plain(CellDatabase database, string sha256, PackedContent packed)
    {
        if (packed.Form == PackedContent.Archive)
        {
            using var archive = ContentArchive.Open(database.ArchiveFolder, packed.Source);
            return archive.Plain(sha256, packed.Length);
        }

        var plain = packed.Plain();
        if (plain is null || ContentHash.Sha256(plain) != sha256)
        {
            throw new StoreException(
                StoreError.Damaged,
                $"{database.Place} is damaged: content {sha256} is not what was kept"
                    + $"{(plain is null ? "" : $", but {ContentHash.Sha256(plain)}")}. Restore the latest backup.");
        }

        return plain;
    }

    // Its hash decides: a page that another version draws differently is not the one that people saw.
    private static byte[] Drawn(CellDatabase database, string sha256, PackedContent packed)
    {
        var report = packed.Source is { } source ? Plain(database, source, Row(database, source)) : [];
        var page = ReportPages.Of(report);
        if (page is not null && ContentHash.Sha256(page) == sha256) return page;
        throw new StoreException(
            StoreError.Redrawn,
            $"Page {sha256} was drawn by version {packed.MadeBy} from report {packed.Source}, which is unchanged. Version "
                + $"{ReportPages.Version} draws it differently: read the report, or use version {packed.MadeBy}.");
    }
}
