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
