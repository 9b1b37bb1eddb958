namespace ErrorMatching.Cell;

/// <summary>Takes a gauge's finished files into the store.</summary>
internal sealed class SourceWorker : IDisposable
{
    private readonly CellFlow _flow;
    private readonly GaugeSettings _gauge;
    private readonly FileSource? _files;
    private readonly MachineSource? _logs;
    private readonly IMachineFolder? _folder;

    /// <summary>Creates the worker of a gauge.</summary>
    /// <param name="flow">State shared by the workers.</param>
    /// <param name="gauge">The gauge.</param>
    /// <param name="open">Opens the machine's folder for a gauge whose logs are fetched.</param>
    public SourceWorker(CellFlow flow, GaugeSettings gauge, Func<MachineSettings, IMachineFolder> open)
    {
        (_flow, _gauge) = (flow, gauge);
        if (gauge.Machine is { } machine)
        {
            _folder = open(flow.Settings.Machines.First(m => m.Name == machine));
            _logs = new(gauge, _folder, flow.Clock);
        }
        else
        {
            _files = new(gauge, flow.Clock);
        }
    }

    /// <summary>Takes the finished files.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        if (_logs is not null)
        {
            await _logs.TakeAsync(Archive, stop);
            ReportLeft(_logs.Left);
            return _gauge.Every;
        }

        _files!.Take(Archive, ArchiveUnread, stop);
        ReportLeft(_files.Left);
        await _files.WaitAsync(stop);
        return TimeSpan.Zero;
    }

    public void Dispose()
    {
        _files?.Dispose();
        _folder?.Dispose();
    }

    private void Archive(Arrival arrival)
    {
        using var activity = CellTelemetry.Begin(_gauge.Name, arrival.FileName);
        _flow.Arrive(() => _flow.Store.Archive(arrival with { Trace = activity?.Id }));
    }

    private void ArchiveUnread(UnreadArrival arrival)
    {
        using var activity = CellTelemetry.Begin(_gauge.Name, arrival.FileName);
        _flow.Arrive(() => _flow.Store.ArchiveUnread(arrival with { Trace = activity?.Id }));
    }

    private void ReportLeft(IReadOnlyList<LeftFile> left)
    {
        var where = $"files of gauge {_gauge.Name}";
        if (left.Count == 0)
        {
            _flow.Troubles.End(where);
        }
        else if (_flow.Troubles.Begin(
            where, CellCodes.FileLeft, $"{left[0].Name}: {left[0].Reason}{(left.Count > 1 ? " And others." : "")}"))
        {
            _flow.Log.Warning("{Where}: {File} is left: {Reason}", where, left[0].Name, left[0].Reason);
        }
    }
}
