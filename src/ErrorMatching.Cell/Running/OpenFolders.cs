namespace ErrorMatching.Cell;

/// <summary>The program folders of all machines, open as long as a cell runs.</summary>
internal sealed class OpenFolders(CellSettings settings, Func<MachineSettings, IMachineFolder> open) : IDisposable
{
    /// <summary>Each machine and its folder.</summary>
    public IReadOnlyList<(MachineSettings Machine, IMachineFolder Folder)> All { get; } = [.. settings.Machines.Select(m => (m, open(m)))];

    public void Dispose()
    {
        foreach (var (_, folder) in All)
        {
            folder.Dispose();
        }
    }
}
