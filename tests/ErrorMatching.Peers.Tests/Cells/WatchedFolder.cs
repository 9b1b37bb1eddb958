using System.Collections.Concurrent;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>A machine's folder whose operations a test sees, and may end the process at.</summary>
/// <param name="folder">The folder.</param>
/// <param name="around">Called before and behind each operation, with its words; what it throws is what the operation throws.</param>
internal sealed class WatchedFolder(IMachineFolder folder, Action<string, bool>? around = null) : IMachineFolder
{
    /// <summary>What was done, in order.</summary>
    public ConcurrentQueue<string> Done { get; } = new();

    public string Machine => folder.Machine;

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) => Do("list", () => folder.ListAsync(cancellation));

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation) =>
        Do("read " + name, () => folder.ReadAsync(name, mostBytes, cancellation));

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation) =>
        Do("write", () => folder.WriteAsync(name, bytes, cancellation));

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation) =>
        Do("rename " + to, () => folder.RenameAsync(from, to, mostBytes, cancellation));

    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation) =>
        Do("replace " + to, () => folder.ReplaceAsync(from, to, aside, mostBytes, cancellation));

    public Task DeleteAsync(string name, CancellationToken cancellation) => Do(
        "delete " + name,
        async () =>
        {
            await folder.DeleteAsync(name, cancellation);
            return true;
        });

    public void Dispose() => folder.Dispose();

    private async Task<T> Do<T>(string what, Func<Task<T>> work)
    {
        around?.Invoke(what, false);
        var result = await work();
        Done.Enqueue(what);
        around?.Invoke(what, true);
        return result;
    }
}
