using System.Data.Common;
using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Json;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <summary>A file of contents that were moved out of a store: a SQLite database with one table, like the store's own. It is never changed
/// after it got its name, and nothing in it is believed: each content is checked against its hash.</summary>
internal sealed partial class ContentArchive : IDisposable
{
    /// <summary>Marks a file as an archive.</summary>
    public const int ApplicationId = 0x45724D41;

    /// <summary>The only thing in an archive.</summary>
    public const string Table =
        "CREATE TABLE content (sha256 TEXT NOT NULL PRIMARY KEY, bytes BLOB NOT NULL, form TEXT, length BIGINT)";

    // Larger than any that is written: a store thins in several.
    private const long MostBytes = 4L << 30;
    // No program and no measurement that a cell takes is larger.
    private const long MostContentBytes = 256L << 20;
    private const string Columns = "SELECT CASE WHEN length(bytes) <= @most THEN bytes END, form, length, NULL, NULL, sha256 FROM content";

    private readonly string _file;
    private readonly SqliteConnection _connection;

    private ContentArchive(string file, SqliteConnection connection) => (_file, _connection) = (file, connection);

    /// <summary>True for the name of an archive: whatever a row of the store says, no other file is opened.</summary>
    public static bool IsName(string? name) => name is not null && Name().IsMatch(name);

    /// <summary>The archives in a folder, by name; none if there is no folder.</summary>
    public static IReadOnlyList<string> In(string folder) => !Directory.Exists(folder) ? []
        : [.. Directory.EnumerateFiles(folder).Select(f => Path.GetFileName(f)).Where(IsName).Order(StringComparer.Ordinal)];

    /// <summary>True if an archive is there, whatever is in it.</summary>
    public static bool IsThere(string? folder, string? name) =>
        folder is not null && IsName(name) && File.Exists(Path.Combine(folder, name!));

    /// <summary>The message that an archive is not there.</summary>
    public static string Missing(string? folder, string? name) =>
        $"The archive {name} is not in {folder ?? "the folder of the archives, which the configuration does not name"}. Bring the file "
            + "back there.";

    /// <summary>Opens an archive to read it.</summary>
    /// <param name="folder">The folder of the archives; null if there is none.</param>
    /// <param name="name">Its name.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.Archived"/> if it is not there, with <see cref="StoreError.Denied"/> if
    /// it is no plain file, with <see cref="StoreError.Damaged"/> if it is no archive.</exception>
    public static ContentArchive Open(string? folder, string? name)
    {
        if (!IsThere(folder, name))
        {
            throw new StoreException(StoreError.Archived, Missing(folder, name) + " Then repeat this.");
        }

        return OpenFile(Path.Combine(folder!, name!));
    }

    /// <summary>Opens an archive whose file does not have its final name, as while it is written.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Denied"/> or <see cref="StoreError.Damaged"/>.</exception>
    public static ContentArchive OpenFile(string file)
    {
        try
        {
            return Opened(file);
        }
        catch (SqliteException e)
        {
            throw Damaged(file, e.Message, e);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(StoreError.Denied, $"The archive {file} cannot be opened: {e.Message}", e);
        }
    }

    /// <summary>The plain bytes of a content.</summary>
    /// <param name="sha256">Its hash.</param>
    /// <param name="length">Its length, as the store says; no more than that is ever read or expanded.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.Damaged"/> if it is not in the archive as it was kept.</exception>
    public byte[] Plain(string sha256, long? length) => Named(() =>
        Rows.Query(_connection, Columns + " WHERE sha256 = @sha256", ContentRow.ReadOrNull,
            [("sha256", sha256), ("most", Math.Min(length ?? 0, MostContentBytes))])
            is [{ } packed]
            && PlainOf(packed, length) is { } plain
            && ContentHash.Sha256(plain) == sha256
            ? plain
            : throw Damaged(_file, $"content {sha256} is not what was kept.", null));

    /// <summary>All contents as they are stored, in the order of their hashes; null for one that cannot be read.</summary>
    public IEnumerable<(string Sha256, PackedContent? Content)> All()
    {
        using var rows = Rows.Stream(
            _connection,
            Columns + " ORDER BY sha256",
            r => (r.GetString(5), ContentRow.ReadOrNull(r)),
            [("most", MostContentBytes)]).GetEnumerator();
        while (Named(rows.MoveNext)) yield return rows.Current;
    }

    /// <summary>The plain bytes of a content of this length; null if it is none.</summary>
    public static byte[]? PlainOf(PackedContent? packed, long? length) =>
        packed is not null && length is { } known && (packed.Length ?? packed.Bytes.LongLength) == known ? packed.Plain() : null;

    /// <inheritdoc/>
    public void Dispose() => _connection.Dispose();

    private static ContentArchive Opened(string file)
    {
        var item = new FileInfo(file);
        if (PlainFile.Defect(item) is { } defect)
        {
            throw new StoreException(StoreError.Denied, $"The archive {file} is no plain file: {defect}.");
        }

        if (item.Length > MostBytes)
        {
            throw Damaged(
                file, string.Create(CultureInfo.InvariantCulture, $"it has {item.Length} bytes, and no archive is that long."), null);
        }

        // Immutable: no log and no lock beside it, so that it may be on a read-only disk.
        var connection = new SqliteConnection(new SqliteConnectionStringBuilder
        {
            DataSource = new Uri(item.FullName).AbsoluteUri + "?immutable=1",
            Mode = SqliteOpenMode.ReadOnly,
            Pooling = false,
        }.ConnectionString);
        try
        {
            connection.Open();
            connection.Execute("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0");
            var things = Rows.Query(
                connection, "SELECT sql FROM sqlite_master WHERE name <> 'sqlite_autoindex_content_1'", r => r.TextOrNull(0));
            if (connection.Value<int>("PRAGMA application_id") != ApplicationId || things is not [Table])
            {
                throw Damaged(file, "it is not a file that errormatch cell thin wrote.", null);
            }

            return new(file, connection);
        }
        catch
        {
            connection.Dispose();
            throw;
        }
    }

    private T Named<T>(Func<T> read)
    {
        try
        {
            return read();
        }
        catch (Exception e) when (e is DbException or InvalidCastException or InvalidOperationException)
        {
            throw Damaged(_file, e.Message, e);
        }
    }

    private static StoreException Damaged(string file, string found, Exception? cause) =>
        new(StoreError.Damaged, $"The archive {file} is damaged: {found.Trim()} Bring a copy of it back.", cause);

    [GeneratedRegex("^contents-[0-9a-f]{16}\\.db$", RegexOptions.CultureInvariant, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Name();
}

/// <summary>The archives that the audit trail names.</summary>
internal static class RecordedArchives
{
    /// <summary>How many contents were moved to each archive, by its name.</summary>
    public static IReadOnlyDictionary<string, long> Of(DbConnection connection, DbTransaction? transaction)
    {
        var found = new Dictionary<string, long>(StringComparer.Ordinal);
        foreach (var entry in Rows.Query(
            connection, AuditRow.Select + $" WHERE what = '{RecordedThinning.Thinned}' ORDER BY seq", AuditRow.Read, null, transaction))
        {
            if (entry.Subject is { } subject && subject.Is(RecordedThinning.Archive) && entry.Basis.Is(RecordedThinning.Moved)
                && long.TryParse(entry.Basis.Values[0].Words, NumberStyles.None, CultureInfo.InvariantCulture, out var count)
                && subject.Values[0].Words is { } name)
            {
                found[name] = found.GetValueOrDefault(name) + count;
            }
        }

        return found;
    }
}
