using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Exact circular and elliptical arcs as rational B-splines (The NURBS Book, section 7.3).</summary>
internal static class SplineArc
{
    /// <summary>The arc center + x cos a + y sin a.</summary>
    /// <param name="center">The center.</param>
    /// <param name="x">From the center to angle 0.</param>
    /// <param name="y">From the center to a quarter turn.</param>
    /// <param name="from">First angle in radians.</param>
    /// <param name="to">Last angle, at most one turn larger than the first.</param>
    /// <returns>A curve of degree 2 whose knots are angles. Inside the pieces, the parameter is not the angle.</returns>
    public static SplineCurve Of(Vector3 center, Vector3 x, Vector3 y, double from, double to)
    {
        var pieces = Pieces(from, to);
        var half = (to - from) / (2 * pieces);
        var breaks = Breaks(from, to);
        var poles = new Point3[(2 * pieces) + 1];
        var weights = new double[poles.Length];
        for (var i = 0; i < poles.Length; i++)
        {
            var middle = i % 2 == 1;
            var angle = middle ? (breaks[i / 2] + breaks[(i / 2) + 1]) / 2 : breaks[i / 2];
            weights[i] = middle ? Elementary.Cos(half) : 1;
            var p = center + (((x * Elementary.Cos(angle)) + (y * Elementary.Sin(angle))) * (1 / weights[i]));
            poles[i] = new(p.X, p.Y, p.Z);
        }

        return new(KnotVector.Clamped(2, breaks, 2), poles, weights);
    }

    /// <summary>The parameter of the arc at an angle: the tangent of a quarter of a piece's angle is linear in it.</summary>
    public static double ParameterOf(double angle, double from, double to)
    {
        var breaks = Breaks(from, to);
        var piece = Math.Clamp((int)((angle - from) / (to - from) * (breaks.Length - 1)), 0, breaks.Length - 2);
        var (a, b) = (breaks[piece], breaks[piece + 1]);
        var (middle, half) = ((a + b) / 2, (b - a) / 2);
        return middle + (half * Elementary.Tan((angle - middle) / 2) / Elementary.Tan(half / 2));
    }

    private static int Pieces(double from, double to) => Math.Clamp((int)Math.Ceiling(((to - from) / (Math.PI / 2)) - 1e-9), 1, 4);

    private static double[] Breaks(double from, double to)
    {
        var pieces = Pieces(from, to);
        var breaks = new double[pieces + 1];
        for (var i = 0; i <= pieces; i++)
        {
            breaks[i] = i == pieces ? to : from + ((to - from) * i / pieces);
        }

        return breaks;
    }
}
