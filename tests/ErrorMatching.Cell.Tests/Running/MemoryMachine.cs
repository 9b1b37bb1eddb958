using System.Collections.Concurrent;

namespace ErrorMatching.Cell.Tests;

/// <summary>A machine's folder in memory that outlives the runners that talk to it.</summary>
internal sealed class MemoryMachine(string name) : IMachineFolder
{
    public ConcurrentDictionary<string, byte[]> Files { get; } = new(StringComparer.Ordinal);

    public string Machine => name;

    /// <summary>Fails everything with this, if set.</summary>
    public TransportError? Fails { get; set; }

    /// <summary>Called before and after each operation that changes or reads something, with its name;
    /// what it throws is what the operation throws.</summary>
    public Action<string, bool>? Around { get; set; }

    /// <summary>What of that failed as an assertion; a runner takes it for a defect, and goes on.</summary>
    public Exception? Broken { get; private set; }

    /// <summary>Asked with each operation's name whether it hangs until it is cancelled.</summary>
    public Func<string, bool>? Hangs { get; set; }

    /// <summary>Names of all operations, in order.</summary>
    public ConcurrentQueue<string> Done { get; } = new();

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) =>
        Do<IReadOnlyList<string>>("list", () => [.. Files.Keys.Order(StringComparer.Ordinal)], cancellation);

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation) =>
        Do("read " + name, () => Files.GetValueOrDefault(name), cancellation);

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation) =>
        Do("write", () => Files[name] = bytes.ToArray(), cancellation);

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation) => Do(
        "rename " + to,
        () =>
        {
            Assert.True(Files.TryRemove(from, out var bytes));
            return Files[to] = bytes;
        },
        cancellation);

    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation) =>
        Do<ReplacedProgram?>(
        "rename " + to,
        () =>
        {
            Assert.True(Files.TryRemove(from, out var bytes));
            if (Files.TryGetValue(to, out var was))
            {
                Files[aside] = was;
            }

            return new(Files[to] = bytes, was);
        },
        cancellation);

    public Task DeleteAsync(string name, CancellationToken cancellation) =>
        Do("delete " + name, () => Files.TryRemove(name, out _), cancellation);

    private async Task<T> Do<T>(string what, Func<T> work, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        if (Fails is { } error)
        {
            throw new TransportException(error, $"{name} fails as the test says.");
        }

        if (Hangs?.Invoke(what) == true)
        {
            await Task.Delay(Timeout.Infinite, cancellation);
        }

        Report(what, false);
        Done.Enqueue(what);
        var result = work();
        Report(what, true);
        return result;
    }

    private void Report(string what, bool isDone)
    {
        try
        {
            Around?.Invoke(what, isDone);
        }
        catch (Xunit.Sdk.XunitException e)
        {
            Broken ??= e;
            throw;
        }
    }
}
