namespace ErrorMatching.Nc;

/// <content>Jumps, calls and returns, with their limits.</content>
internal sealed partial class NcFlow
{
    // Goes on at a block of the present program. A jump back that finds the program knowing just what it knew the last time will never end.
    private FlowAction Jump(int from, int target)
    {
        if (target <= from)
        {
            var key = (Unit.Index, from);
            var version = Variables.Version + _changes;
            if (_jumps.TryGetValue(key, out var before) && before == version)
            {
                return Refuse(NcRefusalCodes.EndlessLoop, from, "the loop never ends: nothing that it depends on changes.");
            }

            _jumps[key] = version;
        }

        while (Frame.Regions.TryPeek(out var region) && (target < region.First || target > region.Last))
        {
            Frame.Regions.Pop();
            _changes++;
        }

        return GoTo(from, target);
    }

    private FlowAction GoTo(int from, int target)
    {
        _steps += Math.Max(0, from - _resumed) + 1;
        return Resume(from, target);
    }

    private FlowAction Resume(int from, int target)
    {
        (_resumed, Next) = (target, target);
        if (_steps + (Unit.Index.Searched / SearchedPerStep) > _settings.Steps)
        {
            return Refuse(NcRefusalCodes.EndlessLoop, from, FormattableString.Invariant($"{_settings.Steps} blocks were executed and the program has not ended; the loop here is taken never to end."));
        }

        return _settings.Cancellation.IsCancellationRequested
            ? Refuse(NcRefusalCodes.EndlessLoop, from, "the time for executing the program is used up; the loop here is taken never to end.")
            : FlowAction.Continue;
    }

    private FlowAction Enter(FlowFrame frame)
    {
        if (_frames.Count > _settings.Depth)
        {
            return Refuse(NcRefusalCodes.CallTooDeep, frame.Caller, FormattableString.Invariant($"programs call one another more than {_settings.Depth} deep."));
        }

        var action = GoTo(frame.Caller, frame.First);
        if (action == FlowAction.Continue)
        {
            frame.ModalCalls = frame.IsModalMacro ? frame.ModalCalls : Frame.ModalCalls;
            _frames.Push(frame);
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

        Variables.Enter();
        foreach (var (place, value) in frame.Arguments)
        {
            if (Variables.Write(place, value) is { } error)
            {
                return Refuse(NcRefusalCodes.BadExpression, frame.First, error + ".");
            }
        }

        return frame.Parameters is null ? FlowAction.Continue : Bind(frame.Unit, frame.Parameters, frame.Results);
    }

    // Ends a pass of the present call: the next pass, or behind the caller, or at a block of the calling program.
    private FlowAction Return(int from, long number = -1)
    {
        var frame = Frame;
        var results = frame.Results.Select(r => (r.Outside, Value: Variables.Read(r.Inside, out _))).ToArray();
        if (frame.Arguments is not null)
        {
            Variables.Leave();
        }

        foreach (var (outside, value) in results)
        {
            Variables.Write(outside, value);
        }

        _settings.Returned(_frames.Count - 1);
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
        _steps += Math.Max(0, from - _resumed) + 1;
        _frames.Pop();
        Frame.ModalCalls = frame.IsModalMacro ? Frame.ModalCalls : frame.ModalCalls;
        if (number >= 0)
        {
            target = Unit.Index.FindNumber(Unit, frame.Caller, number);
            if (target < 0)
            {
                return Refuse(NcRefusalCodes.MissingLabel, frame.Caller, FormattableString.Invariant($"the called program returns to block N{number}, which does not exist here."));
            }
        }

        var action = Resume(frame.Caller, target);
        return action == FlowAction.Continue && target == frame.Caller + 1 ? BehindRegion(frame.Caller) : action;
    }

    // A section that a REPEAT statement executes ends behind this block: once more, or on behind the statement.
    private FlowAction BehindRegion(int block)
    {
        if (_frames.Count > 0 && Frame.Regions.TryPeek(out var region) && region.Last == block)
        {
            _changes++;
            if (--region.Passes > 0)
            {
                return GoTo(block, region.First);
            }

            Frame.Regions.Pop();
            return region.Owner == block ? FlowAction.Continue : GoTo(block, region.Owner + 1);
        }

        return FlowAction.Continue;
    }

    private FlowAction JumpToNumber(int block, long number)
    {
        var target = number < 0 ? -1 : Unit.Index.FindNumber(Unit, block, number);
        return target < 0
            ? Refuse(NcRefusalCodes.MissingLabel, block, FormattableString.Invariant($"the jump goes to block N{number}, which does not exist in this program."))
            : Jump(block, target);
    }

    // A whole number that decides how the program goes on; false where there is none, with the refusal.
    private bool TryCount(int block, NcValue value, string what, out long count)
    {
        count = 0;
        if (value.IsUnknown)
        {
            Refuse(NcRefusalCodes.UnknownCondition, block, $"{what} is a value that only the machine knows.");
            return false;
        }

        var whole = Math.Round(value.Number, MidpointRounding.AwayFromZero);
        if (value.Kind == NcValueKind.Text || Math.Abs(whole) > 1e12)
        {
            Refuse(NcRefusalCodes.BadExpression, block, $"{what} is no number that can be used.");
            return false;
        }

        count = (long)whole;
        return true;
    }

    // Whether a condition holds; false where nobody can know, with the refusal.
    private bool TryTruth(int block, ref ExpressionReader reader, NcValue value, out bool truth)
    {
        _hasComputed = true;
        truth = value.Number != 0;
        if (!Check(ref reader, block))
        {
            return false;
        }

        if (value.IsUnknown)
        {
            Refuse(NcRefusalCodes.UnknownCondition, block, "which way the program goes hangs on a value that only the machine knows.");
        }
        else if (value.Kind == NcValueKind.Text)
        {
            Refuse(NcRefusalCodes.BadExpression, block, "a text is neither true nor false.");
        }

        return Refusal is null;
    }

    // The file of a program that is not in this one; null where there is none.
    private FlowIndex? FromLibrary(string name)
    {
        if (!_library.TryGetValue(name, out var index))
        {
            index = _settings.Library(name) is { } program ? new FlowIndex(program, _dialect) : null;
            _library.Add(name, index);
        }

        return index;
    }

    private FlowAction Missing(int block, string name) =>
        Refuse(NcRefusalCodes.MissingProgram, block, $"the program {name} is called, and neither this file nor the folder of the program has it.");
}
