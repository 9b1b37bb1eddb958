using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>What the G codes of a block do to the modes.</content>
public sealed partial class NcInterpreter
{
    private bool _calls;

    private (AxisUse Use, NcMeaning Code) ReadCodes()
    {
        var (use, code) = (AxisUse.Motion, NcMeaning.Unknown);
        foreach (var tenths in _words.Codes)
        {
            var meaning = _dialect.MeaningOf(tenths);
            switch (meaning)
            {
                case NcMeaning.Unknown:
                    Problem("unknown-code", $"G{(tenths / 10m).ToString(System.Globalization.CultureInfo.InvariantCulture)} is not known to the dialect {_dialect.Name}.", MotionFlags.UnknownWord);
                    Forget();
                    break;
                case NcMeaning.Dwell:
                    use = AxisUse.Nothing;
                    break;
                case NcMeaning.ReferenceReturn:
                    use = AxisUse.Reference;
                    break;
                case NcMeaning.MachineCoordinates or NcMeaning.SuppressFrames:
                    use = AxisUse.MachineCoordinates;
                    break;
                case NcMeaning.Call or NcMeaning.ModalCall:
                    use = AxisUse.Nothing;
                    _calls = true;
                    break;
                case NcMeaning.WorkOffset:
                    ChooseWorkOffset(tenths);
                    break;
                case NcMeaning.LengthOffset:
                    _state.LengthOffset = true;
                    break;
                case NcMeaning.LengthOffsetOff:
                    _state.LengthOffset = false;
                    EndTransform(NcMeaning.OpaqueTransformOff);
                    break;
                case NcMeaning.RotationOff or NcMeaning.ScalingOff or NcMeaning.MirroringOff or NcMeaning.PolarOff or NcMeaning.OpaqueTransformOff:
                    EndTransform(meaning);
                    break;
                case var _ when SetsOrigin(meaning):
                    (use, code) = (AxisUse.Origin, meaning);
                    break;
                default:
                    SwitchMode(meaning);
                    break;
            }
        }

        return (use, code);
    }

    private static bool SetsOrigin(NcMeaning meaning) => meaning
        is NcMeaning.SetPosition or NcMeaning.ClearPosition or NcMeaning.RestorePosition or NcMeaning.LocalShift or NcMeaning.SetOffset
        or NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.Mirroring or NcMeaning.Polar or NcMeaning.OpaqueTransform
        or (>= NcMeaning.FrameShift and <= NcMeaning.FrameMirrorMore);

    private void SwitchMode(NcMeaning meaning)
    {
        switch (meaning)
        {
            case NcMeaning.Rapid: Mode(MotionKind.Rapid); break;
            case NcMeaning.Line: Mode(MotionKind.Line); break;
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
            case NcMeaning.Inch: _state.Inch = true; break;
            case NcMeaning.Metric: _state.Inch = false; break;
            case NcMeaning.Absolute: Distance(incremental: false); break;
            case NcMeaning.Incremental: Distance(incremental: true); break;
            case NcMeaning.AbsoluteCenters: _state.AbsoluteCenters = true; break;
            case NcMeaning.IncrementalCenters: _state.AbsoluteCenters = false; break;
            case NcMeaning.CompensationOff: Compensate(MotionFlags.None); break;
            case NcMeaning.CompensationLeft: Compensate(MotionFlags.CompensationLeft); break;
            case NcMeaning.CompensationRight: Compensate(MotionFlags.CompensationRight); break;
            case NcMeaning.InverseTimeFeed: _state.InverseTime = true; break;
            case NcMeaning.FeedPerMinute or NcMeaning.FeedPerRevolution: _state.InverseTime = false; break;
        }
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
