using System.Collections.Concurrent;

namespace ErrorMatching.Peers.Tests;

/// <summary>Hears from the system of every temporary file of a transfer in a machine's folder, in the order in which they come and go, and
/// notes where two of one program lie there at once.</summary>
internal sealed class SlotWriters : IDisposable
{
    private readonly FileSystemWatcher _watcher;
    private readonly Dictionary<string, HashSet<string>> _writing = new(StringComparer.Ordinal);
    private int _seen;

    /// <summary>Begins to listen.</summary>
    public SlotWriters(string folder)
    {
        _watcher = new FileSystemWatcher(folder) { NotifyFilter = NotifyFilters.FileName };
        _watcher.Created += (_, e) => Comes(e.Name!);
        _watcher.Deleted += (_, e) => Goes(e.Name!);
        _watcher.Renamed += (_, e) => Goes(e.OldName!);
        _watcher.Error += (_, e) => AtOnce.Enqueue(e.GetException().Message);
        _watcher.EnableRaisingEvents = true;
    }

    /// <summary>Temporary files that lay there at once.</summary>
    public ConcurrentQueue<string> AtOnce { get; } = new();

    /// <summary>How many transfers began.</summary>
    public int Seen => Volatile.Read(ref _seen);

    public void Dispose() => _watcher.Dispose();

    // Of OS00.NC.17-0123abcd.emnew the program is OS00.
    private HashSet<string> Of(string name)
    {
        var program = name[..name.IndexOf('.', StringComparison.Ordinal)];
        return _writing.TryGetValue(program, out var names) ? names : _writing[program] = new(StringComparer.Ordinal);
    }

    private void Comes(string name)
    {
        if (!name.EndsWith(".emnew", StringComparison.Ordinal))
            return;
        var writing = Of(name);
        writing.Add(name);
        if (writing.Count > 1)
            AtOnce.Enqueue(string.Join(" and ", writing));
        Interlocked.Increment(ref _seen);
    }

    private void Goes(string name)
    {
        if (name.EndsWith(".emnew", StringComparison.Ordinal))
            Of(name).Remove(name);
    }
}
