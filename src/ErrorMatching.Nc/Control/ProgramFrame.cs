using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

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
