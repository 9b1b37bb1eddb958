namespace ErrorMatching.Nc;

/// <summary>
/// Some motions of a path, as runs without gap: what was named is mostly a few stretches, so that this takes little memory,
/// and looking one up after the other little time.
/// </summary>
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

    /// <summary>Adds a motion behind all others.</summary>
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

    /// <summary>True if a motion is among them.</summary>
    public bool Contains(int motion) => IndexOf(motion) >= 0;

    /// <summary>Position of a motion among them, -1 where it is not.</summary>
    public int IndexOf(int motion)
    {
        if (_runs.Count == 0)
        {
            return -1;
        }

        // Motions are mostly asked for in their order, by two cores in different places:
        // what the other remembers must not change under this one's hands.
        var recent = _recent;
        var run = _runs[recent];
        if (motion < run.First || motion > run.Last)
        {
            _recent = recent = RunFrom(motion, recent);
            run = _runs[recent];
        }

        return motion >= run.First && motion <= run.Last ? run.Index + motion - run.First : -1;
    }

    // The last run that begins at a motion or before it, or the first run of all.
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
