namespace ErrorMatching.Nc;

/// <content>What the G codes of a block do to the modes.</content>
public sealed partial class NcInterpreter
{
    private (AxisUse Use, int Code) ReadCodes()
    {
        var (use, code) = (AxisUse.Motion, 0);
        foreach (var tenths in _words.Codes)
        {
            switch (_dialect.MeaningOf(tenths))
            {
                case NcMeaning.Unknown:
                    _problems.Add(new("unknown-code", _words.BlockIndex, $"G{(tenths / 10m).ToString(System.Globalization.CultureInfo.InvariantCulture)} is not known to the dialect {_dialect.Name}."));
                    Forget();
                    break;
                case NcMeaning.Dwell:
                    use = AxisUse.Nothing;
                    break;
                case NcMeaning.SetPosition or NcMeaning.ClearPosition or NcMeaning.RestorePosition or NcMeaning.LocalShift or NcMeaning.SetOffset:
                    (use, code) = (AxisUse.SetOrigin, tenths);
                    break;
                case NcMeaning.ReferenceReturn:
                    use = AxisUse.Reference;
                    break;
                case NcMeaning.MachineCoordinates:
                    use = AxisUse.MachineCoordinates;
                    break;
                case NcMeaning.Call or NcMeaning.ModalCall:
                    (use, code) = (AxisUse.Nothing, CallCode);
                    break;
                case NcMeaning.Rotation or NcMeaning.Scaling or NcMeaning.Mirroring or NcMeaning.Polar or NcMeaning.OpaqueTransform:
                    use = AxisUse.Nothing;
                    BeginTransform(_dialect.MeaningOf(tenths));
                    break;
                case NcMeaning.RotationOff or NcMeaning.ScalingOff or NcMeaning.MirroringOff or NcMeaning.PolarOff or NcMeaning.OpaqueTransformOff or NcMeaning.LengthOffsetOff:
                    EndTransform(_dialect.MeaningOf(tenths));
                    break;
                case NcMeaning.WorkOffset when tenths != _state.WorkOffset || _words.Has('P'):
                    _state.WorkOffset = tenths;
                    _state.Frame++;
                    _state.Unknown = AxisSet.All;
                    break;
                case var meaning:
                    SwitchMode(meaning);
                    break;
            }
        }

        return (use, code);
    }

    private void BeginTransform(NcMeaning meaning)
    {
        _state.Transforms |= 1ul << (int)meaning;
        _state.Frame++;
    }

    private void EndTransform(NcMeaning meaning)
    {
        var ended = 1ul << (int)(meaning switch
        {
            NcMeaning.RotationOff => NcMeaning.Rotation,
            NcMeaning.ScalingOff => NcMeaning.Scaling,
            NcMeaning.MirroringOff => NcMeaning.Mirroring,
            NcMeaning.PolarOff => NcMeaning.Polar,
            _ => NcMeaning.OpaqueTransform,
        });
        if ((_state.Transforms & ended) != 0)
        {
            _state.Transforms &= ~ended;
            _state.Frame++;
            _state.Unknown = AxisSet.All;
        }
    }

    private void SwitchMode(NcMeaning meaning)
    {
        switch (meaning)
        {
            case NcMeaning.Rapid: Mode(MotionKind.Rapid); break;
            case NcMeaning.Line: Mode(MotionKind.Line); break;
            case NcMeaning.ArcClockwise: Mode(MotionKind.ArcClockwise); break;
            case NcMeaning.ArcCounterClockwise: Mode(MotionKind.ArcCounterClockwise); break;
            case NcMeaning.Probe: Mode(MotionKind.Probe); break;
            case NcMeaning.DrillCycle or NcMeaning.DwellDrillCycle or NcMeaning.PeckCycle or NcMeaning.ChipBreakCycle or NcMeaning.FeedOutCycle or NcMeaning.StopOutCycle or NcMeaning.OpaqueCycle: _state.CycleActive = true; break;
            case NcMeaning.CycleOff: _state.CycleActive = false; break;
            case NcMeaning.PlaneXY: Plane(Geometry.CoordinatePlane.XY); break;
            case NcMeaning.PlaneZX: Plane(Geometry.CoordinatePlane.ZX); break;
            case NcMeaning.PlaneYZ: Plane(Geometry.CoordinatePlane.YZ); break;
            case NcMeaning.Inch: _state.Inch = true; break;
            case NcMeaning.Metric: _state.Inch = false; break;
            case NcMeaning.Absolute: Distance(incremental: false); break;
            case NcMeaning.Incremental: Distance(incremental: true); break;
            case NcMeaning.AbsoluteCenters: _state.AbsoluteCenters = true; break;
            case NcMeaning.IncrementalCenters: _state.AbsoluteCenters = false; break;
            case NcMeaning.CompensationOff: Compensate(MotionFlags.None); break;
            case NcMeaning.CompensationLeft: Compensate(MotionFlags.CompensationLeft); break;
            case NcMeaning.CompensationRight: Compensate(MotionFlags.CompensationRight); break;
        }
    }

    private void Mode(MotionKind kind)
    {
        _state.Mode = kind;
        _state.CycleActive = false;
        _state.Unsure &= ~Unsure.Mode;
    }

    private void Plane(Geometry.CoordinatePlane plane)
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
