namespace ErrorMatching.Cell;

/// <summary>A folder for one transfer that only this user may access; deleted when disposed of. A killed process leaves its folder behind,
/// and the next process deletes it before its first transfer.</summary>
internal sealed class PrivateFolder : IDisposable
{
    private const string Prefix = "errormatch-transfers-";
    private const string Lock = "lock";
    private static readonly Lazy<string> Mine = new(Begin);

    private readonly string _path = Path.Combine(Mine.Value, Guid.NewGuid().ToString("N"));

    public PrivateFolder()
    {
        if (OperatingSystem.IsWindows())
        {
            Directory.CreateDirectory(_path);
        }
        else
        {
            Directory.CreateDirectory(_path, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }
    }

    /// <summary>The path of a file in it.</summary>
    public string this[string name] => Path.Combine(_path, name);

    public void Dispose() => Directory.Delete(_path, recursive: true);

    /// <summary>Deletes what killed processes left in a folder: a running process holds the lock in its own.</summary>
    internal static void Sweep(string temporary)
    {
        foreach (var left in Directory.EnumerateDirectories(temporary, Prefix + "*"))
        {
            try
            {
                // A folder without a lock file is skipped: it is empty, or just being created.
                using (new FileStream(Path.Combine(left, Lock), FileMode.Open, FileAccess.ReadWrite, FileShare.None))
                {
                }

                Directory.Delete(left, recursive: true);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                // It is in use, belongs to another user, or is just being deleted by another process.
            }
        }
    }

    private static string Begin()
    {
        var temporary = Path.GetTempPath();
        Sweep(temporary);
        var mine = Directory.CreateTempSubdirectory(Prefix).FullName;

        // Held until the process ends, however it ends.
        var held = new FileStream(Path.Combine(mine, Lock), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None);
        AppDomain.CurrentDomain.ProcessExit += (_, _) => End(mine, held);
        return mine;
    }

    private static void End(string mine, FileStream held)
    {
        held.Dispose();
        try
        {
            Directory.Delete(mine, recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // A tool that was killed with a transfer may still have a file open: the next process deletes it.
        }
    }
}
