namespace ErrorMatching.Cell;

/// <summary>A machine's folder that nothing is changed in without the right to its slot. Each operation that changes something asks for the
/// right first, immediately before it.</summary>
/// <remarks>A process can be frozen between the question and the operation, or in the middle of it, and its right go to another one. When
/// it goes on, the rest of that one operation finds none of its files: each has a name of this process and attempt, and the other process
/// has first deleted or renamed all of them (<see cref="ProgramSender.RecoverAsync"/>). The next operation asks again. What is left: on a
/// server that does not rename over a file, the operation may take the program's own name away, for there its first step is to set aside
/// whatever has the name.</remarks>
/// <param name="folder">The folder.</param>
/// <param name="demand">Throws if the right is lost.</param>
internal sealed class FencedFolder(IMachineFolder folder, Action demand) : IMachineFolder
{
    public string Machine => folder.Machine;

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) => folder.ListAsync(cancellation);

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation) =>
        folder.ReadAsync(name, mostBytes, cancellation);

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        demand();
        return folder.WriteAsync(name, bytes, cancellation);
    }

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        demand();
        return folder.RenameAsync(from, to, mostBytes, cancellation);
    }

    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        demand();
        return folder.ReplaceAsync(from, to, aside, mostBytes, cancellation);
    }

    public Task DeleteAsync(string name, CancellationToken cancellation)
    {
        demand();
        return folder.DeleteAsync(name, cancellation);
    }
}
