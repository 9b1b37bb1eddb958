using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Writes a file that is a copy of a store, completely or not at all.</summary>
internal static class SqliteBackup
{
    /// <summary>Writes a backup under another name first, flushes it to disk, and then gives it its name.</summary>
    /// <param name="file">The backup's file.</param>
    /// <param name="fill">Copies the store into an empty file.</param>
    /// <exception cref="StoreException">It was not written.</exception>
    public static void Write(string file, Action<string> fill)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(file));
        if (!Directory.Exists(folder))
            throw new StoreException(StoreError.Missing, $"The backup {file} was not written: the folder {folder} is not there.");
        var temporary = $"{file}.{Environment.ProcessId.ToString(CultureInfo.InvariantCulture)}.tmp";
        try
        {
            SqliteDatabase.MakeForOwner(temporary);
            fill(temporary);
            using (var written = new FileStream(temporary, FileMode.Open, FileAccess.ReadWrite)) written.Flush(flushToDisk: true);
            SharedFile.Replace(temporary, file);
        }
        catch (StoreException failure) when (failure.Error is not StoreError.Damaged)
        {
            throw new StoreException(failure.Error, $"The backup {file} was not written: {failure.InnerException!.Message}", failure);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(StoreError.Disk, $"The backup {file} was not written: {failure.Message}", failure);
        }
        finally
        {
            foreach (var end in (ReadOnlySpan<string>)["", "-journal", "-wal", "-shm"]) File.Delete(temporary + end);
        }
    }
}
