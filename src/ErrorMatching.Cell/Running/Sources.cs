namespace ErrorMatching.Cell;

/// <summary>The workers of all gauges, which listen for folder changes until they are disposed of.</summary>
internal sealed class Sources(CellFlow flow, Func<MachineSettings, IMachineFolder> open) : IDisposable
{
    /// <summary>Each gauge's name and worker.</summary>
    public IReadOnlyList<(string Gauge, SourceWorker Source)> All { get; } = [
        .. flow.Settings.Gauges.Select(g => (g.Name, new SourceWorker(flow, g, open)))];

    public void Dispose()
    {
        foreach (var (_, source) in All)
        {
            source.Dispose();
        }
    }
}
