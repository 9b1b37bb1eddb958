using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>An affine map of the plane: where a block's drawing comes to be.</summary>
/// <param name="X">Image of the first axis.</param>
/// <param name="Y">Image of the second axis.</param>
/// <param name="Origin">Image of the origin.</param>
internal readonly record struct PlaneMap(Vector2 X, Vector2 Y, Point2 Origin)
{
    // Relative difference of two axes up to which circles stay circles. It is far below what coordinates of files have in digits.
    private const double Same = 1e-10;

    /// <summary>Turns the right side to the left: the plane as seen from below.</summary>
    public static PlaneMap FromBelow { get; } = new(new(-1, 0), new(0, 1), Point2.Origin);

    /// <summary>True if it turns counterclockwise into clockwise.</summary>
    public bool IsMirror => X.Cross(Y) < 0;

    /// <summary>The factor of lengths along the first axis.</summary>
    public double Scale => X.Length;

    /// <summary>The direction of the first axis, radians.</summary>
    public double Turn => Elementary.Atan2(X.Y, X.X);

    /// <summary>True if circles stay circles.</summary>
    public bool KeepsCircles => ((IsMirror ? -X.Left : X.Left) - Y).Length <= Same * X.Length;

    /// <summary>Enlarges.</summary>
    public static PlaneMap Scaling(double x, double y) => new(new(x, 0), new(0, y), Point2.Origin);

    /// <summary>Shifts.</summary>
    public static PlaneMap Shift(Vector2 by) => new(new(1, 0), new(0, 1), Point2.Origin + by);

    /// <summary>Rotates counterclockwise.</summary>
    public static PlaneMap Rotation(double degrees)
    {
        // Quarter turns are exact, so that what is horizontal in a block stays so.
        var rest = Math.IEEERemainder(degrees, 360);
        var (sin, cos) = rest switch
        {
            0 => (0.0, 1.0),
            90 => (1, 0),
            -90 => (-1, 0),
            180 or -180 => (0, -1),
            _ => Elementary.SinCos(rest * (Math.PI / 180)),
        };
        return new(new(cos, sin), new(-sin, cos), Point2.Origin);
    }

    /// <summary>The image of a point.</summary>
    public Point2 Of(Point2 p) => Origin + Of(p - Point2.Origin);

    /// <summary>The image of a displacement.</summary>
    public Vector2 Of(Vector2 v) => new((X.X * v.X) + (Y.X * v.Y), (X.Y * v.X) + (Y.Y * v.Y));

    /// <summary>This map after another.</summary>
    public PlaneMap After(in PlaneMap first) => new(Of(first.X), Of(first.Y), Of(first.Origin));
}
