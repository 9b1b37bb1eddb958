using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Logs at a machine, fetched over the same transport that sends programs. A log is finished when its content has stayed the same
/// or has its end mark. A log that is not kept at the machine is renamed, read once more and then deleted, so that nothing is deleted
/// unread.</summary>
/// <param name="gauge">The gauge, with a machine.</param>
/// <param name="folder">The machine's folder.</param>
/// <param name="clock">Measures how long a log has been unchanged.</param>
internal sealed class MachineSource(GaugeSettings gauge, IMachineFolder folder, TimeProvider clock)
{
    /// <summary>Suffix of a log's name while it is being taken.</summary>
    public const string Suffix = ".taken";

    private readonly Dictionary<string, (string Sha256, long Since, bool IsArchived)> _seen = new(StringComparer.Ordinal);
    private List<LeftFile> _left = [];

    /// <summary>Files that match the gauge's pattern and that the last look left where they are.</summary>
    public IReadOnlyList<LeftFile> Left => _left;

    /// <summary>Takes the finished logs.</summary>
    /// <param name="archive">Stores an arrival permanently before it returns. If it throws, the log is left for the next look. The store
    /// recognizes a log that it already has by its key.</param>
    /// <param name="cancellation">Cancels the transfers.</param>
    /// <returns>How many were taken.</returns>
    /// <exception cref="TransportException">The machine cannot be reached.</exception>
    public async Task<int> TakeAsync(Action<Arrival> archive, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(archive);
        var left = new List<LeftFile>();
        var names = (await folder.ListAsync(cancellation).ConfigureAwait(false)).Order(StringComparer.Ordinal).ToArray();
        var taken = 0;

        // Logs that an earlier run renamed are finished and come first: the name must be free for the next one.
        var renamed = names.Where(
            n => n.EndsWith(Suffix, StringComparison.Ordinal) && FileNamePattern.Fits(gauge.Files, n[..^Suffix.Length])).ToArray();
        var ours = names.Where(n => FileNamePattern.Fits(gauge.Files, n) && !n.EndsWith(Suffix, StringComparison.Ordinal)).ToArray();
        foreach (var name in renamed.Concat(ours))
        {
            if (!ProgramNames.IsPlain(name + Suffix))
            {
                left.Add(new(
                    ShownName.Of(name), "its name is too long or has characters that transfers do not carry. Rename it at the machine."));
                continue;
            }

            try
            {
                taken += await (
                    name.EndsWith(Suffix, StringComparison.Ordinal)
                        ? FinishAsync(name[..^Suffix.Length], archive, cancellation)
                        : TakeAsync(name, archive, cancellation)).ConfigureAwait(false);
            }
            catch (TransportException e) when (e.Error == TransportError.TooLarge)
            {
                left.Add(new(
                    ShownName.Of(name),
                    $"it is larger than the {gauge.MostBytes} bytes that \"{gauge.Name}\" takes. Delete it at the machine, or raise "
                        + $"mostMB of the gauge."));
            }
            catch (TransportException e) when (e.Error == TransportError.NotAFile)
            {
                left.Add(new(
                    ShownName.Of(name),
                    "it is a link, a pipe, a device or a folder at the machine, and only plain files are taken. Remove it there."));
            }
        }

        foreach (var gone in _seen.Keys.Except(ours, StringComparer.Ordinal).ToArray())
        {
            _seen.Remove(gone);
        }

        _left = left;
        return taken;
    }

    private async Task<int> TakeAsync(string name, Action<Arrival> archive, CancellationToken cancellation)
    {
        if (await folder.ReadAsync(name, gauge.MostBytes, cancellation).ConfigureAwait(false) is not { Length: > 0 } bytes)
        {
            return 0;
        }

        var (sha256, now) = (ContentHash.Sha256(bytes), clock.GetTimestamp());
        if (!_seen.TryGetValue(name, out var seen) || seen.Sha256 != sha256)
        {
            seen = (sha256, now, false);
            _seen[name] = seen;
            if (gauge.Finished is not FinishedByEndMark)
            {
                return 0;
            }
        }

        var isFinished = gauge.Finished switch
        {
            FinishedByEndMark mark => EndMark.Ends(bytes, mark.Mark),
            FinishedAtRest rest => clock.GetElapsedTime(seen.Since, now) >= rest.For,
            _ => throw new InvalidOperationException("A log at a machine is finished at rest or by its end mark."),
        };
        if (!isFinished)
        {
            return 0;
        }

        var taken = 0;
        if (!seen.IsArchived)
        {
            archive(Arrival(name, bytes, sha256));
            _seen[name] = seen with { IsArchived = true };
            taken = 1;
        }

        if (!gauge.KeepsFile)
        {
            var renamed = await folder.RenameAsync(name, name + Suffix, gauge.MostBytes, cancellation).ConfigureAwait(false);
            taken += await FinishAsync(name, renamed, sha256, archive, cancellation).ConfigureAwait(false);
        }

        return taken;
    }

    // What the control wrote between the reading and the renaming is also archived before the log is deleted.
    private async Task<int> FinishAsync(
        string name, byte[]? renamed, string? archived, Action<Arrival> archive, CancellationToken cancellation)
    {
        var taken = 0;
        if (renamed is { Length: > 0 } && ContentHash.Sha256(renamed) is var sha256 && sha256 != archived)
        {
            archive(Arrival(name, renamed, sha256));
            taken = 1;
        }

        await folder.DeleteAsync(name + Suffix, cancellation).ConfigureAwait(false);
        _seen.Remove(name);
        return taken;
    }

    private async Task<int> FinishAsync(string name, Action<Arrival> archive, CancellationToken cancellation) =>
        await FinishAsync(
            name,
            await folder.ReadAsync(name + Suffix, gauge.MostBytes, cancellation).ConfigureAwait(false),
            null,
            archive,
            cancellation).ConfigureAwait(false);

    private Arrival Arrival(string name, byte[] bytes, string sha256) =>
        new(gauge.Name, ShownName.Of(name), ArrivalKey.Of(gauge.Name, name, sha256), bytes);
}
