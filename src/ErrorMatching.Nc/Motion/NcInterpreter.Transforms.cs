using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Rotation, scale, mirror, polar coordinates and programmable frames between what is programmed and the work.</content>
public sealed partial class NcInterpreter
{
    private readonly double?[] _mirrors = new double?[3];
    private Transforms _transforms;
    private bool _isFlat;
    private ulong _opaqueFamilies;
    private int _family;
    private ProgramFrame? _rotation;
    private ProgramFrame? _scale;
    private ProgramFrame? _programmable;

    // Of all layers; null where work coordinates are those programmed.
    private ProgramFrame? _frame;
    private ProgramFrame? _inverse;

    [Flags]
    private enum Transforms : byte
    {
        None = 0,
        Rotation = 1,
        Scale = 2,
        Mirror = 4,
        Polar = 8,
        Programmable = 16,
        Opaque = 32,
    }

    // A programmable shift alone changes no increment and no arc.
    private bool IsTransformed => _transforms != Transforms.None && (_isFlat || !(_transforms == Transforms.Programmable && (_frame is null || _frame.ShiftOnly is not null)));

    private (Point3 Place, AxisSet Unknown) Work(Point3 programmed, AxisSet unknown)
    {
        if (_frame is null)
        {
            return (programmed, unknown);
        }

        return (_frame.Apply(programmed), unknown == AxisSet.None || _frame.KeepsAxes ? unknown : AxisSet.All);
    }

    private void SetWork(Point3 work, AxisSet unknown)
    {
        _state.Position = _inverse?.Apply(work) ?? work;
        _state.Unknown = unknown == AxisSet.None || _frame is null || _frame.KeepsAxes ? unknown : AxisSet.All;
    }

    private void BeginTransform(NcMeaning meaning)
    {
        var isKnown = (_words.Unknown & (LinearAxes | CenterWords | BlockWords.Bit('R') | BlockWords.Bit('P'))) == 0;
        var work = Work(_state.Position, _state.Unknown);
        switch (meaning)
        {
            case NcMeaning.Rotation:
                var (plane, center) = (_state.Plane, Center(_state.Plane.Axes(), ref isKnown));
                isKnown &= _words.Has('R');

                // A center that is named while scaling is active is scaled too, the angle is not (B-63944EN-2/02, page 211).
                _rotation = ProgramFrame.Rotation(plane, _scale?.Apply(center) ?? center, _words.Has('R') ? Degrees('R') : 0);
                Switch(Transforms.Rotation, on: true);
                break;
            case NcMeaning.Scaling:
                _scale = ScaleOf(ref isKnown);
                Switch(Transforms.Scale, on: true);
                break;
            case NcMeaning.Mirroring:
                foreach (var axis in "XYZ")
                {
                    _mirrors[axis - 'X'] = _words.Has(axis) ? Length(axis) : _mirrors[axis - 'X'];
                }

                Switch(Transforms.Mirror, on: true);
                break;
            case NcMeaning.Polar:
                Switch(Transforms.Polar, on: true);
                break;
            case NcMeaning.OpaqueTransform:
                Note("opaque-transform", "From here on the control transforms the coordinates in a way that is not followed: they are shown as programmed, and no block is changed.");
                _opaqueFamilies |= 1ul << _family;
                Switch(Transforms.Opaque, on: true);
                isKnown = false;
                break;
            default:
                _programmable = FrameOf(meaning, ref isKnown);
                Switch(Transforms.Programmable, _programmable is not null);
                break;
        }

        Recompose(isKnown ? work : (work.Place, AxisSet.All));
    }

    private void EndTransform(NcMeaning meaning, int family)
    {
        var ended = meaning switch
        {
            NcMeaning.RotationOff => Transforms.Rotation,
            NcMeaning.ScalingOff => Transforms.Scale,
            NcMeaning.MirroringOff => Transforms.Mirror,
            NcMeaning.PolarOff => Transforms.Polar,
            _ => Transforms.Opaque,
        };
        if ((_transforms & ended) == Transforms.None || (ended == Transforms.Opaque && family != 0 && (_opaqueFamilies & (1ul << family)) == 0))
        {
            return;
        }

        var work = Work(_state.Position, _state.Unknown);
        switch (ended)
        {
            case Transforms.Rotation: _rotation = null; break;
            case Transforms.Scale: _scale = null; break;
            case Transforms.Mirror when GivenAxes() is not AxisSet.None and var axes:
                foreach (var axis in "XYZ")
                {
                    _mirrors[axis - 'X'] = (axes & AxesOf(BlockWords.Bit(axis))) == AxisSet.None ? _mirrors[axis - 'X'] : null;
                }

                break;
            case Transforms.Mirror: Array.Clear(_mirrors); break;
        }

        _opaqueFamilies = ended != Transforms.Opaque ? _opaqueFamilies : family == 0 ? 0 : _opaqueFamilies & ~(1ul << family);
        Switch(ended, on: (ended == Transforms.Mirror && _mirrors.Any(m => m is not null)) || (ended == Transforms.Opaque && _opaqueFamilies != 0));
        Recompose(ended == Transforms.Opaque ? (work.Place, AxisSet.All) : work);
    }

    private void Switch(Transforms transform, bool on) => _transforms = on ? _transforms | transform : _transforms & ~transform;

    private void Recompose((Point3 Place, AxisSet Unknown) work)
    {
        var frame = _programmable ?? ProgramFrame.Identity;
        for (var axis = 0; axis < 3; axis++)
        {
            if (_mirrors[axis] is { } at)
            {
                var (center, factors) = axis switch
                {
                    0 => (new Point3(at, 0, 0), new Vector3(-1, 1, 1)),
                    1 => (new Point3(0, at, 0), new Vector3(1, -1, 1)),
                    _ => (new Point3(0, 0, at), new Vector3(1, 1, -1)),
                };
                frame = ProgramFrame.Scale(center, factors).After(frame);
            }
        }

        frame = (_scale ?? ProgramFrame.Identity).After(frame);
        frame = (_rotation ?? ProgramFrame.Identity).After(frame);
        var inverse = frame.Inverse();
        if (inverse is null)
        {
            Problem("zero-scale", "A factor of zero makes all places one.", MotionFlags.None);
            work.Unknown = AxisSet.All;
        }

        _isFlat = inverse is null;

        (_frame, _inverse) = frame.IsIdentity || inverse is null ? (null, null) : (frame, inverse);
        SetWork(work.Place, work.Unknown);
        NextFrame();
    }

    // The point that a block names; a missing coordinate is the tool's own.
    private Point3 Center(AxisSet needed, ref bool isKnown)
    {
        var place = Given(_state.Position, _state.Incremental);
        isKnown &= (_state.Unknown & needed & ~GivenAxes()) == AxisSet.None;
        return place;
    }

    // P without a point counts thousandths.
    private ProgramFrame ScaleOf(ref bool isKnown)
    {
        var center = Center(AxisSet.All, ref isKnown);
        if (_words.Has('P'))
        {
            var factor = Factor('P');
            return ProgramFrame.Scale(center, new(factor, factor, factor));
        }

        return ProgramFrame.Scale(center, new(_words.Has('I') ? Factor('I') : 1, _words.Has('J') ? Factor('J') : 1, _words.Has('K') ? Factor('K') : 1));
    }

    private double Factor(char letter) => _words.Value(letter) / ((_words.Integers & BlockWords.Bit(letter)) != 0 ? 1000 : 1);

    private ProgramFrame? FrameOf(NcMeaning meaning, ref bool isKnown)
    {
        var sum = meaning is NcMeaning.FrameShiftMore or NcMeaning.FrameRotationMore or NcMeaning.FrameScaleMore or NcMeaning.FrameMirrorMore;
        var before = sum ? _programmable ?? ProgramFrame.Identity : ProgramFrame.Identity;
        var angle = _words.PlaneAngle;
        if (GivenAxes() == AxisSet.None && angle is null)
        {
            return sum ? _programmable : null;
        }

        isKnown &= angle is not { } a || !double.IsNaN(a);
        var own = meaning switch
        {
            NcMeaning.FrameShift or NcMeaning.FrameShiftMore => ProgramFrame.Shift(Given(default, incremental: false) - default(Point3)),
            NcMeaning.FrameRotation or NcMeaning.FrameRotationMore when angle is { } turn => ProgramFrame.Rotation(_state.Plane, default, turn),
            NcMeaning.FrameRotation or NcMeaning.FrameRotationMore => RotationAboutAxes(),
            NcMeaning.FrameScale or NcMeaning.FrameScaleMore => ProgramFrame.Scale(default, Along(letter => _words.Value(letter), 1)),
            _ => ProgramFrame.Scale(default, Along(_ => -1, 1)),
        };
        return before.After(own);
    }

    // About Z, then the new Y, then the new X.
    private ProgramFrame RotationAboutAxes()
    {
        var angles = Along(letter => _words.Value(letter), 0);
        return ProgramFrame.Rotation(CoordinatePlane.XY, default, angles.Z)
            .After(ProgramFrame.Rotation(CoordinatePlane.ZX, default, angles.Y))
            .After(ProgramFrame.Rotation(CoordinatePlane.YZ, default, angles.X));
    }

    private Vector3 Along(Func<char, double> value, double otherwise) =>
        new(_words.Has('X') ? value('X') : otherwise, _words.Has('Y') ? value('Y') : otherwise, _words.Has('Z') ? value('Z') : otherwise);
}
