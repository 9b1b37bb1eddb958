namespace ErrorMatching.Nc;

/// <summary>Determines the next block: jumps, calls and returns, with their limits.</summary>
internal sealed class FlowCourse(NcSyntax syntax, CallStack calls, FlowReport report, FlowMemory memory, ProgramParameters parameters,
    FlowSettings settings)
{
    private const int SearchedPerStep = 8;

    // A block of a program has 20 to 40 bytes. Reading a longer one takes longer.
    private const int BytesPerStep = 64;
    private const int ElementsPerStep = 64;

    private readonly Dictionary<(FlowIndex, int), long> _jumps = [];
    private long _changes;

    // The work done so far, in blocks of usual length, counted where the program does not run straight through: a budget of time that
    // does not depend on the computer.
    private long _steps;
    private int _resumed;

    /// <summary>The next block to execute.</summary>
    public int Next { get; set; }

    /// <summary>True once the program has not run straight through.</summary>
    public bool HasJumped { get; private set; }

    public bool HasEnded { get; private set; }

    /// <summary>The block at which the program began, or continued after its last jump.</summary>
    public int Begun => _resumed;

    /// <summary>Starts at a block: 0, unless an archive begins with a subprogram.</summary>
    public void Begin(int block) => _resumed = block;

    /// <summary>Records a change, other than of variables, that a loop can depend on.</summary>
    public void Change() => _changes++;

    /// <summary>Continues at a block of the current program. Refuses a jump back if no value has changed since the same jump before:
    /// the loop would never end.</summary>
    public FlowAction Jump(int from, int target)
    {
        if (target <= from)
        {
            var key = (calls.Unit.Index, from);
            var version = memory.Variables.Version + _changes;
            if (_jumps.TryGetValue(key, out var before) && before == version)
            {
                return report.Refuse(NcRefusalCodes.EndlessLoop, from, "the loop never ends: nothing that it depends on changes.");
            }

            _jumps[key] = version;
        }

        while (calls.Frame.Regions.TryPeek(out var region) && (target < region.First || target > region.Last))
        {
            calls.Frame.Regions.Pop();
            _changes++;
        }

        return GoTo(from, target);
    }

    /// <summary>Continues at a block of the current program without checking for an endless loop.</summary>
    public FlowAction GoTo(int from, int target)
    {
        HasJumped = true;
        CountTo(from);
        return Resume(from, target);
    }

    /// <summary>Counts work of a block that its length does not show: the elements of an array that it writes.</summary>
    public FlowAction CountElements(int block, int count)
    {
        _steps += count / ElementsPerStep;
        return HasTime(block);
    }

    // The blocks from where the program went on last up to one.
    private void CountTo(int block)
    {
        var program = calls.Program;
        var last = Math.Min(block, program.BlockCount - 1);
        var blocks = Math.Max(0, block - _resumed) + 1;
        _steps += last < _resumed ? blocks : Math.Max(blocks, (program[last].End - program[_resumed].Start) / BytesPerStep);
    }

    private FlowAction Resume(int from, int target)
    {
        (_resumed, Next) = (target, target);
        return HasTime(from);
    }

    private FlowAction HasTime(int from)
    {
        if (_steps + (calls.Unit.Index.Searched / SearchedPerStep) > settings.Steps)
        {
            return report.Refuse(NcRefusalCodes.EndlessLoop, from,
                FormattableString.Invariant(
                    $"the work of {settings.Steps} blocks was done and the program has not ended; the loop here is taken never to end."));
        }

        return settings.Cancellation.IsCancellationRequested
            ? report.Refuse(NcRefusalCodes.EndlessLoop, from,
                "the time for executing the program is used up; the loop here is taken never to end.")
            : FlowAction.Continue;
    }

    /// <summary>Calls a program.</summary>
    public FlowAction Enter(FlowFrame frame)
    {
        if (calls.Frames.Count > settings.Depth)
        {
            return report.Refuse(NcRefusalCodes.CallTooDeep, frame.Caller,
                FormattableString.Invariant($"programs call one another more than {settings.Depth} deep."));
        }

        var action = GoTo(frame.Caller, frame.First);
        if (action == FlowAction.Continue)
        {
            frame.ModalCalls = frame.IsModalMacro ? frame.ModalCalls : calls.Frame.ModalCalls;
            calls.Frames.Push(frame);
            calls.Called.Add(frame.Unit.Name);
            _changes++;
            return BeginPass(frame);
        }

        return action;
    }

    private FlowAction BeginPass(FlowFrame frame)
    {
        if (frame.Arguments is null)
        {
            return FlowAction.Continue;
        }

        memory.Variables.Enter();
        foreach (var (place, value) in frame.Arguments)
        {
            if (memory.Variables.Write(place, value) is { } error)
            {
                return report.Refuse(NcRefusalCodes.BadExpression, frame.First, error + ".");
            }
        }

        return frame.Parameters is null ? FlowAction.Continue : parameters.Bind(frame.Unit, frame.Parameters, frame.Results);
    }

    /// <summary>Ends a pass of the current call. Continues with the next pass, after the caller, or at a block of the calling
    /// program.</summary>
    public FlowAction Return(int from, long number = -1)
    {
        var frame = calls.Frame;
        var results = frame.Results.Select(r => (r.Outside, Value: memory.Variables.Read(r.Inside, out _))).ToArray();
        if (frame.Arguments is not null)
        {
            memory.Variables.Leave(frame.Arguments);
        }

        foreach (var (outside, value) in results)
        {
            memory.Variables.Write(outside, value);
        }

        settings.Returned(calls.Frames.Count - 1);
        _changes++;
        frame.Regions.Clear();
        frame.Counters.Clear();
        if (frame.Passes > 1 && number < 0)
        {
            frame.Passes--;
            var again = GoTo(from, frame.First);
            return again == FlowAction.Continue ? BeginPass(frame) : again;
        }

        var target = frame.Caller + 1;
        CountTo(from);
        calls.Frames.Pop();
        calls.Frame.ModalCalls = frame.IsModalMacro ? calls.Frame.ModalCalls : frame.ModalCalls;
        if (number >= 0)
        {
            target = calls.Unit.Index.FindNumber(calls.Unit, frame.Caller, number);
            if (target < 0)
            {
                return report.Refuse(NcRefusalCodes.MissingLabel, frame.Caller,
                    FormattableString.Invariant($"the called program returns to block N{number}, which does not exist here."));
            }
        }

        var action = Resume(frame.Caller, target);
        return action == FlowAction.Continue && target == frame.Caller + 1 ? BehindRegion(frame.Caller) : action;
    }

    /// <summary>Ends a pass of a section that a REPEAT statement executes: repeats it, or continues after the statement.</summary>
    public FlowAction BehindRegion(int block)
    {
        if (calls.Frames.Count > 0 && calls.Frame.Regions.TryPeek(out var region) && region.Last == block)
        {
            _changes++;
            if (--region.Passes > 0)
            {
                return GoTo(block, region.First);
            }

            calls.Frame.Regions.Pop();
            return region.Owner == block ? FlowAction.Continue : GoTo(block, region.Owner + 1);
        }

        return FlowAction.Continue;
    }

    public FlowAction JumpToNumber(int block, long number)
    {
        var target = number < 0 ? -1 : calls.Unit.Index.FindNumber(calls.Unit, block, number);
        return target < 0
            ? report.Refuse(NcRefusalCodes.MissingLabel, block,
                FormattableString.Invariant($"the jump goes to block N{number}, which does not exist in this program."))
            : Jump(block, target);
    }

    /// <summary>Continues after a file's last block before this one was executed: in the calling program, or the run ends.</summary>
    public FlowAction AtEnd(int block)
    {
        if (calls.Frames.Count <= 1)
        {
            return Ended();
        }

        if (syntax == NcSyntax.Iso)
        {
            report.Note("no-return", Math.Min(block, calls.Program.BlockCount) - 1,
                "The subprogram ends without M99; it is taken to return here.");
        }

        return Return(block - 1);
    }

    /// <summary>Returns, or ends if there is no caller.</summary>
    public FlowAction ReturnOrEnd(int block) => calls.Frames.Count > 1 ? Return(block) : Ended();

    public FlowAction Ended()
    {
        HasEnded = true;
        return FlowAction.Stop;
    }
}
