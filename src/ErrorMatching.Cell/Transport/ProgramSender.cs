using Polly;

namespace ErrorMatching.Cell;

/// <summary>Brings programs to a machine so that the machine has the old one or the new one, whole, whatever fails and whenever.</summary>
/// <remarks>
/// <para>
/// A program is written under a temporary name, read back, compared, renamed over the old one, and read back again. On a server that does not rename over a file,
/// the old program is renamed aside first; if the way is cut right then, both lie there whole under other names, and <see cref="RecoverAsync"/> puts the old one back.
/// </para>
/// <para>A temporary file is never taken for a program: only one that was read back and found equal is renamed. One sender at a time may work on a program.</para>
/// </remarks>
/// <param name="folder">The machine's folder.</param>
/// <param name="tries">How often a transfer is tried, such as by <see cref="TransferTries.For"/>; null for once.</param>
public sealed class ProgramSender(IMachineFolder folder, ResiliencePipeline? tries = null)
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
    /// <param name="bytes">Its content.</param>
    /// <param name="tag">Goes into the temporary name, so that people see whose it is: 1 to 32 letters and digits.</param>
    /// <param name="cancellation">Ends it at once; the machine then has the old program or the new one.</param>
    /// <exception cref="TransportException">It was not sent, or nobody knows; <see cref="RecoverAsync"/> and <see cref="CurrentAsync"/> tell.</exception>
    public async Task SendAsync(string program, ReadOnlyMemory<byte> bytes, string tag, CancellationToken cancellation)
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
                await SendOnceAsync(program, bytes, tag, c).ConfigureAwait(false);
            },
            cancellation).ConfigureAwait(false);
    }

    /// <summary>Puts right what a cut transfer left: the machine has the old program or the new one, whole, under its name, and nothing else of ours.</summary>
    /// <param name="program">Its name there; see <see cref="ProgramNames.Rule"/>.</param>
    /// <param name="cancellation">Ends it at once.</param>
    /// <exception cref="TransportException">It could not be done; nothing is worse than before.</exception>
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

    private async Task SendOnceAsync(string program, ReadOnlyMemory<byte> bytes, string tag, CancellationToken cancellation)
    {
        var written = ProgramNames.New(program, tag);
        try
        {
            if (!AreSame(await folder.WriteAsync(written, bytes, cancellation).ConfigureAwait(false), bytes))
                throw Differs(program, "was written under a temporary name", "The machine still has the old program.");
            if (!AreSame(await ReplaceAsync(written, program, cancellation).ConfigureAwait(false), bytes))
                throw Differs(program, "took its name", "Nobody may run it before it was sent again.");
        }
        catch (TransportException failure) when (IsReachable(failure))
        {
            await CleanAsync(program, cancellation).ConfigureAwait(false);
            throw;
        }
    }

    private async Task<byte[]> ReplaceAsync(string written, string program, CancellationToken cancellation)
    {
        try
        {
            return await folder.RenameAsync(written, program, MostBytes, cancellation).ConfigureAwait(false);
        }
        catch (TransportException failure) when (failure.Error == TransportError.CannotReplace)
        {
            // The program is there, or nothing would have been in the way: an old one kept aside is not needed.
            var aside = ProgramNames.Old(program);
            await folder.DeleteAsync(aside, cancellation).ConfigureAwait(false);
            await folder.RenameAsync(program, aside, MostBytes, cancellation).ConfigureAwait(false);
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
                await folder.DeleteAsync(aside, cancellation).ConfigureAwait(false);
            else
                await folder.RenameAsync(aside, program, MostBytes, cancellation).ConfigureAwait(false);
        }

        foreach (var name in names.Where(n => ProgramNames.IsNewOf(program, n)))
            await folder.DeleteAsync(name, cancellation).ConfigureAwait(false);
    }

    // A full disk gets its room back and a two-step rename its old program. If that fails too, the first failure is the one to tell, and the next start recovers.
    private async Task CleanAsync(string program, CancellationToken cancellation)
    {
        try
        {
            await RecoverOnceAsync(program, cancellation).ConfigureAwait(false);
        }
        catch (TransportException)
        {
        }
    }

    private static bool IsReachable(TransportException failure) => failure.Error is
        TransportError.Denied or TransportError.Full or TransportError.CannotReplace or TransportError.Differs or TransportError.TooLarge or TransportError.Unknown;

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
