namespace ErrorMatching.Nc;

/// <summary>The branches of a run on values that only the machine knows. At each, both ways are executed by runs of their own from the
/// beginning of the program. If they meet in the same state, the run goes on: what it does from there on does not depend on the
/// way.</summary>
/// <remarks>
/// A way may contain only blocks that change nothing but modes, the tool's place and variables (<see cref="ModeWords"/>),
/// so that two runs can be compared by them. Where the ways meet, variables that differ become unknown. Motions of only one way begin
/// and end at one place, which must not move, and their blocks must not change.
/// </remarks>
internal sealed class Forks
{
    private readonly NcControl _control;
    private readonly ProgramRun _run;
    private readonly RunResult _result;
    private readonly BlockExecutor _executor;
    private readonly List<Fork> _known;
    private readonly List<Fork> _open = [];
    private readonly SortedSet<int> _blocks = [];
    private readonly ForkLimits _limits;
    private readonly int _depth;
    private readonly WayTrace? _other;
    private readonly bool _tries;
    private int _next;

    /// <param name="control">The control of the run.</param>
    /// <param name="executor">Executes its blocks.</param>
    /// <param name="trial">The way that this run tries; null for the run itself.</param>
    public Forks(NcControl control, BlockExecutor executor, Trial? trial)
    {
        (_control, _run, _result, _executor) = (control, control.Run, control.Result, executor);
        _known = [.. trial?.Known ?? []];
        _limits = trial?.Limits ?? new(LeastBlocks + (BlocksPerBlock * (long)_run.Program.BlockCount));
        (_depth, _other, _tries) = (trial?.Depth ?? 0, trial?.Other, trial is not null);
        _run.Decide = Decide;
    }

    private const long LeastBlocks = 200_000;
    private const long BlocksPerBlock = 20;

    /// <summary>The way that this run tries, since its branch.</summary>
    public WayTrace? Trace { get; private set; }

    /// <summary>True while the run is on a way that has not yet met the other one.</summary>
    public bool AreOpen => _open.Count > 0;

    /// <summary>Blocks of the program that move in only one of the ways of some branch.</summary>
    public IReadOnlyCollection<int> Blocks => _blocks;

    /// <summary>A run that tries a way.</summary>
    /// <param name="Known">The branches before, and the tried way.</param>
    /// <param name="Limits">How much may be tried in all.</param>
    /// <param name="Depth">Number of ways inside of which this one is.</param>
    /// <param name="Other">The other way, if it was tried.</param>
    internal sealed record Trial(IReadOnlyList<Fork> Known, ForkLimits Limits, int Depth, WayTrace? Other);

    /// <summary>Reaches a block: ends the ways that meet here. False if a run that tries a way has seen enough.</summary>
    public bool Arrive()
    {
        if (_open.Count > 0)
        {
            var place = Place();
            while (_open.Count > 0 && _open[^1].Join == place)
            {
                foreach (var key in _open[^1].Forgotten)
                {
                    _run.Flow.Variables.Forget(key);
                }

                _open.RemoveAt(_open.Count - 1);
            }
        }

        return !_tries || (_limits.TryTake() && (Trace is null || Observe(Trace)));
    }

    // Compares the first time that the run is at a place: there, the run that goes on ends the way. False if both ways have met.
    private bool Observe(WayTrace trace)
    {
        if (_executor.HasOnlyModes && _executor.CanBranch() && _open.Count == 0 && Place() is var place && trace.At(place) is null)
        {
            var step = new WayStep(_control.State, _run.Flow.Variables.Snapshot(), _result.Motions.Length, _result.Problems.Count,
                _run.Flow.Variables.MachineWrites);
            if (_other?.At(place) is { } met && met.IsAs(step))
            {
                trace.Meets = (step, met);
                return false;
            }

            trace.Add(place, step);
        }

        // What comes may still be the end of the program.
        return ++_seen < ForkLimits.Way;
    }

    private int _seen;

    // Called by the flow where only the machine knows which way the program goes.
    private bool? Decide()
    {
        if (_next == _known.Count)
        {
            if (Resolve() is not { } found)
            {
                return null;
            }

            _known.Add(found);
        }

        var fork = _known[_next++];
        if (_tries && Trace is null && _next == _known.Count)
        {
            Trace = new() { FirstMotion = _result.Motions.Length, Motions = _result.Motions };
            _executor.HasOnlyModes = true;
            return fork.Way;
        }

        if (fork.Differs)
        {
            _result.DependOnPlace();
        }

        _blocks.UnionWith(fork.Blocks);
        if (fork.Join is null)
        {
            _result.Note("conditional-stop",
                "Which way the program goes here is known to the machine only. One way ends it without another cut; "
                    + "the other one is shown.");
        }
        else
        {
            _result.Note("either-way",
                "Which way the program goes here is known to the machine only. Both ways were executed, and lead to the same.");
        }

        if (fork.Join is not null)
        {
            _open.Add(fork);
        }

        return fork.Way;
    }

    private Fork? Resolve()
    {
        if (_depth >= ForkLimits.Depth || !_executor.CanBranch())
        {
            return null;
        }

        var isCompensated = _control.State.Compensation != MotionFlags.None;
        if (Try(true, null).Trace is not { } yes || Try(false, yes) is not ({ } no, var meeting))
        {
            return null;
        }

        if (no.Meets is { } met)
        {
            var (motions, others) = (no.Until(met.Own.Motions), yes.Until(met.Other.Motions));
            var differs = !motions.AsSpan().SequenceEqual(others);
            return differs && (isCompensated || motions.Concat(others).Any(IsCompensated))
                ? null
                : new(motions.Length < others.Length, meeting, differs, BlocksOf(differs ? [.. motions, .. others] : []),
                    met.Own.DifferencesFrom(met.Other));
        }

        // A way that only ends the program: what can be displaced is on the other one.
        var ending = OnlyEnds(yes) ? yes : OnlyEnds(no) ? no : null;
        var tail = ending?.Until(ending.Motions.Length) ?? [];
        return ending is null || isCompensated ? null : new(!ReferenceEquals(ending, yes), null, tail.Length > 0, BlocksOf(tail), []);
    }

    private static bool IsCompensated(NcMotion motion) =>
        motion.Has(MotionFlags.CompensationLeft) || motion.Has(MotionFlags.CompensationRight);

    private static bool OnlyEnds(WayTrace way) => way.Ends && !Array.Exists(way.Until(way.Motions.Length), m => m.IsCut);

    private (WayTrace? Trace, string? Meeting) Try(bool way, WayTrace? other) =>
        NcInterpreter.Try(_control, new([.. _known, Fork.Tried(way)], _limits, _depth + 1, other));

    private static SortedSet<int> BlocksOf(IReadOnlyCollection<NcMotion> motions) => [.. motions.Select(m => m.Block)];

    /// <summary>Where the run is, with all that decides what runs next.</summary>
    public string Place() => _run.Flow.PlaceAt(_run.At);
}

/// <summary>A branch on a value that only the machine knows, after both ways were executed.</summary>
/// <param name="Way">The way that the run takes: true where the condition holds, or where block skip is on.</param>
/// <param name="Join">Where both ways meet; null if the other one ends the program.</param>
/// <param name="Differs">True if the motions of the two ways differ.</param>
/// <param name="Blocks">Blocks of the program that move in only one of the ways.</param>
/// <param name="Forgotten">Variables that differ where the ways meet.</param>
internal sealed record Fork(
    bool Way, string? Join, bool Differs, IReadOnlyCollection<int> Blocks, IReadOnlyCollection<VariableKey> Forgotten)
{
    /// <summary>A way that is being tried.</summary>
    public static Fork Tried(bool way) => new(way, null, Differs: false, [], []);
}

/// <summary>How much a program may be executed to find out whether both ways of its branches lead to the same. Shared by all runs that
/// try a way.</summary>
/// <param name="blocks">Number of blocks in all.</param>
internal sealed class ForkLimits(long blocks)
{
    /// <summary>Most blocks of one way.</summary>
    public const int Way = 2_000;

    /// <summary>Most branches inside ways of branches.</summary>
    public const int Depth = 3;

    private long _left = blocks;

    /// <summary>Counts a block; false if none is left.</summary>
    public bool TryTake() => _left-- > 0;
}
