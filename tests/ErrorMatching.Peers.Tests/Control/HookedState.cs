using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>A source of a machine's state with something before each question and behind each answer.</summary>
internal sealed record HookedState(StateSettings Inner, Func<Task> Before, Action After) : StateSettings
{
    public override string Address => Inner.Address;

    internal override MachineStateSource Open(TimeProvider clock) => new Source(this, Inner.Open(clock));

    private sealed class Source(HookedState hooked, MachineStateSource inner) : MachineStateSource(hooked.Address, TimeSpan.FromMinutes(2))
    {
        protected override async Task<MachineState> AnswerAsync(CancellationToken cancellation)
        {
            await hooked.Before();
            var state = await inner.AskAsync(cancellation);
            hooked.After();
            return state;
        }
    }
}

/// <summary>A machine's folder with something before each operation.</summary>
/// <param name="folder">The folder.</param>
/// <param name="before">Called with whether the operation takes a program's name from it.</param>
internal sealed class HookedFolder(IMachineFolder folder, Func<bool, Task> before) : IMachineFolder
{
    public string Machine => folder.Machine;

    public async Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation)
    {
        await before(false);
        return await folder.ListAsync(cancellation);
    }

    public async Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation)
    {
        await before(false);
        return await folder.ReadAsync(name, mostBytes, cancellation);
    }

    public async Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        await before(false);
        return await folder.WriteAsync(name, bytes, cancellation);
    }

    public async Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        await before(true);
        return await folder.RenameAsync(from, to, mostBytes, cancellation);
    }

    public async Task<ReplacedProgram?> ReplaceAsync(
        string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        await before(true);
        return await folder.ReplaceAsync(from, to, aside, mostBytes, cancellation);
    }

    public async Task DeleteAsync(string name, CancellationToken cancellation)
    {
        await before(false);
        await folder.DeleteAsync(name, cancellation);
    }
}
