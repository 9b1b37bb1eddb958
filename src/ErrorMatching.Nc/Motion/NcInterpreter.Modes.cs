namespace ErrorMatching.Nc;

/// <content>
/// Modes that a program saves and restores (LinuxCNC M70 to M73), each call level for itself. As rs274 does it: what differs is stated
/// again. The motion mode, the shift of G92 and the value of a
/// tool length are not among them; a length that was in force comes back from the table.
/// </content>
public sealed partial class NcInterpreter
{
    private readonly Dictionary<int, SavedModes> _savedModes = [];

    private int CallDepth => _flow?.Depth ?? 0;

    // The function of the block that saves or restores modes; harmless where it has none.
    private FunctionRole ModesRole()
    {
        foreach (var function in _words.Functions)
        {
            var role = _dialect.FunctionOf(function);
            if (role is FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes)
            {
                return role;
            }
        }

        return FunctionRole.Harmless;
    }

    private SavedModes Modes(bool atReturn) => new(_state, _workOffset, _isWorkOffsetUnsure, HasLength, _opaqueFamilies, atReturn);

    private bool HasLength => _state.LengthOffset || AxesAlong(_toolLength) != AxisSet.None;

    // Only feed and its mode are acted on before modes are saved; the other codes of the block come behind.
    private void SaveModes(SavedModes before)
    {
        var state = before.State;
        (state.Feed, state.InverseTime) = (_state.Feed, _state.InverseTime);

        // Measured with rs274: M70 behind M73 changes what is restored at the end, not that it is.
        var atReturn = before.AtReturn || (_savedModes.TryGetValue(CallDepth, out var saved) && saved.AtReturn);
        _savedModes[CallDepth] = before with { State = state, AtReturn = atReturn };
    }

    private MotionFlags RestoreModes()
    {
        if (!_savedModes.TryGetValue(CallDepth, out var saved))
        {
            Forget();
            return Problem(
                "no-saved-modes",
                "No modes are saved at this level of calls that could be restored: the control stops here.",
                MotionFlags.UnknownWord);
        }

        Restore(saved);
        if (_words.Functions.Length == 1 && _words.Codes.Length == 0 && ((_words.Present | _words.Computed) & ~BlockWords.Bit('N')) == 0)
        {
            return MotionFlags.None;
        }

        // Measured with rs274: where a mode is restored, the rest of the block is lost.
        Forget();
        return Problem(
            "words-beside-restore",
            "Words stand in the block that restores modes; the control can lose them. Write them in a block of their own.",
            MotionFlags.UnknownWord);
    }

    private void ReturnModes(int depth)
    {
        if (_savedModes.Remove(depth, out var saved) && saved.AtReturn)
        {
            Restore(saved);
        }
    }

    private void Restore(SavedModes saved)
    {
        // Whether a length or an offset is restored is not known where something ran unseen.
        var isSure = _state.Unsure == Unsure.None && saved.State.Unsure == Unsure.None && !_isWorkOffsetUnsure && !saved.IsWorkOffsetUnsure;
        var modes = saved.State;
        (_state.Inch, _state.InchFeed, _state.Feed, _state.InverseTime) = (modes.Inch, modes.InchFeed, modes.Feed, modes.InverseTime);
        (_state.AbsoluteCenters, _state.RetractsToR) = (modes.AbsoluteCenters, modes.RetractsToR);
        Plane(modes.Plane);
        Distance(modes.Incremental);
        Compensate(modes.Compensation);
        if (HasLength != saved.HasLength)
        {
            ChangeLength(saved.HasLength);
        }

        RestoreOpaque(saved.OpaqueFamilies);
        ChooseWorkOffset(saved.WorkOffset, isKnown: true);
        _isWorkOffsetUnsure |= saved.IsWorkOffsetUnsure;
        _state.Unsure |= modes.Unsure & ~Unsure.Mode;
        _state.Unknown = isSure ? _state.Unknown : AxisSet.All;
    }

    private void ChangeLength(bool on)
    {
        if (on)
        {
            TakeLengthOfTable();
        }
        else
        {
            EndToolLength();
        }
    }

    private void RestoreOpaque(ulong families)
    {
        if (families == _opaqueFamilies)
        {
            return;
        }

        var (place, _) = Work(_state.Position, _state.Unknown);
        _opaqueFamilies = families;
        Switch(Transforms.Opaque, families != 0);
        Recompose((place, AxisSet.All));
    }
}
