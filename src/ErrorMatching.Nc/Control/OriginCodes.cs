using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Codes that change a layer between programmed and machine coordinates by the axis words of their block: a shift of the origin
/// (G92, G52), a work offset, a tool length, a transformation.</summary>
internal sealed class OriginCodes(NcControl control, Corners corners)
{
    public OffsetCodes Offsets { get; } = new(control);

    public ToolLengthCodes Lengths { get; } = new(control);

    public TransformCodes Transforms { get; } = new(control);

    private OriginShift Shift => control.Layers.Shift;

    /// <summary>Runs the block's code.</summary>
    public void Run()
    {
        if (control.Intent.Code is NcMeaning.SetPosition or NcMeaning.SetOffset or NcMeaning.Rotation or NcMeaning.Scaling
            or NcMeaning.OpaqueTransform or NcMeaning.DatumShift)
        {
            control.Result.DependOnPlace();
        }

        corners.Lose();
        switch (control.Intent.Code)
        {
            case NcMeaning.SetPosition:
                SetPosition();
                Shift.Keep();
                break;
            case NcMeaning.ClearPosition:
                Change(default, AxisSet.None);
                Shift.Keep();
                break;
            case NcMeaning.SuspendPosition:
                Change(default, AxisSet.None);
                break;
            case NcMeaning.RestorePosition:
                Change(Shift.Stored.Vector, Shift.Stored.Unknown);
                break;
            case NcMeaning.LocalShift:
                ShiftLocally();
                Shift.Keep();
                break;
            case NcMeaning.SetOffset:
                Offsets.Write();
                break;
            case NcMeaning.ToolLength:
                Lengths.Set();
                break;
            default:
                Transforms.Begin(control.Intent.Code, control.Intent.Family);
                break;
        }
    }

    // G92: gives the tool's current place the given coordinates.
    private void SetPosition()
    {
        var given = control.Values.GivenAxes();
        if (given == AxisSet.None)
        {
            return;
        }

        var (place, unknown) = control.Layers.Tool();
        var target = control.Values.Given(place, incremental: false);
        Shift.Vector += given.PartOf(place - target);
        Shift.Unknown |= unknown & given;
        Shift.Local = (Shift.Local.Vector - given.PartOf(Shift.Local.Vector), Shift.Local.Unknown & ~given);
        control.Layers.SetTool(target, (unknown & ~given) | control.Values.UnknownWords());
        control.Layers.NextFrame();
    }

    // G52, whose shift is that of G92, too, or one on top.
    private void ShiftLocally()
    {
        var given = control.Values.GivenAxes();
        var isOnly = control.Dialect.Ways.HasOneShift;
        var (was, wasUnknown) = isOnly ? (Shift.Vector, Shift.Unknown) : Shift.Local;
        var by = given.PartOf(was - (control.Values.Given(default(Point3) + was, incremental: false) - default(Point3)));
        var nowUnknown = (wasUnknown & ~given) | control.Values.UnknownWords();
        Shift.Vector -= by;
        Shift.Unknown = isOnly ? nowUnknown : Shift.Unknown | control.Values.UnknownWords();
        Shift.Local = isOnly ? Shift.Local : (was - by, nowUnknown);
        control.Layers.MoveWork(by, (wasUnknown & given) | control.Values.UnknownWords());
        control.Layers.NextFrame();
    }

    // Replaces the whole shift.
    private void Change(Vector3 to, AxisSet unknown)
    {
        var (by, unknownBy) = (Shift.Vector - to, Shift.Unknown | unknown);
        (Shift.Vector, Shift.Unknown) = (to, unknown);
        control.Layers.MoveWork(by, unknownBy);
        control.Layers.NextFrame();
    }
}

/// <summary>The shift of the origin on top of the work offset (G92, G52).</summary>
internal sealed class OriginShift
{
    public Vector3 Vector { get; set; }

    /// <summary>Axes in which it is unknown.</summary>
    public AxisSet Unknown { get; set; }

    /// <summary>The part set by G52.</summary>
    public (Vector3 Vector, AxisSet Unknown) Local { get; set; }

    /// <summary>The shift that G92.3 restores; until the program sets a shift itself, only the machine knows it.</summary>
    public (Vector3 Vector, AxisSet Unknown) Stored { get; private set; } = (Vector3.Zero, AxisSet.All);

    public void Keep() => Stored = (Vector, Unknown);

    public void Forget() => (Unknown, Stored, Local) = (AxisSet.All, (Vector3.Zero, AxisSet.All), (Vector3.Zero, AxisSet.All));
}
