namespace ErrorMatching.Nc;

/// <summary>Programs that are called after every motion (Fanuc G66, Okuma MODIN), innermost last.</summary>
internal sealed class ModalCalls(CallStack calls, FlowReport report, FlowCourse course, FlowSettings settings)
{
    private readonly List<ModalCall> _calls = [];

    /// <summary>True while a program is called after every motion.</summary>
    public bool AreActive => calls.Frames.Count > 0 && Math.Min(calls.Frame.ModalCalls, _calls.Count) > 0;

    /// <summary>Calls a program after every motion from here on.</summary>
    public FlowAction Begin(
        int block, FlowUnit unit, long passes, IReadOnlyList<(VariablePlace Place, NcValue Value)> arguments)
    {
        _calls.Add(new(unit, passes, arguments));
        calls.Frame.ModalCalls = _calls.Count;
        course.Change();
        return _calls.Count > settings.Depth ? report.Refuse(NcRefusalCodes.CallTooDeep, block, "too many modal calls are active.")
            : FlowAction.Continue;
    }

    /// <summary>Ends the innermost one.</summary>
    public FlowAction End()
    {
        if (_calls.Count > 0)
        {
            _calls.RemoveAt(_calls.Count - 1);
            course.Change();
        }

        calls.Frame.ModalCalls = Math.Min(calls.Frame.ModalCalls, _calls.Count);
        return FlowAction.Continue;
    }

    /// <summary>Calls the innermost one, after a block that moved.</summary>
    public FlowAction Call(int block)
    {
        var level = Math.Min(calls.Frame.ModalCalls, _calls.Count) - 1;
        var call = _calls[level];
        return course.Enter(new()
        {
            Unit = call.Unit,
            First = call.Unit.First,
            Caller = block,
            Passes = call.Passes,
            Arguments = call.Arguments,
            IsModalMacro = true,
            ModalCalls = level,
        });
    }

    /// <summary>A program that is called after every motion.</summary>
    /// <param name="Unit">The program.</param>
    /// <param name="Passes">Number of passes per call.</param>
    /// <param name="Arguments">Values of its local variables in each call.</param>
    private sealed record ModalCall(FlowUnit Unit, long Passes, IReadOnlyList<(VariablePlace Place, NcValue Value)> Arguments);
}
