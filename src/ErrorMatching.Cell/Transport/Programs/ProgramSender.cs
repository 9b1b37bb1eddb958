using System.Security.Cryptography;
using Polly;

namespace ErrorMatching.Cell;

/// <summary>Brings programs to a machine so that the machine has the old one or the new one, whole, whatever fails and whenever, and so
/// that nothing that a person changed there is lost.</summary>
/// <remarks>
/// <para>
/// A program is written under a temporary name, read back, and compared. Then the program that is there is looked at once more, and only if
/// it is still the one that is to be replaced the new one is renamed over it and read back.
/// Where the transport can, what was there keeps a name until it is compared as well (<see cref="IMachineFolder.ReplaceAsync"/>): what
/// changed at the last moment gets its place back.
/// On a server that does not rename over a file, the old program is renamed aside first; if the way is cut right then, both lie there whole
/// under other names, and <see cref="RecoverAsync"/> puts the old one back.
/// </para>
/// <para>A temporary file is never taken for a program: only one that was read back and found equal is renamed. One sender at a time may work on a program.</para>
/// </remarks>
/// <param name="folder">The machine's folder.</param>
/// <param name="isKept">Whether a content is kept elsewhere, by its SHA-256 as 64 lower-case hexadecimal digits: only such a one is deleted
/// at the machine.</param>
/// <param name="tries">How often a transfer is tried, such as by <see cref="TransferTries.For"/>; null for once.</param>
public sealed class ProgramSender(IMachineFolder folder, Func<string, bool> isKept, ResiliencePipeline? tries = null)
{
    /// <summary>Larger programs are not read from a machine.</summary>
    public const long MostBytes = 256L << 20;

    private readonly ResiliencePipeline _tries = tries ?? ResiliencePipeline.Empty;

    /// <summary>The program that the machine has; null if it has none of this name.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="cancellation">Ends it at once.</param>
    /// <exception cref="TransportException">It could not be read.</exception>
    public async Task<byte[]?> CurrentAsync(string program, CancellationToken cancellation)
    {
        Demand(program);
        return await _tries.ExecuteAsync(async c => await folder.ReadAsync(program, MostBytes, c).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    /// <summary>Makes a program the machine's. When this returns it was read back under its name and is the same to the last bit.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="replaces">SHA-256 of the program that it takes the place of, as it was looked at; null if there was none.</param>
    /// <param name="bytes">Its content.</param>
    /// <param name="tag">Goes into the temporary name, so that people see whose it is: 1 to 32 letters and digits.</param>
    /// <param name="cancellation">Ends it at once; the machine then has the old program or the new one.</param>
    /// <exception cref="TransportException">It was not sent, or nobody knows; <see cref="RecoverAsync"/> and <see cref="CurrentAsync"/> tell.</exception>
    /// <exception cref="ChangedAtMachineException">Another program is there by now. It was not replaced.</exception>
    public async Task SendAsync(string program, string? replaces, ReadOnlyMemory<byte> bytes, string tag, CancellationToken cancellation)
    {
        Demand(program);
        if (!ProgramNames.AllowsTag(tag))
            throw new ArgumentException($"The tag '{tag}' of a transfer must be 1 to 32 letters and digits.", nameof(tag));

        var isFirst = true;
        await _tries.ExecuteAsync(
            async c =>
            {
                if (!isFirst && await IsThereAfterAllAsync(program, bytes, c).ConfigureAwait(false))
                    return;
                isFirst = false;
                await SendOnceAsync(program, replaces, bytes, tag, c).ConfigureAwait(false);
            },
            cancellation).ConfigureAwait(false);
    }

    /// <summary>Puts right what a cut transfer left: the machine has the old program or the new one, whole, under its name, and nothing else of ours.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="cancellation">Ends it at once.</param>
    /// <exception cref="TransportException">It could not be done; nothing is worse than before.</exception>
    /// <exception cref="ChangedAtMachineException">Two programs lie there that are kept nowhere else: a person has to look.</exception>
    public async Task RecoverAsync(string program, CancellationToken cancellation)
    {
        Demand(program);
        await _tries.ExecuteAsync(async c => await RecoverOnceAsync(program, c).ConfigureAwait(false), cancellation).ConfigureAwait(false);
    }

    // The answer of a try may have been lost after everything was done.
    private async Task<bool> IsThereAfterAllAsync(string program, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        await RecoverOnceAsync(program, cancellation).ConfigureAwait(false);
        return AreSame(await folder.ReadAsync(program, MostBytes, cancellation).ConfigureAwait(false), bytes);
    }

    private async Task SendOnceAsync(string program, string? replaces, ReadOnlyMemory<byte> bytes, string tag,
        CancellationToken cancellation)
    {
        var written = ProgramNames.New(program, tag);
        try
        {
            if (!AreSame(await folder.WriteAsync(written, bytes, cancellation).ConfigureAwait(false), bytes))
                throw Differs(program, "was written under a temporary name", "The machine still has the old program.");

            // Writing takes its time, and people save at the control.
            await LookAsync(program, replaces, bytes, cancellation).ConfigureAwait(false);
            if (!AreSame(await ReplaceAsync(written, program, replaces, bytes, cancellation).ConfigureAwait(false), bytes))
                throw Differs(program, "took its name", "Nobody may run it before it was sent again.");
        }
        catch (Exception failure) when (failure is ChangedAtMachineException
            || (failure is TransportException { Error: var error } && IsReachable(error)))
        {
            await CleanAsync(program, cancellation).ConfigureAwait(false);
            throw;
        }
    }

    // A byte that was read wrongly is no change of anybody's: a difference must be read twice alike.
    private async Task LookAsync(string program, string? replaces, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var found = await folder.ReadAsync(program, MostBytes, cancellation).ConfigureAwait(false);
        if (HashOf(found) == replaces)
            return;
        await DemandSameAsync(program, found, cancellation).ConfigureAwait(false);
        DemandUnchanged(program, replaces, bytes, found);
    }

    private async Task DemandSameAsync(string name, byte[]? found, CancellationToken cancellation)
    {
        if (HashOf(found) != HashOf(await folder.ReadAsync(name, MostBytes, cancellation).ConfigureAwait(false)))
            throw new TransportException(
                TransportError.Differs,
                $"{folder.Machine}: {name} was read twice and was not twice the same. Nothing was replaced. "
                + "Somebody may be saving it; else look for a bad cable.");
    }

    private async Task<byte[]> ReplaceAsync(string written, string program, string? replaces, ReadOnlyMemory<byte> bytes,
        CancellationToken cancellation)
    {
        var aside = ProgramNames.Old(program);
        if (await folder.ReplaceAsync(written, program, aside, MostBytes, cancellation).ConfigureAwait(false) is { } replaced)
        {
            if (replaced.Was is { } was)
            {
                if (HashOf(was) != replaces && !AreSame(was, bytes))
                    await PutBackAsync(program, cancellation).ConfigureAwait(false);
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
            var was = await folder.RenameAsync(program, aside, MostBytes, cancellation).ConfigureAwait(false);
            if (HashOf(was) != replaces && !AreSame(was, bytes))
                await folder.RenameAsync(aside, program, MostBytes, cancellation).ConfigureAwait(false);
            DemandUnchanged(program, replaces, bytes, was);
            var there = await folder.RenameAsync(written, program, MostBytes, cancellation).ConfigureAwait(false);
            await folder.DeleteAsync(aside, cancellation).ConfigureAwait(false);
            return there;
        }
    }

    private async Task RecoverOnceAsync(string program, CancellationToken cancellation)
    {
        var names = await folder.ListAsync(cancellation).ConfigureAwait(false);
        var aside = ProgramNames.Old(program);
        if (names.Contains(aside, StringComparer.Ordinal))
        {
            if (names.Contains(program, StringComparer.Ordinal))
                await SettleAsync(program, aside, cancellation).ConfigureAwait(false);
            else
                await folder.RenameAsync(aside, program, MostBytes, cancellation).ConfigureAwait(false);
        }

        foreach (var name in names.Where(n => ProgramNames.IsNewOf(program, n)))
            await folder.DeleteAsync(name, cancellation).ConfigureAwait(false);
    }

    // A cut left two programs. The one that is kept nowhere else is what somebody changed at the last moment: it has the slot.
    private async Task SettleAsync(string program, string aside, CancellationToken cancellation)
    {
        var was = await folder.ReadAsync(aside, MostBytes, cancellation).ConfigureAwait(false);
        if (was is null)
            return;
        if (!isKept(HashOf(was)!))
        {
            await DemandSameAsync(aside, was, cancellation).ConfigureAwait(false);
            var there = await folder.ReadAsync(program, MostBytes, cancellation).ConfigureAwait(false);
            if (!AreSame(there, was))
            {
                if (there is not null && !isKept(HashOf(there)!))
                    throw new ChangedAtMachineException(was, Recorded.ChangedTwice.With(program, folder.Machine, aside));
                await PutBackAsync(program, cancellation).ConfigureAwait(false);
            }
        }

        await folder.DeleteAsync(aside, cancellation).ConfigureAwait(false);
    }

    // What lies aside gets its place back; what has it is kept elsewhere.
    private async Task PutBackAsync(string program, CancellationToken cancellation)
    {
        var aside = ProgramNames.Old(program);
        if (await folder.ReplaceAsync(aside, program, aside, MostBytes, cancellation).ConfigureAwait(false) is not null)
            return;
        try
        {
            await folder.RenameAsync(aside, program, MostBytes, cancellation).ConfigureAwait(false);
        }
        catch (TransportException failure) when (failure.Error == TransportError.CannotReplace)
        {
            var away = ProgramNames.New(program, "back");
            await folder.RenameAsync(program, away, MostBytes, cancellation).ConfigureAwait(false);
            await folder.RenameAsync(aside, program, MostBytes, cancellation).ConfigureAwait(false);
            await folder.DeleteAsync(away, cancellation).ConfigureAwait(false);
        }
    }

    private void DemandUnchanged(string program, string? replaces, ReadOnlyMemory<byte> bytes, byte[]? found)
    {
        if (HashOf(found) is var hash && hash != replaces && !AreSame(found, bytes))
            throw new ChangedAtMachineException(found, Recorded.ChangedMeanwhile.With(program, folder.Machine, hash ?? "missing"));
    }

    // A full disk gets its room back and a two-step rename its old program. If that fails too, the first failure is the one to tell, and the next start recovers.
    private async Task CleanAsync(string program, CancellationToken cancellation)
    {
        try
        {
            await RecoverOnceAsync(program, cancellation).ConfigureAwait(false);
        }
        catch (Exception failure) when (failure is TransportException or ChangedAtMachineException)
        {
        }
    }

    private static bool IsReachable(TransportError error) => error is
        TransportError.Denied or TransportError.Full or TransportError.CannotReplace or TransportError.Differs or TransportError.TooLarge
        or TransportError.NotAFile or TransportError.Unknown;

    private static string? HashOf(byte[]? bytes) => bytes is null ? null : Convert.ToHexStringLower(SHA256.HashData(bytes));

    private static bool AreSame(byte[]? there, ReadOnlyMemory<byte> bytes) => there is not null && there.AsSpan().SequenceEqual(bytes.Span);

    private void Demand(string program)
    {
        if (!ProgramNames.Allows(program))
            throw new TransportException(TransportError.Denied, $"{folder.Machine}: '{program}' is no name for a program at a machine. Allowed: {ProgramNames.Rule}. Change the slot's program in the cell's configuration.");
    }

    private TransportException Differs(string program, string when, string then) => new(
        TransportError.Differs,
        $"{folder.Machine}: {program} was read back after it {when} and is not what was sent. {then} If it happens again, look for a bad cable or a full or failing disk at the machine, or for a server that converts texts.");
}
