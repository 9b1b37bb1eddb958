namespace ErrorMatching.Nc;

/// <summary>Reads a program as its control would and returns the motions. Anything that it does not understand makes the state unknown
/// until the program states it again, so it never guesses silently.</summary>
/// <remarks>
/// It decides which block runs next. A block of plain words runs at once (<see cref="BlockExecutor"/>). A block that computes, branches,
/// calls or ends goes to <see cref="NcFlow"/> before and after its words.
/// </remarks>
public sealed class NcInterpreter
{
    /// <summary>Number of blocks between checks whether to stop running ahead.</summary>
    private const int Watch = 1_024;

    private readonly NcControl _control;
    private readonly ProgramRun _run;
    private readonly RunResult _result;
    private readonly BlockExecutor _executor;
    private readonly RunBorders _borders;
    private readonly SecondCore _second;
    private readonly Forks _forks;

    internal NcInterpreter(NcProgram program, NcDialect dialect, NcMotions motions, Func<string, NcProgram?>? library,
        CancellationToken cancellation, Forks.Trial? trial = null)
    {
        _control = new(program, dialect, motions, library, cancellation);
        (_run, _result) = (_control.Run, _control.Result);
        _executor = new(_control);
        _borders = new(_control, _executor);
        _second = new(program, dialect);
        _forks = new(_control, _executor, trial);
    }

    internal ref readonly ModalState State => ref _control.State;

    internal int At => _run.At;

    internal NcMotions Motions => _result.Motions;

    internal RunBorders Borders => _borders;

    internal bool HasReports => _result.Problems.Count > 0 || _result.Notes.Count > 0;

    /// <summary>Interprets a program without a library of other programs.</summary>
    /// <param name="program">The program; it is read in the dialect's syntax.</param>
    /// <param name="dialect">The dialect of its control.</param>
    public static NcPath Run(NcProgram program, NcDialect dialect) => Run(program, dialect, null, CancellationToken.None);

    /// <summary>Interprets a program.</summary>
    /// <param name="program">The program; it is read in the dialect's syntax.</param>
    /// <param name="dialect">The dialect of its control.</param>
    /// <param name="library">Returns a called program that is not in the file by its name (<c>O1002</c>, <c>L10</c>, <c>POCKET</c>), or
    /// null if there is none. If the function itself is null, no other program is known.</param>
    /// <param name="cancellation">Stops a long run.</param>
    /// <exception cref="OperationCanceledException">The run was canceled.</exception>
    public static NcPath Run(NcProgram program, NcDialect dialect, Func<string, NcProgram?>? library, CancellationToken cancellation) =>
        new NcInterpreter(program.In(dialect.Syntax), dialect, new(), library, cancellation).Run();

    /// <summary>Interprets a program that is similar to one already interpreted, in the same dialect and with the same library. Equal
    /// motions share memory, and stretches with equal bytes take little time.</summary>
    /// <param name="program">The program.</param>
    /// <param name="like">The similar program, interpreted.</param>
    public static NcPath Run(NcProgram program, NcPath like)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(like);
        program = program.In(like.Dialect.Syntax);
        var isSame = RunBorders.SameStretches(program, like);

        // If less than half of a long program is equal, two threads are faster.
        var passes = program.BlockCount < SecondCore.Many || isSame.Count(s => s) > isSame.Length / 2;
        var interpreter = new NcInterpreter(program, like.Dialect, new(like.Motions, inPlace: passes), like.Library,
            CancellationToken.None);
        interpreter._borders.Expect(passes ? like.Borders : [], isSame);
        return interpreter.Run();
    }

    /// <summary>Runs blocks from a given state until one that could do more than move; that one does not run.</summary>
    internal void RunCuts(in ModalState state, int from, int end)
    {
        (_control.State, _run.At) = (state, from);
        _borders.BeginAt(from);
        for (; _run.At < end; _run.At++)
        {
            var at = _result.Block = _run.At;
            if ((at & (RunBorders.Stretch - 1)) == 0)
            {
                _borders.Note();
            }

            if (((at & (Watch - 1)) == 0 && _run.Cancellation.IsCancellationRequested)
                || !_executor.TryReadPlain(_run.Program.BytesOf(_run.Program[at])))
            {
                return;
            }

            if (_executor.TryRunStraight())
            {
                continue;
            }

            if (!_executor.IsCut())
            {
                return;
            }

            _executor.Step();
        }
    }

    /// <summary>Executes a program from its beginning along one way of a branch, until it meets the other one or cannot.</summary>
    internal static (WayTrace? Trace, string? Meeting) Try(NcControl control, Forks.Trial trial)
    {
        var run = control.Run;
        var other = new NcInterpreter(run.Program, control.Dialect, new(), run.Library, run.Cancellation, trial);
        other.Begin();
        while (!other._run.HasEnded && !other._run.Cancellation.IsCancellationRequested && other._forks.Arrive())
        {
            if (!other.RunNext())
            {
                other._run.HasEnded = true;
            }
        }

        if (other._forks.Trace is not { } trace || other._run.Refusal is not null)
        {
            return default;
        }

        trace.Ends = other._run.HasEnded && trace.Meets is null;
        return (trace, trace.Meets is null ? null : other._forks.Place());
    }

    private void Begin()
    {
        var bytes = _run.Program.Bytes.Span[SyntaxBytes.MarkLength(_run.Program.Bytes.Span)..];
        _run.At = _control.Dialect.Syntax == NcSyntax.Siemens && bytes is [(byte)'%', ..] ? _run.Flow.First : BehindLeader();
    }

    // Executes the next block; false behind the last one of the program.
    private bool RunNext()
    {
        var (text, at) = (_run.Text, _run.At);
        if (at < text.BlockCount)
        {
            RunBlock(text, at);
        }
        else if (!_run.IsInProgram)
        {
            _run.Follow(_run.Flow.AtEnd());
        }
        else
        {
            return false;
        }

        return true;
    }

    private NcPath Run()
    {
        var program = _run.Program;
        Begin();
        using var ahead = new CancellationTokenSource();
        while (!_run.HasEnded)
        {
            if (_forks.AreOpen)
            {
                _forks.Arrive();
            }

            if ((_run.At & (RunBorders.Stretch - 1)) == 0 && _run.IsInProgram && !_forks.AreOpen && CrossBorder(ahead.Token))
            {
                continue;
            }

            if (!RunNext())
            {
                break;
            }
        }

        ahead.Cancel();
        _run.Cancellation.ThrowIfCancellationRequested();
        var assumed = NoteAssumed();
        NoteProgramsBehind();
        NcNote[] notes = [.. _result.Notes.Concat(_run.FlowNotes).Concat(_executor.Integers.Notes()).OrderBy(n => n.Block)];
        return new(program, _control.Dialect, Motions, _result.Problems, _result.PlaceDependents, _control.Layers.Frames, notes,
            _run.Refusal, _run.Library)
        {
            Borders = _borders.Borders,
            ToolChanges = _result.ToolChanges,
            CalledPrograms = _run.CalledPrograms,
            Poles = _result.Poles,
            CompensationSwitches = _result.CompensationSwitches,
            UncertainBlocks = _forks.Blocks,
            Assumed = assumed,
        };
    }

    // A file may have several programs. The first of them runs, with those that it calls.
    private void NoteProgramsBehind()
    {
        if (!_run.HasEnded || _run.Refusal is not null || !_run.IsInProgram)
        {
            return;
        }

        var program = _run.Program;
        var called = _run.HasFlow ? _run.Flow.Called : new HashSet<string>();
        for (var block = Math.Max(0, _run.At - 1); block < program.BlockCount; block++)
        {
            var text = program.BytesOf(program[block]);
            var head = BlockHead.Read(text, program.Syntax);
            if (head.At < text.Length && FlowIndex.HeadingOf(text, head.At, program.Syntax) is { Length: > 0 } name
                && !called.Contains(name))
            {
                _result.Block = block;
                _result.Note("programs-follow",
                    $"Behind the end of the program, others follow in the file ({name} the first), which this one "
                    + "does not call: they are not run, and what is said here is not about them.");
            }
        }
    }

    // What was assumed, as far as the program reads it.
    private string NoteAssumed()
    {
        var assumed = _control.Dialect.Assumed;
        if (assumed.Count == 0)
        {
            return "";
        }

        var used = _run.HasFlow ? _run.Flow.Variables.Used : new HashSet<string>();
        _result.Block = 0;
        if (used.Count > 0)
        {
            _result.Note("assumed", $"Assumed, since it was stated: {assumed.Listed(used)}. The result holds for these values only.");
        }

        if (assumed.Values.Keys.Where(n => !used.Contains(n)).ToArray() is { Length: > 0 } unused)
        {
            _result.Note("assumed-unused", $"Stated, but the program does not read it, or sets it itself: {assumed.Listed(unused)}.");
        }

        return assumed.Listed(used);
    }

    private int BehindLeader()
    {
        var leader = Leader.BlocksOf(_run.Program, _control.Dialect);
        if (leader > 0)
        {
            _result.Note("leader", "What stands before the first percent sign is a leader, which the control does not read.");
        }

        return leader;
    }

    // Reaches a border in the program itself. True if the run continues elsewhere.
    private bool CrossBorder(CancellationToken endOfAhead)
    {
        if (_borders.AreKnown)
        {
            return _borders.TryPass();
        }

        _borders.Note();
        if (_run.At == SecondCore.LeadIn && _run.Program.BlockCount >= SecondCore.Many && _executor.IsStraight())
        {
            _second.Start(_control.State, Motions, endOfAhead);
        }

        return _run.At == _second.Seam && TryJoinAhead();
    }

    // Continues where the second thread stopped, if it began in the state in which the program actually reaches the seam.
    private bool TryJoinAhead()
    {
        if (_second.Meet(_borders, Motions) is not { } ahead)
        {
            return false;
        }

        var before = Motions.Length;
        Motions.Join(ahead.Motions);
        _borders.Join(ahead._borders, before, ahead.Motions);
        (_control.State, _run.At) = (ahead.State, ahead.At);
        _executor.Integers.Join(ahead._executor.Integers);
        return true;
    }

    private void RunBlock(NcProgram text, int at)
    {
        var (block, executor) = (text[at], _executor);
        if (ReferenceEquals(text, _run.Program))
        {
            _result.Block = at;
        }

        if (!executor.TryReadPlain(text.BytesOf(block)))
        {
            RunAny(block);
            return;
        }

        if (executor.TryRunStraight())
        {
            _run.At = at + 1;
            return;
        }

        _borders.OnlyCuts &= executor.IsCut();
        if (executor.Steering.ConcernsFlow())
        {
            RunAny(block);
            return;
        }

        _executor.Step();
        GoOn();
    }

    private void RunAny(NcBlock block)
    {
        _borders.OnlyCuts = false;
        if (_executor.Steering.RunSystemCommand(block))
        {
            _executor.HasOnlyModes = false;
            return;
        }

        if (_executor.Steering.PassesSkip(block))
        {
            return;
        }

        _executor.Refusals.ReadSpelling(_run.Text.BytesOf(block));
        if (FlowTrigger.Concerns(_run.Text.BytesOf(block), _control.Dialect) && _executor.Steering.HasStatements(block))
        {
            RunWithFlow(block);
            return;
        }

        _control.Values.Read(block);
        if (_executor.Steering.ConcernsFlow())
        {
            RunWithFlow(block);
            return;
        }

        _executor.Step();
        GoOn();
    }

    private void RunWithFlow(NcBlock block)
    {
        if (_executor.Steering.RefusesSemicolon(block))
        {
            return;
        }

        var flow = _run.Flow;
        var writes = flow.Variables.MachineWrites;
        var action = flow.ExecuteStatements(_run.At);
        if (action == FlowAction.Words)
        {
            _control.Values.Read(block, flow.WordsFrom);
            if (flow.Refusal is null)
            {
                _executor.Step(flow.WordsFrom > 0 ? MotionFlags.Conditional : MotionFlags.None);
                if (_executor.Steering.CallMachineProgram())
                {
                    _result.DependOnPlace();
                    _executor.HasOnlyModes = false;
                    _control.Layers.Forget();
                    _run.ForgetMachine();
                    _run.At++;
                    return;
                }
            }

            action = flow.ExecuteCalls(_run.At, _executor.Moved);
            if (action == FlowAction.Continue && _executor.Steering.HasSteeringWords() && !flow.HasSteered)
            {
                action = flow.RefuseCall(_run.At, "A word of this block");
            }
        }

        if (flow.Variables.MachineWrites != writes)
        {
            _control.Layers.LoseOrigin();
        }

        var file = _run.Text;
        _run.Follow(action);
        if (!ReferenceEquals(_run.Text, file))
        {
            _executor.Compensation.ChangeFile();
        }
    }

    private void GoOn()
    {
        if (_run.HasModalCall && _executor.Moved)
        {
            _run.Follow(_run.Flow.ExecuteCalls(_run.At, moved: true));
            return;
        }

        _run.At++;
    }
}
