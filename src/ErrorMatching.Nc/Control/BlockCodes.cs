using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Applies the G codes and M functions of a block to the modes.</summary>
internal sealed class BlockCodes(NcControl control, OriginCodes origins, MachineMoves machine, CannedCycles canned)
{
    /// <summary>The M function of a tool change.</summary>
    public const int ToolChange = 6;

    public CompensationWords Compensation { get; } = new(control);

    public MotionFlags ReadCodes()
    {
        var flags = MotionFlags.None;
        Compensation.ReadOffset();
        ReadLength();
        foreach (var tenths in control.Words.Codes)
        {
            var meaning = control.Dialect.MeaningOf(tenths);
            Compensation.StopAt(tenths);
            switch (meaning)
            {
                case NcMeaning.Unknown:
                    var code = (tenths / 10m).ToString(CultureInfo.InvariantCulture);
                    flags |= control.Result.Problem(
                        "unknown-code", $"G{code} is not known to the dialect {control.Dialect.Name}.", MotionFlags.UnknownWord);
                    control.Layers.Forget();
                    control.Intent.HasUnknownCode = true;
                    break;
                case NcMeaning.WorkOffset:
                    var letter = control.Dialect.WorkOffsetLetter;
                    var number = control.Words.Has(letter) ? (int)Math.Clamp(control.Words.Value(letter), 0, 1000) : 0;
                    origins.Offsets.Choose((tenths, number), (control.Words.Unknown & BlockWords.Bit(letter)) == 0);
                    break;
                case NcMeaning.Inch or NcMeaning.Metric:
                    control.Units(meaning == NcMeaning.Inch, control.Dialect.ScalesFeed(tenths));
                    break;
                case var _ when meaning.Steers():
                    // The flow executes it after the words; axis words are arguments.
                    control.Intent.Use = AxisUse.Nothing;
                    break;
                case NcMeaning.ReferenceReturn or NcMeaning.StoreReference:
                    control.Intent.Reference = tenths / 10;
                    Apply(meaning, 0);
                    break;
                default:
                    Apply(meaning, control.Dialect.FamilyOf(tenths));
                    break;
            }
        }

        return flags;
    }

    // What is passed to a called program is not of this kind.
    private void ReadLength()
    {
        foreach (var function in control.Words.Functions)
        {
            if (control.Dialect.FunctionOf(function).Steers())
            {
                return;
            }
        }

        foreach (var code in control.Words.Codes)
        {
            if (control.Dialect.MeaningOf(code).Steers())
            {
                return;
            }
        }

        var given = control.Words.Present | control.Words.Computed;
        if ((given & control.Values.Lengths) != 0)
        {
            origins.Lengths.TakeFromTable();
        }
        else if ((given & control.Values.LengthNumbers) != 0)
        {
            origins.Lengths.ChangeNumber();
        }
    }

    public MotionFlags ReadFunctions()
    {
        var flags = MotionFlags.None;
        foreach (var function in control.Words.Functions)
        {
            Compensation.StopAtFunction(function);
            switch (control.Dialect.FunctionOf(function))
            {
                case FunctionRole.Harmless when function == ToolChange:
                    control.Result.ChangeTool();
                    break;
                case FunctionRole.Harmless or FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes
                    or FunctionRole.DropModes:
                    break;
                case FunctionRole.Unknown:
                    var message = $"An M function is not known to the dialect {control.Dialect.Name}.";
                    flags |= control.Result.Problem("unknown-code", message, MotionFlags.UnknownWord);
                    control.Layers.Forget();
                    break;
                case var role when role.Steers():
                    // The flow executes it after the words.
                    break;
                default:
                    control.Layers.Forget();
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
                control.Intent.CallsTool = true;
                break;
            case NcMeaning.Dwell:
                control.Intent.Use = AxisUse.Nothing;
                break;
            case NcMeaning.ReferenceReturn or NcMeaning.ReferenceReturnOfAxes:
                (control.Intent.Use, control.Intent.Code) = (AxisUse.Reference, meaning);
                break;
            case NcMeaning.ProbeInBlock:
                control.Intent.Probes = true;
                break;
            case NcMeaning.Polar:
                // Axis words in the same block are already polar.
                origins.Transforms.Begin(meaning, family);
                break;
            case NcMeaning.MirroringOff:
                // Its axis words name the axes; they are not a motion.
                control.Intent.Use = AxisUse.Nothing;
                origins.Transforms.End(meaning, family);
                break;
            case NcMeaning.StoreReference:
                control.Layers.StorePlace(control.Intent.Reference);
                break;
            case NcMeaning.SetPole:
                control.Intent.Use = AxisUse.Center;
                break;
            case NcMeaning.CornerRounding or NcMeaning.CornerChamfer:
                (control.Intent.Use, control.Intent.Code) = (AxisUse.Corner, meaning);
                break;
            case NcMeaning.UnknownOrigin:
                control.Intent.Use = AxisUse.Nothing;
                control.Layers.LoseOrigin();
                break;
            case NcMeaning.ComputedContour:
                control.Intent.Use = AxisUse.Nothing;
                control.Run.Follow(control.Run.Flow.Refuse(NcRefusalCodes.NotASimpleMove, control.Run.At,
                    "the control computes this element of the contour itself: where it leads is not known. Post lines and arcs."));
                break;
            case NcMeaning.ToolAxisRetract:
                machine.Retract();
                break;
            case NcMeaning.MachineCoordinates or NcMeaning.SuppressFrames:
                control.Intent.Use = AxisUse.MachineCoordinates;
                break;
            case var _ when meaning.Steers():
                // A call word that the flow did not execute.
                control.Intent.Use = AxisUse.Nothing;
                control.Run.Flow.RefuseCall(control.Run.At, "A word of this block");
                break;
            case NcMeaning.Inch or NcMeaning.Metric:
                control.Units(meaning == NcMeaning.Inch, feedsToo: true);
                break;
            case NcMeaning.Harmless:
                break;
            case NcMeaning.LengthOffset:
                origins.Lengths.TakeFromTable();
                break;
            case NcMeaning.LengthOffsetOff:
                origins.Lengths.End();
                origins.Transforms.End(NcMeaning.OpaqueTransformOff, family);
                break;
            case NcMeaning.RotationOff or NcMeaning.ScalingOff or NcMeaning.PolarOff or NcMeaning.OpaqueTransformOff:
                origins.Transforms.End(meaning, family);

                // Such a block of a language may itself move rotary axes (PLANE RESET TURN).
                control.State.Unknown |= control.Dialect.BlocksNameMotions ? AxisSet.All : AxisSet.None;
                break;
            case NcMeaning.Smoothing:
                control.Result.Note("smoothing",
                    "From here on the control smooths the path: the motions are as programmed only within its tolerance.");
                break;
            case >= NcMeaning.PoleFromPosition and <= NcMeaning.PoleFromPole:
                (control.Intent.Use, control.Intent.Code) = (AxisUse.Pole, meaning);
                break;
            case (>= NcMeaning.OpaqueMotion and <= NcMeaning.BoltArc) or NcMeaning.BoltLine:
                (control.Intent.Use, control.Intent.Code) = (AxisUse.Cycle, meaning);
                break;
            case var _ when SetsOrigin(meaning):
                (control.Intent.Use, control.Intent.Code, control.Intent.Family) = (AxisUse.Origin, meaning, family);
                break;
            default:
                SwitchMode(meaning, word);
                break;
        }
    }

    /// <summary>Calls the block's tool, or changes what its call says.</summary>
    public void CallTool() => Compensation.CallTool(control.Intent.Oversize);

    private static bool SetsOrigin(NcMeaning meaning) => meaning
        is (>= NcMeaning.SetPosition and <= NcMeaning.SetOffset) or NcMeaning.ToolLength
        or NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.Mirroring or NcMeaning.OpaqueTransform or NcMeaning.DatumShift
        or (>= NcMeaning.FrameShift and <= NcMeaning.FrameMirrorMore);

    /// <summary>Sets the sense of the block's arc by the sign at the end of a word: DR+, DR-.</summary>
    public void TakeSense(ReadOnlySpan<byte> word)
    {
        if (control.Intent.NeedsSense && word[^1] is (byte)'+' or (byte)'-')
        {
            control.State.Mode = word[^1] == '+' ? MotionKind.ArcCounterClockwise : MotionKind.ArcClockwise;
            control.Intent.NeedsSense = false;
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
        control.Intent.NeedsSense = meaning is NcMeaning.ArcByRadius or NcMeaning.ArcAboutPole or NcMeaning.PolarArc;
        control.Intent.AboutPole = meaning is NcMeaning.PolarArc or NcMeaning.PolarLine or NcMeaning.PolarTangentArc;
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
            control.Result.Note("way-not-followed",
                $"{word}: the way between the contour and the place before or behind it is the control's. "
                + "Where it ends is known, if the block states it; whether it cuts into the piece is not.");
        }

        Compensation.Lead(meaning, word);
        control.Mode(MotionKind.Spline);
        control.State.Form = leaves ? NcMeaning.Departure : NcMeaning.Approach;
    }

    private void SwitchMode(NcMeaning meaning, string? word)
    {
        var isLead = meaning is NcMeaning.Approach or NcMeaning.Departure
            or (>= NcMeaning.ApproachTangent and <= NcMeaning.DepartureNormal);
        control.Intent.NamesMotion |= isLead || meaning is NcMeaning.Line or NcMeaning.Rapid or NcMeaning.TangentArc
            or (>= NcMeaning.ArcByRadius and <= NcMeaning.PolarTangentArc);
        switch (meaning)
        {
            case var _ when isLead: NameLead(meaning, word ?? ""); break;
            case >= NcMeaning.ArcByRadius and <= NcMeaning.PolarTangentArc: NameMotion(meaning); break;
            case NcMeaning.RapidInBlock:
                if (control.Intent.NamesMotion && control.State.Mode == MotionKind.Line)
                {
                    control.State.Mode = MotionKind.Rapid;
                }

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
            case NcMeaning.PlaneXY: Compensation.Plane(CoordinatePlane.XY); break;
            case NcMeaning.PlaneZX: Compensation.Plane(CoordinatePlane.ZX); break;
            case NcMeaning.PlaneYZ: Compensation.Plane(CoordinatePlane.YZ); break;
            case NcMeaning.Absolute: control.Distance(incremental: false); break;
            case NcMeaning.Incremental: control.Distance(incremental: true); break;
            case NcMeaning.AbsoluteCenters: control.State.AbsoluteCenters = true; break;
            case NcMeaning.IncrementalCenters: control.State.AbsoluteCenters = false; break;
            case >= NcMeaning.CompensationOff and <= NcMeaning.CompensationRight
                or >= NcMeaning.CompensationLeftByDiameter and <= NcMeaning.CompensationUnfollowed:
                Compensation.Apply(meaning, word);
                break;
            case NcMeaning.InverseTimeFeed: control.State.InverseTime = true; break;
            case NcMeaning.FeedPerMinute or NcMeaning.FeedPerRevolution: control.State.InverseTime = false; break;
            default:
                control.Result.Problem("unknown-code", "What a word of this block means is not followed here.", MotionFlags.UnknownWord);
                control.Layers.Forget();
                break;
        }
    }
}
