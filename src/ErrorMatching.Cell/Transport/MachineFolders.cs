namespace ErrorMatching.Cell;

/// <summary>Opens the folders of machines.</summary>
public static class MachineFolders
{
    /// <summary>The folder of a machine, reached by its transport. Nothing is connected before the first operation.</summary>
    /// <param name="machine">The machine.</param>
    /// <param name="secret">The machine's password, asked anew whenever it is needed; may answer null where a machine needs none.</param>
    public static IMachineFolder Open(MachineSettings machine, Func<string?> secret)
    {
        ArgumentNullException.ThrowIfNull(machine);
        return machine.Transport.Open(machine.Name, secret, machine.Timeout);
    }
}
