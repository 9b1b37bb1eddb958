using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>What the G codes of a block do to the modes.</content>
public sealed partial class NcInterpreter
{
    private AxisUse _use;
    private NcMeaning _code;
    private bool _hasUnknownCode;
    private bool _probes;

    private MotionFlags ReadCodes()
    {
        var flags = MotionFlags.None;
        foreach (var tenths in _words.Codes)
        {
            var meaning = _dialect.MeaningOf(tenths);
            switch (meaning)
            {
                case NcMeaning.Unknown:
                    flags |= Problem("unknown-code", $"G{(tenths / 10m).ToString(System.Globalization.CultureInfo.InvariantCulture)} is not known to the dialect {_dialect.Name}.", MotionFlags.UnknownWord);
                    Forget();
                    _hasUnknownCode = true;
                    break;
                case NcMeaning.WorkOffset:
                    var number = _words.Has('P') ? (int)Math.Clamp(_words.Value('P'), 0, 1000) : 0;
                    ChooseWorkOffset((tenths, number), (_words.Unknown & BlockWords.Bit('P')) == 0);
                    break;
                case NcMeaning.Inch or NcMeaning.Metric:
                    Units(meaning == NcMeaning.Inch, _dialect.ScalesFeed(tenths));
                    break;
                case var _ when meaning.Steers():
                    // The flow executes it behind the words; axis words are arguments.
                    _use = AxisUse.Nothing;
                    break;
                case NcMeaning.ReferenceReturn or NcMeaning.StoreReference:
                    _reference = tenths / 10;
                    Obey(meaning, 0);
                    break;
                default:
                    Obey(meaning, _dialect.FamilyOf(tenths));
                    break;
            }
        }

        return flags;
    }

    private MotionFlags ReadFunctions()
    {
        var flags = MotionFlags.None;
        foreach (var function in _words.Functions)
        {
            switch (_dialect.FunctionOf(function))
            {
                case FunctionRole.Harmless when function == ToolChange:
                    _toolChanges.Add(_motions.Length);
                    break;
                case FunctionRole.Harmless or FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes:
                    break;
                case FunctionRole.DropModes:
                    _savedModes.Remove(CallDepth);
                    break;
                case FunctionRole.Unknown:
                    var message = $"An M function is not known to the dialect {_dialect.Name}.";
                    flags |= Problem("unknown-code", message, MotionFlags.UnknownWord);
                    Forget();
                    break;
                case var role when role.Steers():
                    // The flow executes it behind the words.
                    break;
                default:
                    Forget();
                    break;
            }
        }

        return flags;
    }

    // What a code or a keyword means; the family tells transformations apart that have an end of their own.
    private void Obey(NcMeaning meaning, int family)
    {
        switch (meaning)
        {
            case NcMeaning.Dwell:
                _use = AxisUse.Nothing;
                break;
            case NcMeaning.ReferenceReturn or NcMeaning.ReferenceReturnOfAxes:
                (_use, _code) = (AxisUse.Reference, meaning);
                break;
            case NcMeaning.ProbeInBlock:
                _probes = true;
                break;
            case NcMeaning.Polar:
                // Axis words beside it are polar already.
                BeginTransform(meaning);
                break;
            case NcMeaning.MirroringOff:
                // Its axis words say which axes; they are no motion.
                _use = AxisUse.Nothing;
                EndTransform(meaning, family);
                break;
            case NcMeaning.StoreReference:
                StoreReference();
                break;
            case NcMeaning.MachineCoordinates or NcMeaning.SuppressFrames:
                _use = AxisUse.MachineCoordinates;
                break;
            case var _ when meaning.Steers():
                // A word that calls and that the flow has not executed.
                _use = AxisUse.Nothing;
                Flow.RefuseCall(_at, "A word of this block");
                break;
            case NcMeaning.Inch or NcMeaning.Metric:
                Units(meaning == NcMeaning.Inch, feedsToo: true);
                break;
            case NcMeaning.Harmless:
                break;
            case NcMeaning.LengthOffset:
                TakeLengthOfTable();
                break;
            case NcMeaning.LengthOffsetOff:
                EndToolLength();
                EndTransform(NcMeaning.OpaqueTransformOff, family);
                break;
            case NcMeaning.RotationOff or NcMeaning.ScalingOff or NcMeaning.PolarOff or NcMeaning.OpaqueTransformOff:
                EndTransform(meaning, family);
                break;
            case NcMeaning.Smoothing:
                Note("smoothing", "From here on the control smooths the path: the motions are as programmed only within its tolerance.");
                break;
            case var _ when SetsOrigin(meaning):
                (_use, _code, _family) = (AxisUse.Origin, meaning, family);
                break;
            default:
                SwitchMode(meaning);
                break;
        }
    }

    private static bool SetsOrigin(NcMeaning meaning) => meaning
        is (>= NcMeaning.SetPosition and <= NcMeaning.SetOffset) or NcMeaning.ToolLength
        or NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.Mirroring or NcMeaning.OpaqueTransform
        or (>= NcMeaning.FrameShift and <= NcMeaning.FrameMirrorMore);

    private void SwitchMode(NcMeaning meaning)
    {
        switch (meaning)
        {
            case NcMeaning.Rapid: Mode(MotionKind.Rapid); break;
            case NcMeaning.Line: Mode(MotionKind.Line); break;
            case NcMeaning.ThreadCut:
                Mode(MotionKind.Line);
                _state.Form = meaning;
                break;
            case NcMeaning.ArcClockwise: Mode(MotionKind.ArcClockwise); break;
            case NcMeaning.ArcCounterClockwise: Mode(MotionKind.ArcCounterClockwise); break;
            case NcMeaning.Probe: Mode(MotionKind.Probe); break;
            case NcMeaning.Spline or NcMeaning.ArcThrough or NcMeaning.TangentArc:
                Mode(meaning == NcMeaning.Spline ? MotionKind.Spline : MotionKind.ArcClockwise);
                _state.Form = meaning;
                break;
            case >= NcMeaning.DrillCycle and <= NcMeaning.OpaqueCycle: BeginCycle(meaning); break;
            case NcMeaning.CycleOff:
                _state.Cycle = NcMeaning.Unknown;
                _state.Unsure &= ~Unsure.Mode;
                break;
            case NcMeaning.RetractToInitial: _state.RetractsToR = false; break;
            case NcMeaning.RetractToR: _state.RetractsToR = true; break;
            case NcMeaning.PlaneXY: Plane(CoordinatePlane.XY); break;
            case NcMeaning.PlaneZX: Plane(CoordinatePlane.ZX); break;
            case NcMeaning.PlaneYZ: Plane(CoordinatePlane.YZ); break;
            case NcMeaning.Absolute: Distance(incremental: false); break;
            case NcMeaning.Incremental: Distance(incremental: true); break;
            case NcMeaning.AbsoluteCenters: _state.AbsoluteCenters = true; break;
            case NcMeaning.IncrementalCenters: _state.AbsoluteCenters = false; break;
            case NcMeaning.CompensationOff: Compensate(MotionFlags.None); break;
            case NcMeaning.CompensationLeft: Compensate(MotionFlags.CompensationLeft); break;
            case NcMeaning.CompensationRight: Compensate(MotionFlags.CompensationRight); break;
            case NcMeaning.InverseTimeFeed: _state.InverseTime = true; break;
            case NcMeaning.FeedPerMinute or NcMeaning.FeedPerRevolution: _state.InverseTime = false; break;
            default:
                Problem("unknown-code", "What a word of this block means is not followed here.", MotionFlags.UnknownWord);
                Forget();
                break;
        }
    }

    private void Units(bool inch, bool feedsToo)
    {
        _state.Inch = inch;
        _state.InchFeed = feedsToo ? inch : _state.InchFeed;
    }

    private void Mode(MotionKind kind)
    {
        _state.Mode = kind;
        _state.Form = NcMeaning.Unknown;
        _state.Cycle = NcMeaning.Unknown;
        _state.Unsure &= ~Unsure.Mode;
    }

    private void Plane(CoordinatePlane plane)
    {
        _state.Plane = plane;
        _state.Unsure &= ~Unsure.Plane;
    }

    private void Distance(bool incremental)
    {
        _state.Incremental = incremental;
        _state.Unsure &= ~Unsure.Distance;
    }

    private void Compensate(MotionFlags side)
    {
        _state.CompensationSwitched |= _state.Compensation != side;
        _state.Compensation = side;
        _state.Unsure &= ~Unsure.Compensation;
    }
}
