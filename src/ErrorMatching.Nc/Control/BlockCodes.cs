using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Applies the G codes and M functions of a block to the modes.</summary>
internal sealed class BlockCodes(
    ControlState control,
    BlockValues values,
    ProgramRun run,
    CoordinateLayers layers,
    RunResult result,
    BlockIntent intent,
    OffsetCodes offsets,
    ToolLengthCodes lengths,
    TransformCodes transforms,
    MachineMoves machine,
    CannedCycles canned,
    ModeMemory memory,
    CompensationWords switches)
{
    /// <summary>The M function of a tool change.</summary>
    public const int ToolChange = 6;

    public MotionFlags ReadCodes()
    {
        var flags = MotionFlags.None;
        switches.ReadOffset();
        ReadLength();
        foreach (var tenths in values.Words.Codes)
        {
            var meaning = values.Dialect.MeaningOf(tenths);
            switches.StopAt(tenths);
            switch (meaning)
            {
                case NcMeaning.Unknown:
                    var code = (tenths / 10m).ToString(CultureInfo.InvariantCulture);
                    flags |= result.Problem(
                        "unknown-code", $"G{code} is not known to the dialect {values.Dialect.Name}.", MotionFlags.UnknownWord);
                    layers.Forget();
                    intent.HasUnknownCode = true;
                    break;
                case NcMeaning.WorkOffset:
                    var letter = values.Dialect.WorkOffsetLetter;
                    var number = values.Words.Has(letter) ? (int)Math.Clamp(values.Words.Value(letter), 0, 1000) : 0;
                    offsets.Choose((tenths, number), (values.Words.Unknown & BlockWords.Bit(letter)) == 0);
                    break;
                case NcMeaning.Inch or NcMeaning.Metric:
                    control.Units(meaning == NcMeaning.Inch, values.Dialect.ScalesFeed(tenths));
                    break;
                case var _ when meaning.Steers():
                    // The flow executes it after the words; axis words are arguments.
                    intent.Use = AxisUse.Nothing;
                    break;
                case NcMeaning.ReferenceReturn or NcMeaning.StoreReference:
                    intent.Reference = tenths / 10;
                    Apply(meaning, 0);
                    break;
                default:
                    Apply(meaning, values.Dialect.FamilyOf(tenths));
                    break;
            }
        }

        return flags;
    }

    // What is passed to a called program is not of this kind.
    private void ReadLength()
    {
        foreach (var function in values.Words.Functions)
        {
            if (values.Dialect.FunctionOf(function).Steers())
            {
                return;
            }
        }

        foreach (var code in values.Words.Codes)
        {
            if (values.Dialect.MeaningOf(code).Steers())
            {
                return;
            }
        }

        var given = values.Words.Present | values.Words.Computed;
        if ((given & values.Lengths) != 0)
        {
            lengths.TakeFromTable();
        }
        else if ((given & values.LengthNumbers) != 0)
        {
            lengths.ChangeNumber();
        }
    }

    public MotionFlags ReadFunctions()
    {
        var flags = MotionFlags.None;
        foreach (var function in values.Words.Functions)
        {
            switches.StopAtFunction(function);
            switch (values.Dialect.FunctionOf(function))
            {
                case FunctionRole.Harmless when function == ToolChange:
                    result.ChangeTool();
                    break;
                case FunctionRole.Harmless or FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes:
                    break;
                case FunctionRole.DropModes:
                    memory.Drop();
                    break;
                case FunctionRole.Unknown:
                    var message = $"An M function is not known to the dialect {values.Dialect.Name}.";
                    flags |= result.Problem("unknown-code", message, MotionFlags.UnknownWord);
                    layers.Forget();
                    break;
                case var role when role.Steers():
                    // The flow executes it after the words.
                    break;
                default:
                    layers.Forget();
                    break;
            }
        }

        return flags;
    }

    /// <summary>Applies the meaning of a code or keyword; the family distinguishes transformations that each have their own end
    /// code.</summary>
    public void Apply(NcMeaning meaning, int family, string? word = null)
    {
        switch (meaning)
        {
            case NcMeaning.ToolCall:
                intent.CallsTool = true;
                break;
            case NcMeaning.Dwell:
                intent.Use = AxisUse.Nothing;
                break;
            case NcMeaning.ReferenceReturn or NcMeaning.ReferenceReturnOfAxes:
                (intent.Use, intent.Code) = (AxisUse.Reference, meaning);
                break;
            case NcMeaning.ProbeInBlock:
                intent.Probes = true;
                break;
            case NcMeaning.Polar:
                // Axis words in the same block are already polar.
                transforms.Begin(meaning, family);
                break;
            case NcMeaning.MirroringOff:
                // Its axis words name the axes; they are not a motion.
                intent.Use = AxisUse.Nothing;
                transforms.End(meaning, family);
                break;
            case NcMeaning.StoreReference:
                machine.Store();
                break;
            case NcMeaning.SetPole:
                intent.Use = AxisUse.Center;
                break;
            case NcMeaning.CornerRounding or NcMeaning.CornerChamfer:
                (intent.Use, intent.Code) = (AxisUse.Corner, meaning);
                break;
            case NcMeaning.UnknownOrigin:
                intent.Use = AxisUse.Nothing;
                layers.LoseOrigin();
                break;
            case NcMeaning.ComputedContour:
                intent.Use = AxisUse.Nothing;
                run.Follow(run.Flow.Refuse(NcRefusalCodes.NotASimpleMove, run.At,
                    "the control computes this element of the contour itself: where it leads is not known. Post lines and arcs."));
                break;
            case NcMeaning.ToolAxisRetract:
                machine.Retract();
                break;
            case NcMeaning.MachineCoordinates or NcMeaning.SuppressFrames:
                intent.Use = AxisUse.MachineCoordinates;
                break;
            case var _ when meaning.Steers():
                // A call word that the flow did not execute.
                intent.Use = AxisUse.Nothing;
                run.Flow.RefuseCall(run.At, "A word of this block");
                break;
            case NcMeaning.Inch or NcMeaning.Metric:
                control.Units(meaning == NcMeaning.Inch, feedsToo: true);
                break;
            case NcMeaning.Harmless:
                break;
            case NcMeaning.LengthOffset:
                lengths.TakeFromTable();
                break;
            case NcMeaning.LengthOffsetOff:
                lengths.End();
                transforms.End(NcMeaning.OpaqueTransformOff, family);
                break;
            case NcMeaning.RotationOff or NcMeaning.ScalingOff or NcMeaning.PolarOff or NcMeaning.OpaqueTransformOff:
                transforms.End(meaning, family);

                // Such a block of a language may itself move rotary axes (PLANE RESET TURN).
                control.State.Unknown |= values.Dialect.BlocksNameMotions ? AxisSet.All : AxisSet.None;
                break;
            case NcMeaning.Smoothing:
                result.Note("smoothing",
                    "From here on the control smooths the path: the motions are as programmed only within its tolerance.");
                break;
            case >= NcMeaning.PoleFromPosition and <= NcMeaning.PoleFromPole:
                (intent.Use, intent.Code) = (AxisUse.Pole, meaning);
                break;
            case (>= NcMeaning.OpaqueMotion and <= NcMeaning.BoltArc) or NcMeaning.BoltLine:
                (intent.Use, intent.Code) = (AxisUse.Cycle, meaning);
                break;
            case var _ when SetsOrigin(meaning):
                (intent.Use, intent.Code, intent.Family) = (AxisUse.Origin, meaning, family);
                break;
            default:
                SwitchMode(meaning, word);
                break;
        }
    }

    /// <summary>Calls the block's tool, or changes what its call says.</summary>
    public void CallTool() => switches.CallTool(intent.Oversize);

    private static bool SetsOrigin(NcMeaning meaning) => meaning
        is (>= NcMeaning.SetPosition and <= NcMeaning.SetOffset) or NcMeaning.ToolLength
        or NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.Mirroring or NcMeaning.OpaqueTransform or NcMeaning.DatumShift
        or (>= NcMeaning.FrameShift and <= NcMeaning.FrameMirrorMore);

    /// <summary>Sets the sense of the block's arc by the sign at the end of a word: DR+, DR-.</summary>
    public void TakeSense(ReadOnlySpan<byte> word)
    {
        if (intent.NeedsSense && word[^1] is (byte)'+' or (byte)'-')
        {
            control.State.Mode = word[^1] == '+' ? MotionKind.ArcCounterClockwise : MotionKind.ArcClockwise;
            intent.NeedsSense = false;
        }
    }

    private void NameMotion(NcMeaning meaning)
    {
        var form = meaning switch
        {
            NcMeaning.ArcAboutPole or NcMeaning.PolarArc => NcMeaning.ArcAboutPole,
            NcMeaning.PolarTangentArc => NcMeaning.TangentArc,
            _ => NcMeaning.Unknown,
        };
        control.Mode(meaning == NcMeaning.PolarLine ? MotionKind.Line : MotionKind.ArcClockwise);
        control.State.Form = form;
        intent.NeedsSense = meaning is NcMeaning.ArcByRadius or NcMeaning.ArcAboutPole or NcMeaning.PolarArc;
        intent.AboutPole = meaning is NcMeaning.PolarArc or NcMeaning.PolarLine or NcMeaning.PolarTangentArc;
    }

    // The control computes the way to a contour or away from it.
    private void NameLead(NcMeaning meaning, string word)
    {
        var leaves = meaning is NcMeaning.Departure or NcMeaning.DepartureTangent or NcMeaning.DepartureNormal;
        if (leaves)
        {
            control.Compensate(MotionFlags.None);
        }

        if (meaning is NcMeaning.Approach or NcMeaning.Departure)
        {
            result.Note("way-not-followed", $"{word}: the way between the contour and the place before or behind it is the control's. "
                + "Where it ends is known, if the block states it; whether it cuts into the piece is not.");
        }

        switches.Lead(meaning, word);
        control.Mode(MotionKind.Spline);
        control.State.Form = leaves ? NcMeaning.Departure : NcMeaning.Approach;
    }

    private void SwitchMode(NcMeaning meaning, string? word)
    {
        var isLead = meaning is NcMeaning.Approach or NcMeaning.Departure
            or (>= NcMeaning.ApproachTangent and <= NcMeaning.DepartureNormal);
        intent.NamesMotion |= isLead || meaning is NcMeaning.Line or NcMeaning.Rapid or NcMeaning.TangentArc
            or (>= NcMeaning.ArcByRadius and <= NcMeaning.PolarTangentArc);
        switch (meaning)
        {
            case var _ when isLead: NameLead(meaning, word ?? ""); break;
            case >= NcMeaning.ArcByRadius and <= NcMeaning.PolarTangentArc: NameMotion(meaning); break;
            case NcMeaning.RapidInBlock:
                control.State.Mode = intent.NamesMotion && control.State.Mode == MotionKind.Line ? MotionKind.Rapid : control.State.Mode;
                break;
            case NcMeaning.Rapid: control.Mode(MotionKind.Rapid); break;
            case NcMeaning.Line: control.Mode(MotionKind.Line); break;
            case NcMeaning.ThreadCut:
                control.Mode(MotionKind.Line);
                control.State.Form = meaning;
                break;
            case NcMeaning.ArcClockwise: control.Mode(MotionKind.ArcClockwise); break;
            case NcMeaning.ArcCounterClockwise: control.Mode(MotionKind.ArcCounterClockwise); break;
            case NcMeaning.Probe: control.Mode(MotionKind.Probe); break;
            case NcMeaning.Spline or NcMeaning.ArcThrough or NcMeaning.TangentArc:
                control.Mode(meaning == NcMeaning.Spline ? MotionKind.Spline : MotionKind.ArcClockwise);
                control.State.Form = meaning;
                break;
            case (>= NcMeaning.DrillCycle and <= NcMeaning.OpaqueCycle) or NcMeaning.OpaqueLevelCycle: canned.Begin(meaning); break;
            case NcMeaning.CycleOff:
                control.State.Cycle = NcMeaning.Unknown;
                control.State.Unsure &= ~Unsure.Mode;
                break;
            case NcMeaning.RetractToInitial: control.State.RetractsToR = false; break;
            case NcMeaning.RetractToR: control.State.RetractsToR = true; break;
            case NcMeaning.PlaneXY: switches.Plane(CoordinatePlane.XY); break;
            case NcMeaning.PlaneZX: switches.Plane(CoordinatePlane.ZX); break;
            case NcMeaning.PlaneYZ: switches.Plane(CoordinatePlane.YZ); break;
            case NcMeaning.Absolute: control.Distance(incremental: false); break;
            case NcMeaning.Incremental: control.Distance(incremental: true); break;
            case NcMeaning.AbsoluteCenters: control.State.AbsoluteCenters = true; break;
            case NcMeaning.IncrementalCenters: control.State.AbsoluteCenters = false; break;
            case >= NcMeaning.CompensationOff and <= NcMeaning.CompensationRight
                or >= NcMeaning.CompensationLeftByDiameter and <= NcMeaning.CompensationUnfollowed:
                switches.Apply(meaning, word);
                break;
            case NcMeaning.InverseTimeFeed: control.State.InverseTime = true; break;
            case NcMeaning.FeedPerMinute or NcMeaning.FeedPerRevolution: control.State.InverseTime = false; break;
            default:
                result.Problem("unknown-code", "What a word of this block means is not followed here.", MotionFlags.UnknownWord);
                layers.Forget();
                break;
        }
    }
}
