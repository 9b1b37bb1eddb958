using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Surfaces whose every place is known in closed form.</summary>
internal static class Shapes
{
    /// <summary>The three designs of Lee 2019 (section 2.1, as worked out in the project's method): 75 x 63 mm.</summary>
    public static PartSurface One => Graph((x, y) => 30 - (0.004 * x * x), 75, 63);

    public static PartSurface Two => Graph((x, y) => 24 + (0.004 * (y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)), 75, 63);

    public static PartSurface Three => Graph(
        (x, y) => 24 + (0.004 * (((y - 31.5) * (y - 31.5) * ((2 * x / 75) - 1)) + ((x - 37.5) * (x - 37.5) * ((2 * y / 63) - 1)))), 75, 63);

    /// <summary>The design of a number, 1 to 3.</summary>
    public static PartSurface Design(int number) => number switch { 1 => One, 2 => Two, _ => Three };

    /// <summary>A level rectangle.</summary>
    public static PartSurface Plane(double width, double height, double z = 0) => Graph((_, _) => z, width, height);

    /// <summary>The graph of a polynomial that is at most quadratic in x and in y, over 0 to width and 0 to height, exactly.</summary>
    public static PartSurface Graph(Func<double, double, double> z, double width, double height)
    {
        var poles = new Point3[9];
        for (var i = 0; i < 3; i++)
        {
            for (var j = 0; j < 3; j++)
            {
                poles[(3 * i) + j] = new(width * i / 2, height * j / 2, Pole(i, k => Pole(j, l => z(width * k / 2, height * l / 2))));
            }
        }

        return new("graph", new(KnotVector.Clamped(2, [0, 1]), KnotVector.Clamped(2, [0, 1]), poles), SurfaceRegion.Whole, 1);
    }

    /// <summary>Part of a cylinder along y, exactly: radius and center height, over 90 degrees around the upper (or lower,
    /// if hollow) line.</summary>
    public static PartSurface Cylinder(double radius, double length, bool hollow = false)
    {
        var (side, weight) = (radius / Math.Sqrt(2), 1 / Math.Sqrt(2));
        var sign = hollow ? -1 : 1;
        Point3[] poles = [
            new(-side, 0, sign * side),
            new(-side, length, sign * side),
            new(0, 0, sign * radius * Math.Sqrt(2)),
            new(0, length, sign * radius * Math.Sqrt(2)),
            new(side, 0, sign * side),
            new(side, length, sign * side)];
        return new(
            "cylinder",
            new(KnotVector.Clamped(2, [0, 1]), KnotVector.Clamped(1, [0, 1]), poles, [1, 1, weight, weight, 1, 1]),
            SurfaceRegion.Whole,
            1);
    }

    // The pole of a quadratic Bezier polynomial from its values at 0, 1/2 and 1.
    private static double Pole(int number, Func<int, double> value) =>
        number == 1 ? (2 * value(1)) - ((value(0) + value(2)) / 2) : value(number);
}
