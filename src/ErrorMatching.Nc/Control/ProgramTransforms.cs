using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Rotation, scale, mirror, polar coordinates and programmable frames between what is programmed and the work: which are active, and what
/// all of them together are.
/// </summary>
internal sealed class ProgramTransforms
{
    private readonly double?[] _mirrors = new double?[3];
    private Transforms _active;
    private bool _isFlat;
    private ulong _opaqueFamilies;

    public ProgramFrame? Rotation { get; set; }

    public ProgramFrame? Scale { get; set; }

    public ProgramFrame? Programmable { get; set; }

    /// <summary>Of all of them; null where work coordinates are those programmed.</summary>
    public ProgramFrame? Frame { get; private set; }

    /// <summary>From the work to what is programmed.</summary>
    public ProgramFrame? Inverse { get; private set; }

    /// <summary>True if none is active, and a coordinate is what is programmed.</summary>
    public bool AreNone => Frame is null && _active == Transforms.None;

    /// <summary>True if coordinates in the plane are a radius and an angle.</summary>
    public bool IsPolar => (_active & Transforms.Polar) != Transforms.None;

    /// <summary>True if more than a programmable shift is active, which alone changes no increment and no arc.</summary>
    public bool AreMoreThanShift => _active != Transforms.None
        && (_isFlat || !(_active == Transforms.Programmable && (Frame is null || Frame.ShiftOnly is not null)));

    /// <summary>The families of transformations that are not followed and are active, a bit each.</summary>
    public ulong OpaqueFamilies
    {
        get => _opaqueFamilies;
        set
        {
            _opaqueFamilies = value;
            Switch(Transforms.Opaque, value != 0);
        }
    }

    /// <summary>True if one is active, and if it is one that is not followed, one of this family; 0 counts for all.</summary>
    public bool Has(Transforms transform, int family) =>
        (_active & transform) != Transforms.None
            && (transform != Transforms.Opaque || family == 0 || (_opaqueFamilies & (1ul << family)) != 0);

    public void Switch(Transforms transform, bool on) => _active = on ? _active | transform : _active & ~transform;

    /// <summary>True if an axis is mirrored.</summary>
    public bool HaveMirrors => Array.Exists(_mirrors, m => m is not null);

    /// <summary>Mirrors at a place on an axis, 0 for X; null ends it.</summary>
    public void Mirror(int axis, double? at) => _mirrors[axis] = at;

    /// <summary>
    /// Makes one frame of all: rotation of scale of mirror of programmable frame. False where a factor of zero makes all places one.
    /// </summary>
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
