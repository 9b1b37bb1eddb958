namespace ErrorMatching.Cell;

/// <summary>Opens the folders of machines.</summary>
public static class MachineFolders
{
    /// <summary>The folder of a machine, accessed by its transport. It connects only on the first operation.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="secret">Returns the machine's password each time it is needed; may return null if the machine needs none.</param>
    public static IMachineFolder Open(MachineSettings machine, Func<string?> secret)
    {
        ArgumentNullException.ThrowIfNull(machine);
        return machine.Transport.Open(machine.Name, secret, machine.Timeout);
    }
}
