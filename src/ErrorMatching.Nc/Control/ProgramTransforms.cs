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
