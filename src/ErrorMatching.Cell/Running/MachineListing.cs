namespace ErrorMatching.Cell;

/// <summary>The names in a machine's folder, listed once for all slots that ask at about the same time: a control is no server for many.</summary>
/// <param name="folder">The machine's folder.</param>
/// <param name="clock">The clock.</param>
/// <param name="age">A listing that is older is not handed out again.</param>
internal sealed class MachineListing(IMachineFolder folder, TimeProvider clock, TimeSpan age)
{
    private readonly Lock _gate = new();
    private Task<IReadOnlyList<string>>? _names;
    private long _begun;

    /// <summary>The names.</summary>
    /// <param name="notBefore">The listing must have begun at this timestamp or later: what lay there before counts for nothing.</param>
    /// <param name="cancellation">Ends it, for all who wait for it.</param>
    /// <exception cref="TransportException">The machine cannot be asked.</exception>
    public Task<IReadOnlyList<string>> NamesAsync(long notBefore, CancellationToken cancellation)
    {
        lock (_gate)
        {
            if (_names is null || _names.IsFaulted || _names.IsCanceled || _begun < notBefore || clock.GetElapsedTime(_begun) >= age)
            {
                _begun = clock.GetTimestamp();
                _names = folder.ListAsync(cancellation);
            }

            return _names;
        }
    }
}
