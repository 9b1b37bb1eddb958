namespace ErrorMatching.Nc;

/// <summary>A second thread starts in the middle of a long program, with the modes that its first blocks set and the place to which the
/// blocks before the middle lead. That is a guess. If the first thread reaches the middle in a state that is not bitwise equal, the run
/// ahead is discarded. So the result is that of one thread.</summary>
internal sealed class SecondCore(NcProgram program, NcDialect dialect)
{
    /// <summary>Minimum number of blocks for a second thread to pay off.</summary>
    public const int Many = 100_000;

    /// <summary>Number of first blocks that set the modes, and of blocks that lead to the middle.</summary>
    public const int LeadIn = 16 * RunBorders.Stretch;

    private Task<RunAhead?>? _ahead;

    // A class, because tasks of our own structs are not compiled ahead of time.
    private sealed record RunAhead(NcInterpreter Run, ModalState Began);

    /// <summary>The block at which it began, until the first thread reaches it.</summary>
    public int Seam { get; private set; } = int.MaxValue;

    /// <summary>Starts it with the modes of the first thread, after its motions.</summary>
    public void Start(ModalState state, NcMotions motions, CancellationToken end)
    {
        if (_ahead is null)
        {
            var seam = program.BlockCount / 2 / RunBorders.Stretch * RunBorders.Stretch;
            Seam = seam;
            _ahead = Task.Run(() => Ahead(state, motions, seam, end), CancellationToken.None);
        }
    }

    /// <summary>Waits for the run ahead, once the first thread has reached the seam.</summary>
    /// <returns>The run ahead; null if it has not started, failed, or did not begin in the first thread's current state.</returns>
    public NcInterpreter? Meet(RunBorders borders, NcMotions motions)
    {
        Seam = int.MaxValue;
        if (_ahead is not { Status: >= TaskStatus.Running })
        {
            return null;
        }

        return _ahead.GetAwaiter().GetResult() is var (run, began) && borders.StandsAs(began) && motions.EndsWhereBegins(run.Motions) ? run
            : null;
    }

    // The rest of the program from the seam on, while it has only cuts and rapids; null if something else leads to the seam.
    private RunAhead? Ahead(ModalState state, NcMotions motions, int seam, CancellationToken end)
    {
        var before = new NcInterpreter(program, dialect, new(), null, end);
        before.RunCuts(state, seam - LeadIn, seam);
        if (before.At < seam || before.Motions.Length == 0)
        {
            return null;
        }

        var ahead = new NcInterpreter(program, dialect, motions.Ahead(before.Motions), null, end);
        ahead.RunCuts(before.State, seam, program.BlockCount);

        // A problem or note would have to be reported in order and only once; there should be none.
        return ahead.HasReports ? null : new(ahead, before.State);
    }
}
