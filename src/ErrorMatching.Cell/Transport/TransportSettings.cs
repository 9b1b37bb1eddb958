namespace ErrorMatching.Cell;

/// <summary>How a machine's programs are reached. Each kind has a folder next to this file: its settings, their reader, and its
/// transport.</summary>
/// <remarks>A new kind derives from this, is registered in <see cref="TransportKinds"/>, and gets its members in
/// <c>cell.schema.json</c>.</remarks>
public abstract record TransportSettings
{
    // Only the configuration's own kinds can derive from this.
    private protected TransportSettings()
    {
    }

    /// <summary>Where the programs are, for display: a path, or a URI without a password.</summary>
    public abstract string Address { get; }

    /// <summary>The program folder on this computer or a share of it; null if it is on a server.</summary>
    public virtual string? LocalFolder => null;

    /// <summary>The private key for the login; null for none.</summary>
    public virtual string? SignInKey => null;

    /// <summary>True if the login uses a password from the store.</summary>
    public abstract bool NeedsPassword { get; }

    /// <summary>True if both lead to the same programs, or one contains the other.</summary>
    internal abstract bool IsSamePlace(TransportSettings other);

    /// <summary>Opens the program folder. It connects only on the first operation.</summary>
    /// <param name="machine">The machine's name.</param>
    /// <param name="secret">Returns the machine's password each time it is needed.</param>
    /// <param name="limit">The longest that one transfer may take.</param>
    internal abstract IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit);
}
