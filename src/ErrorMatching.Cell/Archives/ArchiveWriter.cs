using System.Globalization;
using System.Security.Cryptography;
using ErrorMatching.Json;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <summary>Writes an archive: under another name first, flushed, read again and compared; then it gets the name that its own hash gives
/// it. So an archive is complete or not there, and never replaced.</summary>
internal static class ArchiveWriter
{
    private const string Ending = ".new";

    /// <summary>Writes contents to a new archive.</summary>
    /// <param name="folder">The folder of the archives, which is created if needed.</param>
    /// <param name="contents">The contents as the store has them.</param>
    /// <param name="at">Called before and behind each step, with its name.</param>
    /// <returns>Its name and its SHA-256.</returns>
    /// <exception cref="StoreException">It was not written.</exception>
    public static (string Name, string Sha256) Write(
        string folder, IReadOnlyList<(string Sha256, PackedContent Content)> contents, Action<string> at)
    {
        var temporary = Path.Combine(
            folder, $"contents.{Environment.ProcessId.ToString(CultureInfo.InvariantCulture)}.{Guid.NewGuid():N}{Ending}");
        try
        {
            Directory.CreateDirectory(folder);
            at("folder");
            SqliteDatabase.MakeForOwner(temporary);
            Fill(temporary, contents);
            at("written");
            using (var written = new FileStream(temporary, FileMode.Open, FileAccess.ReadWrite)) written.Flush(flushToDisk: true);
            at("flushed");
            var hash = HashOf(temporary);
            var name = $"contents-{hash[..16]}.db";
            Compare(temporary, contents);
            at("compared");
            if (!FirstFile.TryPut(temporary, Path.Combine(folder, name)) && HashOf(Path.Combine(folder, name)) != hash)
            {
                throw new StoreException(StoreError.Conflict, $"{Path.Combine(folder, name)} is another file. Move it away.");
            }

            at("named");
            if (OperatingSystem.IsLinux()) LinuxCalls.SyncFolder(folder);
            return (name, hash);
        }
        catch (SqliteException e)
        {
            throw new StoreException(StoreError.Disk, $"No archive was written to {folder}: {e.Message}", e);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(StoreError.Disk, $"No archive was written to {folder}: {e.Message}", e);
        }
        finally
        {
            Remove(temporary);
        }
    }

    /// <summary>Removes what an earlier process left unfinished. Nobody else may be writing.</summary>
    public static void CleanUp(string folder)
    {
        if (!Directory.Exists(folder)) return;
        foreach (var left in Directory.EnumerateFiles(folder, $"contents.*{Ending}")) Remove(left);
    }

    /// <summary>SHA-256 of a file, as 64 lowercase hexadecimal digits.</summary>
    public static string HashOf(string file)
    {
        using var handle = PlainFile.Open(file, FileShare.Read);
        using var bytes = new FileStream(handle, FileAccess.Read);
        return Convert.ToHexStringLower(SHA256.HashData(bytes));
    }

    private static void Fill(string file, IReadOnlyList<(string Sha256, PackedContent Content)> contents)
    {
        using var archive = new SqliteConnection(
            new SqliteConnectionStringBuilder { DataSource = file, Mode = SqliteOpenMode.ReadWrite, Pooling = false }.ConnectionString);
        archive.Open();
        archive.Execute(string.Create(
            CultureInfo.InvariantCulture, $"PRAGMA journal_mode = DELETE; PRAGMA application_id = {ContentArchive.ApplicationId}"));
        using var transaction = archive.BeginTransaction();
        archive.Execute(ContentArchive.Table, transaction: transaction);
        foreach (var (sha256, content) in contents)
        {
            archive.Execute(
                "INSERT INTO content (sha256, bytes, form, length) VALUES (@sha256, @Bytes, @Form, @Length)",
                [("sha256", sha256), ("Bytes", content.Bytes), ("Form", content.Form), ("Length", content.Length)],
                transaction);
        }

        transaction.Commit();
    }

    // What the disk has, not what was meant.
    private static void Compare(string file, IReadOnlyList<(string Sha256, PackedContent Content)> contents)
    {
        using var archive = ContentArchive.OpenFile(file);
        var found = archive.All().ToDictionary(c => c.Sha256, c => c.Content, StringComparer.Ordinal);
        foreach (var (sha256, content) in contents)
        {
            if (!found.TryGetValue(sha256, out var there) || there?.Plain() is not { } plain || ContentHash.Sha256(plain) != sha256)
            {
                throw new StoreException(StoreError.Disk, $"The archive {file} was read back differently, at content {sha256}.");
            }
        }

        if (found.Count != contents.Count)
        {
            throw new StoreException(StoreError.Disk, $"The archive {file} was read back differently.");
        }
    }

    private static void Remove(string temporary)
    {
        foreach (var end in (ReadOnlySpan<string>)["", "-journal", "-wal", "-shm"]) File.Delete(temporary + end);
    }
}
