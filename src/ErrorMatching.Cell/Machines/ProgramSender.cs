using ErrorMatching.Json;
using ErrorMatching.Reporting;
using Polly;

namespace ErrorMatching.Cell;

/// <summary>Sends programs to a machine. Whatever fails and whenever, the machine has either the old program or the new one, complete, and
/// no change that a person made there is lost.</summary>
/// <remarks>
/// <para>A program is written under a name of this attempt alone, read back, and compared. Then the machine's current program is checked
/// again. Only if it is still the one to be replaced, the new one is renamed over it and read back. If the transport supports it, the
/// previous program keeps a name until it is compared as well (<see cref="IMachineFolder.ReplaceAsync"/>), and a last-moment change gets
/// its place back. On a server that does not rename over a file, the old program is first renamed aside. If the connection breaks at that
/// moment, both are complete under other names, and <see cref="RecoverAsync"/> restores the old one.</para>
/// <para>A temporary file is never mistaken for a program: a file is renamed only after it was read back and found equal. Only one sender
/// at a time may work on a program. An earlier one that was frozen in the middle of an operation may go on later;
/// <see cref="RecoverAsync"/> takes all its names from it, so that the rest of the operation finds nothing.</para>
/// <para>With a guard, a program that the machine runs, or may run, is not replaced: the machine is asked immediately before each operation
/// that takes a program's name from it, and once more afterward. A name that is free may get its program back at any
/// time.</para></remarks>
/// <param name="folder">The machine's folder.</param>
/// <param name="isKept">Whether content is stored elsewhere, by its SHA-256 as 64 lowercase hexadecimal digits. Only such content is
/// deleted at the machine.</param>
/// <param name="tries">The retry strategy for a transfer, such as <see cref="TransferTries.For"/>; null for a single attempt.</param>
/// <param name="guard">Asks what the machine is doing; null if nothing says that, and programs are replaced at any time.</param>
public sealed class ProgramSender(
    IMachineFolder folder, Func<string, bool> isKept, ResiliencePipeline? tries = null, ReplacementGuard? guard = null)
{
    /// <summary>Larger programs are not read from a machine.</summary>
    public const long MostBytes = 256L << 20;

    private readonly ResiliencePipeline _tries = tries ?? ResiliencePipeline.Empty;

    /// <summary>The machine's current program; null if it has none of this name.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="cancellation">Cancels immediately.</param>
    /// <exception cref="TransportException">It could not be read.</exception>
    public async Task<byte[]?> CurrentAsync(string program, CancellationToken cancellation)
    {
        Demand(program);
        return await _tries.ExecuteAsync(
            async c => await folder.ReadAsync(program, MostBytes, c).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    /// <summary>Sends a program to the machine. On return it has been read back under its name and is identical to the last bit.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="replaces">SHA-256 of the program to be replaced, from an earlier check; null if there was none.</param>
    /// <param name="bytes">Its content.</param>
    /// <param name="tag">Part of the temporary name, so that people see the file's origin: 1 to 32 letters and digits.</param>
    /// <param name="cancellation">Cancels immediately; the machine then has the old program or the new one.</param>
    /// <exception cref="TransportException">It was not sent, or that is unknown; <see cref="RecoverAsync"/> and <see cref="CurrentAsync"/>
    /// find out.</exception>
    /// <returns>Null; or with a guard, why it is unknown whether the machine started the program while it was replaced.</returns>
    /// <exception cref="ChangedAtMachineException">The machine now has another program. It was not replaced.</exception>
    /// <exception cref="MachineBusyException">The machine runs the program or may run it, and it was not replaced; or the machine started
    /// it while it was replaced.</exception>
    public async Task<Statement?> SendAsync(
        string program, string? replaces, ReadOnlyMemory<byte> bytes, string tag, CancellationToken cancellation)
    {
        Demand(program);
        if (!ProgramNames.AllowsTag(tag))
            throw new ArgumentException($"The tag '{tag}' of a transfer must be 1 to 32 letters and digits.", nameof(tag));

        var isFirst = true;
        byte[]? there = null;
        await _tries.ExecuteAsync(
            async c =>
            {
                if (!isFirst && await IsThereAfterAllAsync(program, bytes, c).ConfigureAwait(false))
                    return;
                isFirst = false;
                there = await SendOnceAsync(program, replaces, bytes, tag, c).ConfigureAwait(false);
            },
            cancellation).ConfigureAwait(false);
        return guard is null
            ? null
            : await guard.AfterAsync(program, [MachinePrograms.Content(there), bytes], cancellation).ConfigureAwait(false);
    }

    /// <summary>Cleans up after an interrupted transfer: afterward the machine has the old program or the new one, complete, under its
    /// name, and no other file of the cell.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="cancellation">Cancels immediately.</param>
    /// <exception cref="TransportException">It failed; nothing is worse than before.</exception>
    /// <exception cref="ChangedAtMachineException">There are two programs that are stored nowhere else: a person must check
    /// them.</exception>
    /// <exception cref="MachineBusyException">A change of a person must get its place back, and the machine runs what is there.</exception>
    public async Task RecoverAsync(string program, CancellationToken cancellation)
    {
        Demand(program);
        await _tries.ExecuteAsync(async c => await RecoverOnceAsync(program, c).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    // An attempt may have succeeded although its reply was lost.
    private async Task<bool> IsThereAfterAllAsync(string program, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        await RecoverOnceAsync(program, cancellation).ConfigureAwait(false);
        return AreSame(await folder.ReadAsync(program, MostBytes, cancellation).ConfigureAwait(false), bytes);
    }

    // Returns the program that was replaced.
    private async Task<byte[]?> SendOnceAsync(string program, string? replaces, ReadOnlyMemory<byte> bytes, string tag,
        CancellationToken cancellation)
    {
        // Also before writing, so that a busy machine is not troubled with a file that it does not get.
        await DemandNotUsedAsync(program, [bytes], cancellation).ConfigureAwait(false);
        var written = ProgramNames.New(program, tag);
        try
        {
            if (!AreSame(await folder.WriteAsync(written, bytes, cancellation).ConfigureAwait(false), bytes))
                throw Differs(program, "was written under a temporary name", "The machine still has the old program.");

            // Writing is slow, and meanwhile a person may save at the control.
            var there = await LookAsync(program, replaces, bytes, cancellation).ConfigureAwait(false);
            if (!AreSame(await ReplaceAsync(written, program, replaces, bytes, there, cancellation).ConfigureAwait(false), bytes))
                throw Differs(program, "took its name", "Nobody may run it before it was sent again.");
            return there;
        }
        catch (Exception failure) when (failure is ChangedAtMachineException or MachineBusyException
            || (failure is TransportException { Error: var error } && IsReachable(error)))
        {
            await CleanAsync(program, cancellation).ConfigureAwait(false);
            throw;
        }
    }

    // A misread byte is not a change: a difference must be read identically twice.
    private async Task<byte[]?> LookAsync(
        string program, string? replaces, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var found = await folder.ReadAsync(program, MostBytes, cancellation).ConfigureAwait(false);
        if (HashOf(found) == replaces)
            return found;
        await DemandSameAsync(program, found, cancellation).ConfigureAwait(false);
        DemandUnchanged(program, replaces, bytes, found);
        return found;
    }

    private async Task DemandSameAsync(string name, byte[]? found, CancellationToken cancellation)
    {
        if (HashOf(found) != HashOf(await folder.ReadAsync(name, MostBytes, cancellation).ConfigureAwait(false)))
            throw new TransportException(
                TransportError.Differs,
                $"{folder.Machine}: {name} was read twice and was not twice the same. Nothing was replaced. "
                + "Somebody may be saving it; else look for a bad cable.");
    }

    private async Task<byte[]> ReplaceAsync(string written, string program, string? replaces, ReadOnlyMemory<byte> bytes, byte[]? there,
        CancellationToken cancellation)
    {
        var aside = ProgramNames.Old(written);
        await DemandNotUsedAsync(program, [MachinePrograms.Content(there), bytes], cancellation).ConfigureAwait(false);
        if (await folder.ReplaceAsync(written, program, aside, MostBytes, cancellation).ConfigureAwait(false) is { } replaced)
        {
            if (replaced.Was is { } was)
            {
                if (HashOf(was) != replaces && !AreSame(was, bytes))
                    await PutBackAsync(program, new(aside, was), bytes, cancellation).ConfigureAwait(false);
                DemandUnchanged(program, replaces, bytes, was);
                await folder.DeleteAsync(aside, cancellation).ConfigureAwait(false);
            }

            return replaced.There;
        }

        try
        {
            return await folder.RenameAsync(written, program, MostBytes, cancellation).ConfigureAwait(false);
        }
        catch (TransportException failure) when (failure.Error == TransportError.CannotReplace)
        {
            // The second step takes nothing away: once the old program is aside, its name is free.
            await DemandNotUsedAsync(program, [MachinePrograms.Content(there), bytes], cancellation).ConfigureAwait(false);
            var was = await folder.RenameAsync(program, aside, MostBytes, cancellation).ConfigureAwait(false);
            if (HashOf(was) != replaces && !AreSame(was, bytes))
                await folder.RenameAsync(aside, program, MostBytes, cancellation).ConfigureAwait(false);
            DemandUnchanged(program, replaces, bytes, was);
            var now = await folder.RenameAsync(written, program, MostBytes, cancellation).ConfigureAwait(false);
            await folder.DeleteAsync(aside, cancellation).ConfigureAwait(false);
            return now;
        }
    }

    // A transfer that was interrupted may belong to a process that is frozen, or to a server that is late: it may go on at any instant, by
    // one operation. So all its names are taken from it before anything else. Its new program is deleted. What it set aside gets a name
    // that only this attempt knows, and only then is it looked at. In this order: a new program becomes one set aside, never the reverse.
    private async Task RecoverOnceAsync(string program, CancellationToken cancellation)
    {
        var names = await folder.ListAsync(cancellation).ConfigureAwait(false);
        var written = names.Where(n => ProgramNames.IsNewOf(program, n)).ToArray();
        foreach (var name in written)
            await folder.DeleteAsync(name, cancellation).ConfigureAwait(false);
        if (written.Length > 0)
            names = await folder.ListAsync(cancellation).ConfigureAwait(false);

        var found = new List<AsideProgram>();
        foreach (var name in names.Where(n => ProgramNames.IsOldOf(program, n)))
        {
            var own = ProgramNames.Old(ProgramNames.New(program, "found"));
            found.Add(new(own, await folder.RenameAsync(name, own, MostBytes, cancellation).ConfigureAwait(false)));
        }

        if (found.Count > 0)
            await SettleAsync(program, found, cancellation).ConfigureAwait(false);
    }

    // What is stored nowhere else is a last-moment change: it gets the program's name. A free name gets the old program, or the new one
    // that a frozen sender took away: both are stored, and the sender then checks what the machine has.
    private async Task SettleAsync(string program, List<AsideProgram> found, CancellationToken cancellation)
    {
        var changes = found.Where(f => !isKept(HashOf(f.Was)!)).ToArray();
        foreach (var change in changes)
            await DemandSameAsync(change.Name, change.Was, cancellation).ConfigureAwait(false);

        var there = await folder.ReadAsync(program, MostBytes, cancellation).ConfigureAwait(false);
        var first = changes.Length > 0 ? changes[0] : found[0];
        var isOne = changes.All(f => AreSame(f.Was, first.Was));
        if (there is null || (changes.Length > 0 && !AreSame(there, first.Was)))
        {
            if (!isOne || (there is not null && !isKept(HashOf(there)!)))
                throw new ChangedAtMachineException(first.Was, Recorded.ChangedTwice.With(program, folder.Machine, first.Name));
            await PutBackAsync(program, first, MachinePrograms.Content(there), cancellation).ConfigureAwait(false);
        }
        else if (!isOne)
        {
            throw new ChangedAtMachineException(first.Was, Recorded.ChangedTwice.With(program, folder.Machine, first.Name));
        }

        foreach (var (name, _) in found)
            await folder.DeleteAsync(name, cancellation).ConfigureAwait(false);
    }

    // Gives the program that was set aside its name again. What has the name now is stored elsewhere; null if the name is free. What
    // turns out to have had it in the very moment, and is stored nowhere, is kept under the other name.
    private async Task PutBackAsync(string program, AsideProgram aside, ReadOnlyMemory<byte>? there, CancellationToken cancellation)
    {
        if (there is not null)
            await DemandNotUsedAsync(program, [MachinePrograms.Content(aside.Was), there], cancellation).ConfigureAwait(false);
        if (await folder.ReplaceAsync(aside.Name, program, aside.Name, MostBytes, cancellation).ConfigureAwait(false) is { } back)
        {
            DemandKept(program, aside.Name, back.Was, there);
            return;
        }

        try
        {
            await folder.RenameAsync(aside.Name, program, MostBytes, cancellation).ConfigureAwait(false);
        }
        catch (TransportException failure) when (failure.Error == TransportError.CannotReplace)
        {
            await DemandNotUsedAsync(program, [MachinePrograms.Content(aside.Was), there], cancellation).ConfigureAwait(false);
            var away = ProgramNames.Old(ProgramNames.New(program, "back"));
            var was = await folder.RenameAsync(program, away, MostBytes, cancellation).ConfigureAwait(false);
            await folder.RenameAsync(aside.Name, program, MostBytes, cancellation).ConfigureAwait(false);
            DemandKept(program, away, was, there);
            await folder.DeleteAsync(away, cancellation).ConfigureAwait(false);
        }
    }

    private void DemandKept(string program, string name, byte[]? was, ReadOnlyMemory<byte>? there)
    {
        if (was is not null && !(there is { } known && AreSame(was, known)) && !isKept(HashOf(was)!))
            throw new ChangedAtMachineException(was, Recorded.ChangedTwice.With(program, folder.Machine, name));
    }

    private void DemandUnchanged(string program, string? replaces, ReadOnlyMemory<byte> bytes, byte[]? found)
    {
        if (HashOf(found) is var hash && hash != replaces && !AreSame(found, bytes))
            throw new ChangedAtMachineException(found, Recorded.ChangedMeanwhile.With(program, folder.Machine, hash ?? "missing"));
    }

    // Frees the space on a full disk and restores the old program after a two-step rename. If that fails too, the first failure is the one
    // to report, and the next start recovers; but two programs that nobody keeps are more than any failure.
    private async Task CleanAsync(string program, CancellationToken cancellation)
    {
        try
        {
            await RecoverOnceAsync(program, cancellation).ConfigureAwait(false);
        }
        catch (Exception failure) when (failure is TransportException or MachineBusyException)
        {
        }
    }

    private Task DemandNotUsedAsync(string program, ReadOnlyMemory<byte>?[] contents, CancellationToken cancellation) =>
        guard?.DemandAsync(program, contents, cancellation) ?? Task.CompletedTask;

    private static bool IsReachable(TransportError error) => error is
        TransportError.Denied or TransportError.Full or TransportError.CannotReplace or TransportError.Differs or TransportError.TooLarge
        or TransportError.NotAFile or TransportError.Unknown;

    /// <summary>The hash of a program; null if there is none.</summary>
    internal static string? HashOf(byte[]? bytes) => bytes is null ? null : ContentHash.Sha256(bytes);

    private static bool AreSame(byte[]? there, ReadOnlyMemory<byte> bytes) => there is not null && there.AsSpan().SequenceEqual(bytes.Span);

    private void Demand(string program)
    {
        if (!ProgramNames.Allows(program))
            throw new TransportException(
                TransportError.Denied,
                $"{folder.Machine}: '{program}' is no name for a program at a machine. Allowed: {ProgramNames.Rule}. Change the slot's "
                    + $"program in the cell's configuration.");
    }

    // A program under a name of this attempt.
    private sealed record AsideProgram(string Name, byte[] Was);

    private TransportException Differs(string program, string when, string then) => new(
        TransportError.Differs,
        $"{folder.Machine}: {program} was read back after it {when} and is not what was sent. {then} If it happens again, look for a bad "
            + $"cable or a full or failing disk at the machine, or for a server that converts texts.");
}

/// <summary>A slot's program may not be replaced without asking a person. It is unchanged.</summary>
/// <param name="found">What the machine holds; null if nothing.</param>
/// <param name="message">A sentence for a setter.</param>
public sealed class ChangedAtMachineException(byte[]? found, Statement message) : Exception(message?.Sentence)
{
    /// <summary>What the machine holds; null if nothing.</summary>
    public byte[]? Found => found;

    /// <summary>The message as it is recorded.</summary>
    public Statement Statement => message;
}
