namespace ErrorMatching.Nc;

/// <summary>Some motions of a path, stored as runs without a gap. Named motions are mostly a few stretches, so this needs little memory
/// and consecutive lookups are fast.</summary>
internal sealed class MotionRuns
{
    private readonly List<(int First, int Last, int Index)> _runs = [];
    private int _recent;

    /// <summary>Number of motions.</summary>
    public int Motions { get; private set; }

    /// <summary>Number of runs.</summary>
    public int Count => _runs.Count;

    /// <summary>First and last motion of a run.</summary>
    public (int First, int Last) this[int run] => (_runs[run].First, _runs[run].Last);

    /// <summary>Adds a motion after all others.</summary>
    public void Add(int motion)
    {
        if (_runs.Count > 0 && _runs[^1].Last + 1 == motion)
        {
            _runs[^1] = _runs[^1] with { Last = motion };
        }
        else
        {
            _runs.Add((motion, motion, Motions));
        }

        Motions++;
    }

    /// <summary>True if it has a motion.</summary>
    public bool Contains(int motion) => IndexOf(motion) >= 0;

    /// <summary>Position of a motion among them; -1 if it is not one of them.</summary>
    public int IndexOf(int motion)
    {
        if (_runs.Count == 0)
        {
            return -1;
        }

        // Lookups are mostly in order, by two threads in different places. Use one copy of the cached run, since the other thread may
        // change it.
        var recent = _recent;
        var run = _runs[recent];
        if (motion < run.First || motion > run.Last)
        {
            _recent = recent = RunFrom(motion, recent);
            run = _runs[recent];
        }

        return motion >= run.First && motion <= run.Last ? run.Index + motion - run.First : -1;
    }

    // The last run that begins at or before a motion, or the first run of all.
    private int RunFrom(int motion, int recent)
    {
        if (recent + 1 < _runs.Count && _runs[recent].Last < motion && motion < _runs[recent + 1].First)
        {
            return recent;
        }

        var (low, high) = (0, _runs.Count - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (_runs[middle].First <= motion)
            {
                low = middle;
            }
            else
            {
                high = middle - 1;
            }
        }

        return low;
    }
}
