namespace ErrorMatching.Nc;

/// <summary>
/// The second core begins in the middle of a long program, with the modes that its first blocks set and the place that the blocks before
/// the middle lead to. That is a guess: when the
/// first core arrives there and its state is another one, to the last bit, what ran ahead counts for nothing. So the result is that of one
/// core.
/// </summary>
internal sealed class SecondCore(NcProgram program, NcDialect dialect)
{
    /// <summary>From so many blocks on, it is worth its start.</summary>
    public const int Many = 100_000;

    /// <summary>So many first blocks set the modes, and so many blocks lead to the middle.</summary>
    public const int LeadIn = 16 * RunBorders.Stretch;

    private Task<RunAhead?>? _ahead;

    // A class: tasks of our own structs are not compiled before they run.
    private sealed record RunAhead(NcInterpreter Run, ModalState Began);

    /// <summary>The block at which it began, until the first core has come there.</summary>
    public int Seam { get; private set; } = int.MaxValue;

    /// <summary>Starts it with the modes of the first core, behind its motions.</summary>
    public void Start(ModalState state, NcMotions motions, CancellationToken end)
    {
        if (_ahead is null)
        {
            var seam = program.BlockCount / 2 / RunBorders.Stretch * RunBorders.Stretch;
            Seam = seam;
            _ahead = Task.Run(() => Ahead(state, motions, seam, end), CancellationToken.None);
        }
    }

    /// <summary>Ends the wait for the first core, which has come to the seam.</summary>
    /// <returns>What ran ahead, if it is there and began as the first core stands now, where these motions end; else null.</returns>
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

    // The rest of the program from the seam on, as far as it has cuts and rapids only; null where something else leads to the seam.
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

        // A problem would have to be told in its order, and only once; there should be none.
        return ahead.HasProblems ? null : new(ahead, before.State);
    }
}
