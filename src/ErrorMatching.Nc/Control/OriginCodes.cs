using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Codes that change a layer between programmed and machine coordinates by the axis words of their block.</summary>
internal sealed class OriginCodes(
    BlockIntent intent,
    CoordinateLayers layers,
    RunResult result,
    Corners corners,
    ShiftCodes shifts,
    OffsetCodes offsets,
    ToolLengthCodes lengths,
    TransformCodes transforms)
{
    /// <summary>Runs the block's code.</summary>
    public void Run()
    {
        if (intent.Code is NcMeaning.SetPosition or NcMeaning.SetOffset or NcMeaning.Rotation or NcMeaning.Scaling
            or NcMeaning.OpaqueTransform or NcMeaning.DatumShift)
        {
            result.DependOnPlace();
        }

        corners.Lose();
        switch (intent.Code)
        {
            case NcMeaning.SetPosition:
                shifts.SetPosition();
                layers.Shift.Keep();
                break;
            case NcMeaning.ClearPosition:
                shifts.Change(default, AxisSet.None);
                layers.Shift.Keep();
                break;
            case NcMeaning.SuspendPosition:
                shifts.Change(default, AxisSet.None);
                break;
            case NcMeaning.RestorePosition:
                shifts.Change(layers.Shift.Stored.Vector, layers.Shift.Stored.Unknown);
                break;
            case NcMeaning.LocalShift:
                shifts.ShiftLocally();
                layers.Shift.Keep();
                break;
            case NcMeaning.SetOffset:
                offsets.Write();
                break;
            case NcMeaning.ToolLength:
                lengths.Set();
                break;
            default:
                transforms.Begin(intent.Code, intent.Family);
                break;
        }
    }
}

/// <summary>Codes that shift the origin on top of the work offset (G92, G52).</summary>
internal sealed class ShiftCodes(BlockValues values, CoordinateLayers layers)
{
    /// <summary>G92: gives the tool's current place the given coordinates.</summary>
    public void SetPosition()
    {
        var given = values.GivenAxes();
        if (given == AxisSet.None)
        {
            return;
        }

        var (place, unknown) = layers.Tool();
        var target = values.Given(place, incremental: false);
        layers.Shift.Vector += given.PartOf(place - target);
        layers.Shift.Unknown |= unknown & given;
        layers.Shift.Local = (layers.Shift.Local.Vector - given.PartOf(layers.Shift.Local.Vector), layers.Shift.Local.Unknown & ~given);
        layers.SetTool(target, (unknown & ~given) | values.UnknownWords());
        layers.NextFrame();
    }

    /// <summary>G52. LinuxCNC has one shift for G52 and G92; other controls add that of G52 on top and store it separately.</summary>
    public void ShiftLocally()
    {
        var given = values.GivenAxes();
        var isOnly = values.Dialect.Syntax == NcSyntax.LinuxCnc;
        var (was, wasUnknown) = isOnly ? (layers.Shift.Vector, layers.Shift.Unknown) : layers.Shift.Local;
        var by = given.PartOf(was - (values.Given(default(Point3) + was, incremental: false) - default(Point3)));
        var nowUnknown = (wasUnknown & ~given) | values.UnknownWords();
        layers.Shift.Vector -= by;
        layers.Shift.Unknown = isOnly ? nowUnknown : layers.Shift.Unknown | values.UnknownWords();
        layers.Shift.Local = isOnly ? layers.Shift.Local : (was - by, nowUnknown);
        layers.MoveWork(by, (wasUnknown & given) | values.UnknownWords());
        layers.NextFrame();
    }

    /// <summary>Replaces the whole shift.</summary>
    public void Change(Vector3 to, AxisSet unknown)
    {
        var (by, unknownBy) = (layers.Shift.Vector - to, layers.Shift.Unknown | unknown);
        (layers.Shift.Vector, layers.Shift.Unknown) = (to, unknown);
        layers.MoveWork(by, unknownBy);
        layers.NextFrame();
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
