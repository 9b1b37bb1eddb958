namespace ErrorMatching.Cell.Tests;

/// <summary>A machine's folder in memory that fails where it is told to, and looks at the program after everything that changes.</summary>
/// <param name="server">What it can do with a name that something has.</param>
/// <param name="faults">Where it fails: the numbers of its operations, from 0, and how.</param>
internal sealed class FaultyFolder(ServerKind server, IReadOnlyDictionary<int, Fault> faults) : IMachineFolder
{
    private int _operation;

    public Dictionary<string, byte[]> Files { get; } = new(StringComparer.Ordinal);

    /// <summary>Asked after every change.</summary>
    public Action? Changed { get; set; }

    public int Operations => _operation;

    public string Machine => "mill";

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) =>
        Do<IReadOnlyList<string>>(() => { }, () => { }, () => [.. Files.Keys.Order(StringComparer.Ordinal)]);

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation) =>
        Do(() => { }, () => { }, () => Files.GetValueOrDefault(name));

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation) => Do(
        () => Files[name] = bytes[..(bytes.Length / 2)].ToArray(),
        () => Files[name] = bytes.ToArray(),
        () => Files[name].ToArray());

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation) => Do(
        () => { },
        () =>
        {
            if (!Files.TryGetValue(from, out var bytes))
                throw new TransportException(TransportError.Denied, $"{from} is not there.");
            if (server == ServerKind.Refuses && Files.ContainsKey(to))
                throw new TransportException(TransportError.CannotReplace, $"{to} is there.");
            Files.Remove(from);
            Files[to] = bytes;
        },
        () => Files[to].ToArray());

    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        byte[]? was = null;
        return server != ServerKind.Exchanges ? Task.FromResult<ReplacedProgram?>(null) : Do(
            () => Move(from, aside),
            () =>
            {
                Move(from, aside);
                was = Files.GetValueOrDefault(to);
                Files[to] = Files[aside];
                if (was is null)
                    Files.Remove(aside);
                else
                    Files[aside] = was;
            },
            () => (ReplacedProgram?)new ReplacedProgram(Files[to].ToArray(), was?.ToArray()));
    }

    public Task DeleteAsync(string name, CancellationToken cancellation) => Do(() => { }, () => Files.Remove(name), () => true);

    private Task<T> Do<T>(Action part, Action whole, Func<T> answer)
    {
        var fault = faults.GetValueOrDefault(_operation++);
        if (fault == Fault.InPart)
            part();
        if (fault is not (Fault.Before or Fault.InPart or Fault.Denied or Fault.Full))
            whole();
        Changed?.Invoke();
        return fault switch
        {
            Fault.None => Task.FromResult(answer()),
            Fault.Corrupt => Task.FromResult(answer() switch
            {
                byte[] { Length: > 0 } bytes => (T)(object)Spoiled(bytes),
                ReplacedProgram replaced => (T)(object)(replaced with { There = Spoiled(replaced.There) }),
                var other => other,
            }),
            Fault.Denied => Task.FromException<T>(new TransportException(TransportError.Denied, "550")),
            Fault.Full => Task.FromException<T>(new TransportException(TransportError.Full, "552")),
            _ => Task.FromException<T>(new TransportException(TransportError.Away, "gone")),
        };
    }

    private void Move(string from, string to)
    {
        if (from != to && Files.Remove(from, out var bytes))
            Files[to] = bytes;
    }

    private static byte[] Spoiled(byte[] bytes)
    {
        var spoiled = bytes.ToArray();
        spoiled[^1] ^= 1;
        return spoiled;
    }
}
