namespace ErrorMatching.Cell;

/// <summary>Counts every few seconds what waits at a gauge. That it grows, or that a piece waits too long, is a trouble: the cell goes on,
/// and what it does comes too late.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="gauge">The gauge.</param>
internal sealed class BacklogWorker(CellFlow flow, GaugeSettings gauge)
{
    // Counting takes at most this part of the time, however slow the folder is.
    private const int Share = 20;

    private readonly WaitingFiles _files = new(gauge, flow.Clock);
    private readonly Growth _growth = new(flow.Pace.BacklogGrowth / 3);
    private readonly long _begun = flow.Clock.GetTimestamp();
    private readonly string _where = CellTrouble.OfBacklog(gauge.Name);

    /// <summary>Counts once.</summary>
    /// <returns>How long to wait before counting again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var begun = flow.Clock.GetTimestamp();
        var backlog = GaugeBacklog.Of(gauge.Name, _files.Count(), GaugeBacklog.InStore(flow.Store));
        backlog = backlog with { IsGrowing = _growth.Add(flow.Clock.GetElapsedTime(_begun), backlog.Count) };
        flow.Backlogs.Note(backlog);
        Report(backlog);
        var taken = Share * flow.Clock.GetElapsedTime(begun);
        return Task.FromResult(taken > flow.Pace.Backlog ? taken : flow.Pace.Backlog);
    }

    private void Report(GaugeBacklog backlog)
    {
        if (backlog.Since is { } since && flow.Clock.GetUtcNow() - since >= gauge.WaitLimit)
        {
            Begin(CellCodes.PieceWaits, Recorded.PieceWaits.With(
                since, gauge.WaitLimit.TotalMinutes, gauge.Name, backlog.Files, backlog.Pieces));
        }
        else if (backlog.IsGrowing)
        {
            Begin(CellCodes.BacklogGrows, Recorded.BacklogGrows.With(gauge.Name, backlog.Files, backlog.Pieces));
        }
        else if (flow.Troubles.End(_where))
        {
            flow.Log.Information("{Where}: it is worked off again", _where);
        }
    }

    private void Begin(string code, Reporting.Statement message)
    {
        if (flow.Troubles.Begin(_where, code, message)) flow.Log.Warning("{Where}: {Code}: {Message:l}", _where, code, message.Sentence);
    }
}

/// <summary>Says whether a number grows: whether it is larger every third of a minute than the third before, for a whole minute. A number
/// that jumps and then shrinks does not grow.</summary>
/// <param name="third">A third of the time that it must grow for.</param>
internal sealed class Growth(TimeSpan third)
{
    /// <summary>A smaller number comes and goes.</summary>
    public const int Least = 10;

    private readonly List<(TimeSpan At, long Count)> _samples = [];
    private long? _noticed;

    /// <summary>Adds what the number is now.</summary>
    /// <param name="at">The time, by a clock that nobody sets.</param>
    /// <param name="count">The number.</param>
    /// <returns>True if it has grown for a minute, and has not become smaller than it was then.</returns>
    public bool Add(TimeSpan at, long count)
    {
        if (_samples is not [.., var last] || at - last.At >= third)
        {
            _samples.Add((at, count));
            if (_samples.Count > 4) _samples.RemoveAt(0);
        }

        if (count < (_noticed ?? 0)) _noticed = null;
        if (_noticed is null && count >= Least && _samples is [var a, var b, var c, var d]
            && a.Count < b.Count && b.Count < c.Count && c.Count < d.Count && d.Count <= count)
        {
            _noticed = count;
        }

        return _noticed is not null;
    }
}
