using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Codes that begin and end rotation, scaling, mirroring, polar coordinates and programmable frames.</summary>
internal sealed class TransformCodes(ControlState control, BlockValues values, CoordinateLayers layers, RunResult result)
{
    private ProgramTransforms Active => layers.Transforms;

    /// <summary>Begins a transformation, or adds to it.</summary>
    public void Begin(NcMeaning meaning, int family)
    {
        var isKnown = (values.Words.Unknown & (BlockWords.LinearAxes | BlockWords.CenterWords | BlockWords.Bit('R')
            | BlockWords.Bit('P'))) == 0;
        var work = layers.Tool();
        switch (meaning)
        {
            case NcMeaning.Rotation:
                var (plane, center) = (control.State.Plane, Center(control.State.Plane.Axes(), ref isKnown));
                isKnown &= values.Words.Has('R');

                // A center that is named while scaling is active is scaled too; the angle is not (B-63944EN-2/02, page 211).
                Active.Rotation = ProgramFrame.Rotation(plane, Active.Scale?.Apply(center) ?? center,
                    values.Words.Has('R') ? values.Degrees('R') : 0);
                Active.Switch(Transforms.Rotation, on: true);
                break;
            case NcMeaning.Scaling:
                Active.Scale = ScaleOf(ref isKnown);
                Active.Switch(Transforms.Scale, on: true);
                break;
            case NcMeaning.Mirroring:
                for (var axis = 'X'; axis <= 'Z'; axis++)
                {
                    if (values.Words.Has(axis))
                    {
                        Active.Mirror(axis - 'X', values.Length(axis));
                    }
                }

                Active.Switch(Transforms.Mirror, on: true);
                break;
            case NcMeaning.Polar:
                Active.Switch(Transforms.Polar, on: true);
                break;
            case NcMeaning.OpaqueTransform:
                result.Note("opaque-transform",
                    "From here on the control transforms the coordinates in a way that is not followed: "
                        + "they are shown as programmed, and no block is changed.");
                Active.OpaqueFamilies |= 1ul << family;
                isKnown = false;
                break;
            case NcMeaning.DatumShift:
                var shift = Active.Programmable?.ShiftOnly ?? Vector3.Zero;
                isKnown &= values.GivenAxes() != AxisSet.None;
                Active.Programmable = ProgramFrame.Shift(
                    values.End(default(Point3) + shift, values.Words.Present, values.Words.Incremental) - default(Point3));
                Active.Switch(Transforms.Programmable, on: true);
                break;
            default:
                Active.Programmable = FrameOf(meaning, ref isKnown);
                Active.Switch(Transforms.Programmable, Active.Programmable is not null);
                break;
        }

        layers.Recompose(isKnown ? work : (work.Place, AxisSet.All));
    }

    /// <summary>Ends a transformation. For those that are not followed, ends one family; 0 means all families.</summary>
    public void End(NcMeaning meaning, int family)
    {
        var ended = meaning switch
        {
            NcMeaning.RotationOff => Transforms.Rotation,
            NcMeaning.ScalingOff => Transforms.Scale,
            NcMeaning.MirroringOff => Transforms.Mirror,
            NcMeaning.PolarOff => Transforms.Polar,
            _ => Transforms.Opaque,
        };
        if (!Active.Has(ended, family))
        {
            control.State.Unknown |= Active.AreUnsure ? AxisSet.All : AxisSet.None;
            return;
        }

        var work = layers.Tool();
        switch (ended)
        {
            case Transforms.Rotation: Active.Rotation = null; break;
            case Transforms.Scale: Active.Scale = null; break;
            case Transforms.Mirror when values.GivenAxes() is not AxisSet.None and var axes:
                EndMirrors(axes);
                break;
            case Transforms.Mirror: EndMirrors(AxisSet.All); break;
        }

        if (ended == Transforms.Opaque)
        {
            Active.OpaqueFamilies = family == 0 ? 0 : Active.OpaqueFamilies & ~(1ul << family);
        }
        else
        {
            Active.Switch(ended, on: ended == Transforms.Mirror && Active.HaveMirrors);
        }

        layers.Recompose(ended == Transforms.Opaque ? (work.Place, AxisSet.All) : work);
    }

    /// <summary>Restores transformations that are not followed.</summary>
    public void RestoreOpaque(ulong families)
    {
        if (families == Active.OpaqueFamilies)
        {
            return;
        }

        var (place, _) = layers.Tool();
        Active.OpaqueFamilies = families;
        layers.Recompose((place, AxisSet.All));
    }

    private void EndMirrors(AxisSet axes)
    {
        for (var axis = 0; axis < 3; axis++)
        {
            if ((axes & (AxisSet)(1 << axis)) != AxisSet.None)
            {
                Active.Mirror(axis, null);
            }
        }
    }

    // The point that a block names; the tool's coordinate replaces a missing one.
    private Point3 Center(AxisSet needed, ref bool isKnown)
    {
        var place = values.Given(control.State.Position, control.State.Incremental);
        isKnown &= (control.State.Unknown & needed & ~values.GivenAxes()) == AxisSet.None;
        return place;
    }

    // P without a decimal point counts thousandths.
    private ProgramFrame ScaleOf(ref bool isKnown)
    {
        var center = Center(AxisSet.All, ref isKnown);
        if (values.Words.Has('P'))
        {
            var factor = values.Factor('P');
            return ProgramFrame.Scale(center, new(factor, factor, factor));
        }

        return ProgramFrame.Scale(center, new(values.Words.Has('I') ? values.Factor('I') : 1,
            values.Words.Has('J') ? values.Factor('J') : 1, values.Words.Has('K') ? values.Factor('K') : 1));
    }

    private ProgramFrame? FrameOf(NcMeaning meaning, ref bool isKnown)
    {
        var sum = meaning is NcMeaning.FrameShiftMore or NcMeaning.FrameRotationMore or NcMeaning.FrameScaleMore
            or NcMeaning.FrameMirrorMore;
        var before = sum ? Active.Programmable ?? ProgramFrame.Identity : ProgramFrame.Identity;
        var angle = values.Words.PlaneAngle;
        if (values.GivenAxes() == AxisSet.None && angle is null)
        {
            return sum ? Active.Programmable : null;
        }

        isKnown &= angle is not { } a || !double.IsNaN(a);
        var own = meaning switch
        {
            NcMeaning.FrameShift or NcMeaning.FrameShiftMore =>
                ProgramFrame.Shift(values.Given(default, incremental: false) - default(Point3)),
            NcMeaning.FrameRotation or NcMeaning.FrameRotationMore when angle is { } turn =>
                ProgramFrame.Rotation(control.State.Plane, default, turn),
            NcMeaning.FrameRotation or NcMeaning.FrameRotationMore => RotationAboutAxes(),
            NcMeaning.FrameScale or NcMeaning.FrameScaleMore =>
                ProgramFrame.Scale(default, values.Along(letter => values.Words.Value(letter), 1)),
            _ => ProgramFrame.Scale(default, values.Along(_ => -1, 1)),
        };
        return before.After(own);
    }

    // About Z, then the new Y, then the new X.
    private ProgramFrame RotationAboutAxes()
    {
        var angles = values.Along(letter => values.Words.Value(letter), 0);
        return ProgramFrame.Rotation(CoordinatePlane.XY, default, angles.Z)
            .After(ProgramFrame.Rotation(CoordinatePlane.ZX, default, angles.Y))
            .After(ProgramFrame.Rotation(CoordinatePlane.YZ, default, angles.X));
    }
}
