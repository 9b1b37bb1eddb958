using System.Collections.Concurrent;

namespace ErrorMatching.Cell.Tests;

/// <summary>A machine's folder in memory that outlives the runners that talk to it.</summary>
internal sealed class MemoryMachine(string name) : IMachineFolder
{
    public ConcurrentDictionary<string, byte[]> Files { get; } = new(StringComparer.Ordinal);

    public string Machine => name;

    /// <summary>Fails everything with this, if set.</summary>
    public TransportError? Fails { get; set; }

    /// <summary>Called before and after each operation that changes or reads something, with its name; what it throws is what the operation throws.</summary>
    public Action<string, bool>? Around { get; set; }

    /// <summary>Names of all operations, in order.</summary>
    public ConcurrentQueue<string> Done { get; } = new();

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) => Do<IReadOnlyList<string>>("list", cancellation, () => [.. Files.Keys.Order(StringComparer.Ordinal)]);

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation) => Do("read " + name, cancellation, () => Files.GetValueOrDefault(name));

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => Do("write", cancellation, () => Files[name] = bytes.ToArray());

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation) => Do("rename " + to, cancellation, () =>
    {
        Assert.True(Files.TryRemove(from, out var bytes));
        return Files[to] = bytes;
    });

    public Task DeleteAsync(string name, CancellationToken cancellation) => Do("delete " + name, cancellation, () => Files.TryRemove(name, out _));

    private Task<T> Do<T>(string what, CancellationToken cancellation, Func<T> work)
    {
        cancellation.ThrowIfCancellationRequested();
        if (Fails is { } error)
        {
            return Task.FromException<T>(new TransportException(error, $"{name} fails as the test says."));
        }

        Around?.Invoke(what, false);
        Done.Enqueue(what);
        var result = work();
        Around?.Invoke(what, true);
        return Task.FromResult(result);
    }
}
