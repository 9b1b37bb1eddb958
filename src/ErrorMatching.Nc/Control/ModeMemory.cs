namespace ErrorMatching.Nc;

/// <summary>Modes that a program saves and restores (LinuxCNC M70 to M73), separately per call level. As in rs274, modes that differ are
/// set again. The motion mode, the shift of G92 and the value of a tool length are not saved; an active length is restored from the
/// table.</summary>
internal sealed class ModeMemory(NcControl control, OriginCodes origins)
{
    private readonly Dictionary<int, SavedModes> _saved = [];

    /// <summary>True if modes are saved at some level of calls.</summary>
    public bool HasSaved => _saved.Count > 0;

    /// <summary>The function of the block that saves or restores modes; harmless if there is none.</summary>
    public FunctionRole RoleOfBlock()
    {
        foreach (var function in control.Words.Functions)
        {
            var role = control.Dialect.FunctionOf(function);
            if (role is FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes)
            {
                return role;
            }
        }

        return FunctionRole.Harmless;
    }

    /// <summary>The active modes.</summary>
    public SavedModes Now(bool atReturn) =>
        new(control.State, control.Layers.Offsets.Chosen, control.Layers.Offsets.IsUnsure, origins.Lengths.IsActive,
            control.Layers.Transforms.OpaqueFamilies, atReturn);

    /// <summary>Saves modes. Only feed and its mode apply before that; the other codes of the block come after it.</summary>
    public void Save(SavedModes before)
    {
        var state = before.State;
        (state.Feed, state.InverseTime) = (control.State.Feed, control.State.InverseTime);

        // Measured with rs274: M70 after M73 changes what is restored at the end, not that it is restored.
        var atReturn = before.AtReturn || (_saved.TryGetValue(control.Run.CallDepth, out var saved) && saved.AtReturn);
        _saved[control.Run.CallDepth] = before with { State = state, AtReturn = atReturn };
    }

    /// <summary>Discards the saved modes of this level, if a function of the block says so.</summary>
    public void Drop()
    {
        foreach (var function in control.Words.Functions)
        {
            if (control.Dialect.FunctionOf(function) == FunctionRole.DropModes)
            {
                _saved.Remove(control.Run.CallDepth);
            }
        }
    }

    /// <summary>Restores the saved modes of this level.</summary>
    public MotionFlags Restore()
    {
        if (!_saved.TryGetValue(control.Run.CallDepth, out var saved))
        {
            control.Layers.Forget();
            return control.Result.Problem(
                "no-saved-modes",
                "No modes are saved at this level of calls that could be restored: the control stops here.",
                MotionFlags.UnknownWord);
        }

        Take(saved);
        if (control.Words.Functions.Length == 1 && control.Words.Codes.Length == 0
            && ((control.Words.Present | control.Words.Computed) & ~BlockWords.Bit('N')) == 0)
        {
            return MotionFlags.None;
        }

        // Measured with rs274: if a mode is restored, the rest of the block is lost.
        control.Layers.Forget();
        return control.Result.Problem(
            "words-beside-restore",
            "Words stand in the block that restores modes; the control can lose them. Write them in a block of their own.",
            MotionFlags.UnknownWord);
    }

    /// <summary>Handles the end of a pass of a call.</summary>
    public void Return(int depth)
    {
        if (_saved.Remove(depth, out var saved) && saved.AtReturn)
        {
            Take(saved);
        }
    }

    private void Take(SavedModes saved)
    {
        // If something ran unseen, it is unknown whether a length or an offset is restored.
        var isSure = control.State.Unsure == Unsure.None && saved.State.Unsure == Unsure.None && !control.Layers.Offsets.IsUnsure
            && !saved.IsWorkOffsetUnsure;
        var modes = saved.State;
        (control.State.Inch, control.State.InchFeed, control.State.Feed, control.State.InverseTime) =
            (modes.Inch, modes.InchFeed, modes.Feed, modes.InverseTime);
        (control.State.AbsoluteCenters, control.State.RetractsToR) = (modes.AbsoluteCenters, modes.RetractsToR);
        control.Plane(modes.Plane);
        (control.State.WorksInXY, control.State.IsPlaneNew) = (modes.WorksInXY, modes.IsPlaneNew);
        control.Distance(modes.Incremental);
        control.Compensate(modes.Compensation);
        if (origins.Lengths.IsActive != saved.HasLength)
        {
            origins.Lengths.Restore(saved.HasLength);
        }

        origins.Transforms.RestoreOpaque(saved.OpaqueFamilies);
        origins.Offsets.Choose(saved.WorkOffset, isKnown: true);
        control.Layers.Offsets.IsUnsure |= saved.IsWorkOffsetUnsure;
        control.State.Unsure |= modes.Unsure & ~Unsure.Mode;
        var motion = control.Dialect.Refusals.Motion;
        control.State.InForce = (modes.InForce & ~motion) | (control.State.InForce & motion);
        control.State.Unknown = isSure ? control.State.Unknown : AxisSet.All;
    }
}

/// <summary>The modes of a call level as saved by M70 or M73.</summary>
/// <param name="State">Modes and feed, without the tool's place.</param>
/// <param name="WorkOffset">The selected work offset.</param>
/// <param name="IsWorkOffsetUnsure">True if something unseen could have selected another one.</param>
/// <param name="HasLength">True if a tool length was active.</param>
/// <param name="OpaqueFamilies">Active transformations that are not followed.</param>
/// <param name="AtReturn">True if they are restored when the call ends.</param>
internal readonly record struct SavedModes(
    ModalState State, (int Code, int Number) WorkOffset, bool IsWorkOffsetUnsure, bool HasLength, ulong OpaqueFamilies, bool AtReturn);
