using System.Collections.Concurrent;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A machine that cuts what it finds: it looks at each slot's program all the time, cuts one it has not cut yet,
/// and says by a file that it is ready.</summary>
/// <remarks>Whatever it finds is whole: the program of a known measurement or the original, to the last byte, at every instant.</remarks>
internal sealed class FireMachine : IAsyncDisposable
{
    private readonly FireCell _cell;
    private readonly Func<IReadOnlyDictionary<string, string>> _known;
    private readonly CancellationTokenSource _end = new();
    private readonly Task _work;
    private readonly Dictionary<string, (long Length, DateTime WrittenAt)> _stamps = new(StringComparer.Ordinal);
    private readonly Random _random = new(20261);

    /// <summary>Switches the machine on.</summary>
    /// <param name="cell">Where it stands.</param>
    /// <param name="known">File names by the hash of the program that they become.</param>
    public FireMachine(FireCell cell, Func<IReadOnlyDictionary<string, string>> known)
    {
        (_cell, _known) = (cell, known);
        _work = Task.Run(Work);
    }

    /// <summary>What it cut, in the order in which it did: the slot and the file that the program was made of.</summary>
    public ConcurrentQueue<(string Slot, string File)> Cut { get; } = new();

    /// <summary>What it found that nobody may ever find.</summary>
    public ConcurrentQueue<string> Wrong { get; } = new();

    /// <summary>Switches it off.</summary>
    public async ValueTask DisposeAsync()
    {
        await _end.CancelAsync();
        await _work;
        _end.Dispose();
    }

    private async Task Work()
    {
        var last = _cell.Slots.ToDictionary(s => s, _ => FireFiles.OriginalSha256, StringComparer.Ordinal);
        while (!_end.IsCancellationRequested)
        {
            foreach (var slot in _cell.Slots)
            {
                Look(slot, last);
            }

            await Task.Delay(5);
        }
    }

    private void Look(string slot, Dictionary<string, string> last)
    {
        var file = new FileInfo(Path.Combine(_cell.Machine, FireCell.ProgramOf(slot)));
        byte[] bytes;
        try
        {
            // Whatever writes or renames it changes one of these.
            var stamp = (file.Length, file.LastWriteTimeUtc);
            if (_stamps.GetValueOrDefault(slot) == stamp)
            {
                return;
            }

            bytes = File.ReadAllBytes(file.FullName);
            _stamps[slot] = stamp;
        }
        catch (FileNotFoundException)
        {
            Wrong.Enqueue($"{slot} has no program at all.");
            return;
        }

        var hash = FireFiles.Hash(bytes);
        if (hash == last[slot])
        {
            return;
        }

        last[slot] = hash;
        if (hash == FireFiles.OriginalSha256)
        {
            Wrong.Enqueue($"{slot} holds the original again.");
        }
        else if (_known().TryGetValue(hash, out var measurement))
        {
            Cut.Enqueue((slot, measurement));
            Thread.Sleep(_random.Next(20));
            var ready = Path.Combine(_cell.Machine, slot + ".READY");
            File.WriteAllText(ready + ".tmp", "");
            File.Move(ready + ".tmp", ready, overwrite: true);
        }
        else
        {
            Wrong.Enqueue($"{slot} holds {bytes.Length} bytes that no measurement makes.");
        }
    }
}
