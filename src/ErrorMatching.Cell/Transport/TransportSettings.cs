namespace ErrorMatching.Cell;

/// <summary>How a machine's programs are reached. Each kind is a folder beside this file: its settings, how they are read, and its transport.</summary>
/// <remarks>A new kind derives from this, is registered in <see cref="TransportKinds"/>, and gets its members in <c>cell.schema.json</c>.</remarks>
public abstract record TransportSettings
{
    // A machine is reached in the ways that the configuration can name.
    private protected TransportSettings()
    {
    }

    /// <summary>Where the programs are, for people: a path, or a URI without a password.</summary>
    public abstract string Address { get; }

    /// <summary>The programs' folder on this computer or a share of it; null where a server has it.</summary>
    public virtual string? LocalFolder => null;

    /// <summary>The private key that signs in; null if none does.</summary>
    public virtual string? SignInKey => null;

    /// <summary>True if a password of the store signs in.</summary>
    public abstract bool NeedsPassword { get; }

    /// <summary>True if both lead to the same programs, or into one another.</summary>
    internal abstract bool IsSamePlace(TransportSettings other);

    /// <summary>The folder of programs. Nothing is connected before the first operation.</summary>
    /// <param name="machine">What people call the machine.</param>
    /// <param name="secret">The machine's password, asked again whenever it is needed.</param>
    /// <param name="limit">How long one transfer may take.</param>
    internal abstract IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit);
}
