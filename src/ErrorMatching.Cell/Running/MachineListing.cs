namespace ErrorMatching.Cell;

/// <summary>The names in a machine's folder, listed once for all slots that ask at about the same time, because a control cannot serve many
/// requests.</summary>
/// <param name="folder">The machine's folder.</param>
/// <param name="clock">The clock.</param>
/// <param name="age">Maximum age of a listing to be returned again.</param>
internal sealed class MachineListing(IMachineFolder folder, TimeProvider clock, TimeSpan age)
{
    private readonly Lock _gate = new();
    private Task<IReadOnlyList<string>>? _names;
    private long _begun;

    /// <summary>The names.</summary>
    /// <param name="notBefore">The listing must have started at this timestamp or later: earlier files must be ignored.</param>
    /// <param name="cancellation">Cancels the listing for all callers that wait for it.</param>
    /// <exception cref="TransportException">The machine cannot be listed.</exception>
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
