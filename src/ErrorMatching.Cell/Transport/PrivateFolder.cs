namespace ErrorMatching.Cell;

/// <summary>A folder of one transfer that only this user may look into; gone when disposed. A process that is killed leaves its own behind, which the next process removes before its first transfer.</summary>
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

    /// <summary>Removes what killed processes left in a folder: whoever lives keeps the lock of its own.</summary>
    internal static void Sweep(string temporary)
    {
        foreach (var left in Directory.EnumerateDirectories(temporary, Prefix + "*"))
        {
            try
            {
                // Without a lock it was left before anything was in it, or is being made.
                using (new FileStream(Path.Combine(left, Lock), FileMode.Open, FileAccess.ReadWrite, FileShare.None))
                {
                }

                Directory.Delete(left, recursive: true);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                // It is in use, another user's, or another process removes it just now.
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
            // A program that was killed with a transfer may still have a file open: the next process removes it.
        }
    }
}
