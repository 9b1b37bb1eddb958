namespace ErrorMatching.Nc;

/// <content>What the G codes of a block do to the modes.</content>
public sealed partial class NcInterpreter
{
    private (AxisUse Use, int Code) ReadCodes()
    {
        var (use, code) = (AxisUse.Motion, 0);
        foreach (var tenths in words.Codes)
        {
            switch (dialect.MeaningOf(tenths))
            {
                case NcMeaning.Unknown:
                    problems.Add(new("unknown-code", words.BlockIndex, $"G{(tenths / 10m).ToString(System.Globalization.CultureInfo.InvariantCulture)} is not known to the dialect {dialect.Name}."));
                    Forget();
                    break;
                case NcMeaning.Dwell:
                    use = AxisUse.Nothing;
                    break;
                case NcMeaning.SetOrigin:
                    (use, code) = (AxisUse.SetOrigin, tenths);
                    break;
                case NcMeaning.ReferenceReturn:
                    use = AxisUse.Reference;
                    break;
                case NcMeaning.MachineCoordinates:
                    use = AxisUse.MachineCoordinates;
                    break;
                case NcMeaning.Call:
                    (use, code) = (AxisUse.Nothing, CallCode);
                    break;
                case NcMeaning.TransformOn:
                    use = AxisUse.Nothing;
                    SwitchTransforms(tenths);
                    break;
                case NcMeaning.TransformOff:
                    SwitchTransforms(tenths);
                    break;
                case NcMeaning.WorkOffset when tenths != state.WorkOffset || words.Has('P'):
                    state.WorkOffset = tenths;
                    state.Frame++;
                    state.Unknown = AxisSet.All;
                    break;
                case var meaning:
                    SwitchMode(meaning);
                    break;
            }
        }

        return (use, code);
    }

    private void SwitchTransforms(int tenths)
    {
        for (var i = 0; i < dialect.Transforms.Count; i++)
        {
            var (on, off) = dialect.Transforms[i];
            if (tenths == on)
            {
                state.Transforms |= 1ul << i;
                state.Frame++;
            }
            else if (tenths == off && (state.Transforms & (1ul << i)) != 0)
            {
                state.Transforms &= ~(1ul << i);
                state.Frame++;
                state.Unknown = AxisSet.All;
            }
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
            case NcMeaning.Cycle: state.CycleActive = true; break;
            case NcMeaning.CycleOff: state.CycleActive = false; break;
            case NcMeaning.PlaneXY: Plane(Geometry.CoordinatePlane.XY); break;
            case NcMeaning.PlaneZX: Plane(Geometry.CoordinatePlane.ZX); break;
            case NcMeaning.PlaneYZ: Plane(Geometry.CoordinatePlane.YZ); break;
            case NcMeaning.Inch: state.Inch = true; break;
            case NcMeaning.Metric: state.Inch = false; break;
            case NcMeaning.Absolute: Distance(incremental: false); break;
            case NcMeaning.Incremental: Distance(incremental: true); break;
            case NcMeaning.AbsoluteCenters: state.AbsoluteCenters = true; break;
            case NcMeaning.IncrementalCenters: state.AbsoluteCenters = false; break;
            case NcMeaning.CompensationOff: Compensate(MotionFlags.None); break;
            case NcMeaning.CompensationLeft: Compensate(MotionFlags.CompensationLeft); break;
            case NcMeaning.CompensationRight: Compensate(MotionFlags.CompensationRight); break;
        }
    }

    private void Mode(MotionKind kind)
    {
        state.Mode = kind;
        state.CycleActive = false;
        state.Unsure &= ~Unsure.Mode;
    }

    private void Plane(Geometry.CoordinatePlane plane)
    {
        state.Plane = plane;
        state.Unsure &= ~Unsure.Plane;
    }

    private void Distance(bool incremental)
    {
        state.Incremental = incremental;
        state.Unsure &= ~Unsure.Distance;
    }

    private void Compensate(MotionFlags side)
    {
        state.CompensationSwitched |= state.Compensation != side;
        state.Compensation = side;
        state.Unsure &= ~Unsure.Compensation;
    }
}
