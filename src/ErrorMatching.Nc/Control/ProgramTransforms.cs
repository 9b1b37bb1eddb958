using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Rotation, scaling, mirroring, polar coordinates and programmable frames between programmed and work coordinates: which are
/// active, and their combined map.</summary>
internal sealed class ProgramTransforms
{
    private readonly double?[] _mirrors = new double?[3];
    private Transforms _active;
    private bool _isFlat;
    private ulong _opaqueFamilies;

    public ProgramFrame? Rotation { get; set; }

    public ProgramFrame? Scale { get; set; }

    public ProgramFrame? Programmable { get; set; }

    /// <summary>Maps programmed to work coordinates; null if they are equal.</summary>
    public ProgramFrame? Frame { get; private set; }

    /// <summary>Maps work to programmed coordinates.</summary>
    public ProgramFrame? Inverse { get; private set; }

    /// <summary>True if none is active, so that a coordinate is the programmed one.</summary>
    public bool AreNone => Frame is null && _active == Transforms.None;

    /// <summary>True if coordinates in the plane are a radius and an angle.</summary>
    public bool IsPolar => (_active & Transforms.Polar) != Transforms.None;

    /// <summary>True if more than a programmable shift is active; a shift alone changes no increment and no arc.</summary>
    public bool AreMoreThanShift => _active != Transforms.None
        && (_isFlat || !(_active == Transforms.Programmable && (Frame is null || Frame.ShiftOnly is not null)));

    /// <summary>The families of active transformations that are not followed, one bit each.</summary>
    public ulong OpaqueFamilies
    {
        get => _opaqueFamilies;
        set
        {
            _opaqueFamilies = value;
            Switch(Transforms.Opaque, value != 0);
        }
    }

    /// <summary>True if a transformation is active. For one that is not followed, checks the family; 0 means all families.</summary>
    public bool Has(Transforms transform, int family) =>
        (_active & transform) != Transforms.None
            && (transform != Transforms.Opaque || family == 0 || (_opaqueFamilies & (1ul << family)) != 0);

    /// <summary>True if something unseen could have begun one.</summary>
    public bool AreUnsure { get; set; }

    public void Switch(Transforms transform, bool on) => _active = on ? _active | transform : _active & ~transform;

    /// <summary>True if an axis is mirrored.</summary>
    public bool HaveMirrors => Array.Exists(_mirrors, m => m is not null);

    /// <summary>Sets the mirror position of an axis, 0 for X; null ends it.</summary>
    public void Mirror(int axis, double? at) => _mirrors[axis] = at;

    /// <summary>Combines all into one frame: rotation of scale of mirror of programmable frame. False if a factor of zero maps all places
    /// to one.</summary>
    public bool Compose()
    {
        var frame = Programmable ?? ProgramFrame.Identity;
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

        frame = (Scale ?? ProgramFrame.Identity).After(frame);
        frame = (Rotation ?? ProgramFrame.Identity).After(frame);
        var inverse = frame.Inverse();
        _isFlat = inverse is null;
        (Frame, Inverse) = frame.IsIdentity || inverse is null ? (null, null) : (frame, inverse);
        return !_isFlat;
    }
}

/// <summary>Codes that begin and end rotation, scaling, mirroring, polar coordinates and programmable frames.</summary>
internal sealed class TransformCodes(NcControl control)
{
    private ProgramTransforms Active => control.Layers.Transforms;

    /// <summary>Begins a transformation, or adds to it.</summary>
    public void Begin(NcMeaning meaning, int family)
    {
        var isKnown = (control.Words.Unknown & (BlockWords.LinearAxes | BlockWords.CenterWords | BlockWords.Bit('R')
            | BlockWords.Bit('P'))) == 0;
        var work = control.Layers.Tool();
        switch (meaning)
        {
            case NcMeaning.Rotation:
                var (plane, center) = (control.State.Plane, Center(control.State.Plane.Axes(), ref isKnown));
                isKnown &= control.Words.Has('R');

                // A center that is named while scaling is active is scaled too; the angle is not (B-63944EN-2/02, page 211).
                Active.Rotation = ProgramFrame.Rotation(plane, Active.Scale?.Apply(center) ?? center,
                    control.Words.Has('R') ? control.Values.Degrees('R') : 0);
                Active.Switch(Transforms.Rotation, on: true);
                break;
            case NcMeaning.Scaling:
                Active.Scale = ScaleOf(ref isKnown);
                Active.Switch(Transforms.Scale, on: true);
                break;
            case NcMeaning.Mirroring:
                for (var axis = 'X'; axis <= 'Z'; axis++)
                {
                    if (control.Words.Has(axis))
                    {
                        Active.Mirror(axis - 'X', control.Values.Length(axis));
                    }
                }

                Active.Switch(Transforms.Mirror, on: true);
                break;
            case NcMeaning.Polar:
                Active.Switch(Transforms.Polar, on: true);
                break;
            case NcMeaning.OpaqueTransform:
                control.Result.Note("opaque-transform",
                    "From here on the control transforms the coordinates in a way that is not followed: "
                        + "they are shown as programmed, and no block is changed.");
                Active.OpaqueFamilies |= 1ul << family;
                isKnown = false;
                break;
            case NcMeaning.DatumShift:
                var shift = Active.Programmable?.ShiftOnly ?? Vector3.Zero;
                isKnown &= control.Values.GivenAxes() != AxisSet.None;
                Active.Programmable = ProgramFrame.Shift(
                    control.Values.End(default(Point3) + shift, control.Words.Present, control.Words.Incremental) - default(Point3));
                Active.Switch(Transforms.Programmable, on: true);
                break;
            default:
                Active.Programmable = FrameOf(meaning, ref isKnown);
                Active.Switch(Transforms.Programmable, Active.Programmable is not null);
                break;
        }

        control.Layers.Recompose(isKnown ? work : (work.Place, AxisSet.All));
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

        var work = control.Layers.Tool();
        switch (ended)
        {
            case Transforms.Rotation: Active.Rotation = null; break;
            case Transforms.Scale: Active.Scale = null; break;
            case Transforms.Mirror when control.Values.GivenAxes() is not AxisSet.None and var axes:
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

        control.Layers.Recompose(ended == Transforms.Opaque ? (work.Place, AxisSet.All) : work);
    }

    /// <summary>Restores transformations that are not followed.</summary>
    public void RestoreOpaque(ulong families)
    {
        if (families == Active.OpaqueFamilies)
        {
            return;
        }

        var (place, _) = control.Layers.Tool();
        Active.OpaqueFamilies = families;
        control.Layers.Recompose((place, AxisSet.All));
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
        var place = control.Values.Given(control.State.Position, control.State.Incremental);
        isKnown &= (control.State.Unknown & needed & ~control.Values.GivenAxes()) == AxisSet.None;
        return place;
    }

    // P without a decimal point counts thousandths.
    private ProgramFrame ScaleOf(ref bool isKnown)
    {
        var center = Center(AxisSet.All, ref isKnown);
        if (control.Words.Has('P'))
        {
            var factor = control.Values.Factor('P');
            return ProgramFrame.Scale(center, new(factor, factor, factor));
        }

        return ProgramFrame.Scale(center, new(control.Words.Has('I') ? control.Values.Factor('I') : 1,
            control.Words.Has('J') ? control.Values.Factor('J') : 1, control.Words.Has('K') ? control.Values.Factor('K') : 1));
    }

    private ProgramFrame? FrameOf(NcMeaning meaning, ref bool isKnown)
    {
        var sum = meaning is NcMeaning.FrameShiftMore or NcMeaning.FrameRotationMore or NcMeaning.FrameScaleMore
            or NcMeaning.FrameMirrorMore;
        var before = sum ? Active.Programmable ?? ProgramFrame.Identity : ProgramFrame.Identity;
        var angle = control.Words.PlaneAngle;
        if (control.Values.GivenAxes() == AxisSet.None && angle is null)
        {
            return sum ? Active.Programmable : null;
        }

        isKnown &= angle is not { } a || !double.IsNaN(a);
        var own = meaning switch
        {
            NcMeaning.FrameShift or NcMeaning.FrameShiftMore =>
                ProgramFrame.Shift(control.Values.Given(default, incremental: false) - default(Point3)),
            NcMeaning.FrameRotation or NcMeaning.FrameRotationMore when angle is { } turn =>
                ProgramFrame.Rotation(control.State.Plane, default, turn),
            NcMeaning.FrameRotation or NcMeaning.FrameRotationMore => RotationAboutAxes(),
            NcMeaning.FrameScale or NcMeaning.FrameScaleMore =>
                ProgramFrame.Scale(default, control.Values.Along(letter => control.Words.Value(letter), 1)),
            _ => ProgramFrame.Scale(default, control.Values.Along(_ => -1, 1)),
        };
        return before.After(own);
    }

    // About Z, then the new Y, then the new X.
    private ProgramFrame RotationAboutAxes()
    {
        var angles = control.Values.Along(letter => control.Words.Value(letter), 0);
        return ProgramFrame.Rotation(CoordinatePlane.XY, default, angles.Z)
            .After(ProgramFrame.Rotation(CoordinatePlane.ZX, default, angles.Y))
            .After(ProgramFrame.Rotation(CoordinatePlane.YZ, default, angles.X));
    }
}

/// <summary>Which transformations of a program are active.</summary>
[Flags]
internal enum Transforms : byte
{
    None = 0,
    Rotation = 1,
    Scale = 2,
    Mirror = 4,
    Polar = 8,
    Programmable = 16,
    Opaque = 32,
}

/// <summary>An affine map from programmed to work coordinates: rotation, scaling, mirroring and shift as one matrix. Null means "as
/// programmed".</summary>
internal sealed class ProgramFrame
{
    private readonly Vector3 _x;
    private readonly Vector3 _y;
    private readonly Vector3 _z;
    private readonly Vector3 _shift;

    private ProgramFrame(Vector3 x, Vector3 y, Vector3 z, Vector3 shift) => (_x, _y, _z, _shift) = (x, y, z, shift);

    /// <summary>Changes nothing.</summary>
    public static ProgramFrame Identity { get; } = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), Vector3.Zero);

    /// <summary>True if it moves no place.</summary>
    public bool IsIdentity =>
        _shift.Length < 1e-12
            && (_x - Identity._x).Length < 1e-12
            && (_y - Identity._y).Length < 1e-12
            && (_z - Identity._z).Length < 1e-12;

    /// <summary>The shift, if the map is only a shift; otherwise null.</summary>
    public Vector3? ShiftOnly => _x == Identity._x && _y == Identity._y && _z == Identity._z ? _shift : null;

    /// <summary>True if each axis stays parallel to itself, so that an unknown coordinate leaves the others known.</summary>
    public bool KeepsAxes => _x.Y == 0 && _x.Z == 0 && _y.X == 0 && _y.Z == 0 && _z.X == 0 && _z.Y == 0;

    /// <summary>A shift.</summary>
    public static ProgramFrame Shift(Vector3 by) => new(Identity._x, Identity._y, Identity._z, by);

    /// <summary>Factors along the axes about a point.</summary>
    public static ProgramFrame Scale(Point3 center, Vector3 factors) =>
        About(center, new(new(factors.X, 0, 0), new(0, factors.Y, 0), new(0, 0, factors.Z), Vector3.Zero));

    /// <summary>A rotation in a plane about a point, counter-clockwise in the plane's own axis order.</summary>
    public static ProgramFrame Rotation(CoordinatePlane plane, Point3 center, double degrees)
    {
        var (sin, cos) = Exact(degrees);
        return About(center, plane switch
        {
            CoordinatePlane.ZX => new(new(cos, 0, -sin), new(0, 1, 0), new(sin, 0, cos), Vector3.Zero),
            CoordinatePlane.YZ => new(new(1, 0, 0), new(0, cos, sin), new(0, -sin, cos), Vector3.Zero),
            _ => new(new(cos, sin, 0), new(-sin, cos, 0), new(0, 0, 1), Vector3.Zero),
        });
    }

    /// <summary>Applies another map first, then this one.</summary>
    public ProgramFrame After(ProgramFrame first) => new(Turn(first._x), Turn(first._y), Turn(first._z), Turn(first._shift) + _shift);

    /// <summary>Maps a programmed place.</summary>
    public Point3 Apply(Point3 p) => default(Point3) + Turn(p - default(Point3)) + _shift;

    /// <summary>Maps a programmed direction.</summary>
    public Vector3 Turn(Vector3 v) => (_x * v.X) + (_y * v.Y) + (_z * v.Z);

    /// <summary>The inverse map.</summary>
    /// <returns>Null if a factor is zero.</returns>
    public ProgramFrame? Inverse()
    {
        var (a, b, c) = (Cross(_y, _z), Cross(_z, _x), Cross(_x, _y));
        var determinant = Dot(_x, a);
        if (Math.Abs(determinant) < 1e-12)
        {
            return null;
        }

        var inverse = new ProgramFrame(
            new Vector3(a.X, b.X, c.X) * (1 / determinant),
            new Vector3(a.Y, b.Y, c.Y) * (1 / determinant),
            new Vector3(a.Z, b.Z, c.Z) * (1 / determinant),
            Vector3.Zero);
        return new(inverse._x, inverse._y, inverse._z, inverse.Turn(_shift) * -1);
    }

    /// <summary>Whether circles of a plane remain circles in that plane, and whether their direction reverses.</summary>
    public (bool StayCircles, bool TurnOver) OnCircles(CoordinatePlane plane)
    {
        var (first, second) = plane switch { CoordinatePlane.ZX => (_z, _x), CoordinatePlane.YZ => (_y, _z), _ => (_x, _y) };
        var (u, v) = (plane.Project(default(Point3) + first) - Point2.Origin, plane.Project(default(Point3) + second) - Point2.Origin);
        var tilt = Math.Abs(plane.Height(default(Point3) + first)) + Math.Abs(plane.Height(default(Point3) + second));
        var round = Math.Abs(u.Length - v.Length) < 1e-9 && Math.Abs(u.Dot(v)) < 1e-9 && tilt < 1e-9;
        return (round, u.Cross(v) < 0);
    }

    /// <summary>Factor by which lengths along the first axis of a plane grow.</summary>
    public double FactorIn(CoordinatePlane plane) => (plane switch { CoordinatePlane.ZX => _z, CoordinatePlane.YZ => _y, _ => _x }).Length;

    private static ProgramFrame About(Point3 center, ProgramFrame map)
    {
        var c = center - default(Point3);
        return new(map._x, map._y, map._z, c - map.Turn(c));
    }

    // Quarter turns give exact values.
    private static (double Sin, double Cos) Exact(double degrees)
    {
        var turned = Math.IEEERemainder(degrees, 360);
        return turned switch
        {
            0 => (0, 1),
            90 => (1, 0),
            -90 => (-1, 0),
            180 or -180 => (0, -1),
            _ => Elementary.SinCos(turned * Math.PI / 180),
        };
    }

    private static Vector3 Cross(Vector3 a, Vector3 b) =>
        new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    private static double Dot(Vector3 a, Vector3 b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);
}
