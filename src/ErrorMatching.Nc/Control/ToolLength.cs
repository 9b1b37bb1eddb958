using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The tool length that the program itself states (G43.1), mm along each axis, and the axes along which the machine's table gives
/// one.</summary>
internal sealed class ToolLength
{
    private bool _isInInches;

    public Vector3 Vector { get; private set; }

    /// <summary>Axes with a tool length that the program states.</summary>
    public AxisSet Axes => Vector.Axes();

    /// <summary>Axes with a length from the table, as long as one is active.</summary>
    public AxisSet FromTable { get; set; }

    /// <summary>True if something unseen could have activated another one.</summary>
    public bool IsUnsure { get; set; }

    /// <summary>Axes with an unknown tool length: only the machine knows a length from the tool table. A length stated in other units is
    /// unknown too: LinuxCNC 2.9 keeps its number (measured with rs274).</summary>
    public AxisSet UnknownIn(in ModalState state) => (state.LengthOffset ? FromTable : AxisSet.None)
        | (IsUnsure ? AxisSet.Z : AxisSet.None)
        | (_isInInches != state.Inch ? Axes : AxisSet.None);

    public void Change(Vector3 to, bool inInches) => (Vector, _isInInches) = (to, inInches);
}

/// <summary>Codes that state a tool length, take it from the table, or end it (G43.1, G43, G49).</summary>
internal sealed class ToolLengthCodes(NcControl control)
{
    /// <summary>True if a length is active, stated or from the table.</summary>
    public bool IsActive => control.State.LengthOffset || Length.Axes != AxisSet.None;

    private ToolLength Length => control.Layers.Length;

    private AxisSet Unknown => Length.UnknownIn(control.State);

    /// <summary>G43.1: from here on, the tip is shifted by the block's length. A previous length from the table is unknown.</summary>
    public void Set()
    {
        var given = control.Values.GivenAxes();
        var length = control.Values.Given(default(Point3) + Length.Vector, incremental: false) - default(Point3);
        Change(length, (Unknown & (given | Length.Axes)) | control.Values.UnknownWords());
        Length.FromTable &= ~given;
        control.State.LengthOffset &= Length.FromTable != AxisSet.None;
        Length.IsUnsure &= (given & AxisSet.Z) == AxisSet.None;
    }

    /// <summary>G43: a length that only the machine knows, so that the tip's place is unknown along the tool. Some controls move the
    /// length in this block, some with the next motion; the others give the place another coordinate.</summary>
    public void TakeFromTable()
    {
        // Along Z, or along the third axis of the plane: controls differ.
        var along = AxisSet.Z | (AxisSet.All & ~control.State.Plane.Axes());
        Change(Vector3.Zero, Length.Axes | along | Unknown);
        (Length.FromTable, Length.IsUnsure, control.State.LengthOffset) = (Length.FromTable | along, false, true);
    }

    /// <summary>G49.</summary>
    public void End()
    {
        Change(Vector3.Zero, Unknown);
        (Length.FromTable, Length.IsUnsure, control.State.LengthOffset) = (AxisSet.None, false, false);
    }

    /// <summary>Another number of a length changes the active one.</summary>
    public void ChangeNumber()
    {
        if (Unknown != AxisSet.None)
        {
            TakeFromTable();
        }
    }

    /// <summary>Restores an active length or ends it.</summary>
    public void Restore(bool on)
    {
        if (on)
        {
            TakeFromTable();
        }
        else
        {
            End();
        }
    }

    private void Change(Vector3 to, AxisSet unknown)
    {
        if (to == Length.Vector && unknown == AxisSet.None)
        {
            return;
        }

        var by = Length.Vector - to;
        Length.Change(to, control.State.Inch);
        var degrees = control.Layers.Offsets.Origin.Degrees;
        control.Layers.MoveWork(WorkOrigin.Turned(by, -(degrees ?? 0)), degrees is null && (by.X != 0 || by.Y != 0)
            ? unknown | AxisSet.X | AxisSet.Y : degrees == 0 ? unknown : WorkOrigin.Mixed(unknown));
        control.Layers.NextFrame();
    }
}
