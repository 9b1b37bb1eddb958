namespace ErrorMatching.Geometry;

/// <summary>Arc tangents, sines and cosines.</summary>
/// <remarks>All are angles of points in the first eighth of a turn: the angle of the point (x, y) is that of (64, j), from a table, plus
/// the arc tangent of u = (y - x j/64) / (x + y j/64), whose series to u^9/9 leaves out less than 2^-72 of it. j is the nearest whole
/// number to 64 y/x, so that |u| is at most 1/128. u has twice the digits of a double.</remarks>
internal static class ArcTangent
{
    // Below it, an arc tangent is its tangent, an arc sine its sine and a cube.
    private const double TinyTangent = 1.0 / (1 << 30), TinySine = 1.0 / (1 << 27);

    // Coordinates beyond 2^500 and below its inverse are brought nearer to 1 by 2^600, so that no product overflows or loses digits.
    private const double Large = 3.273390607896142e150, Nearer = 4.149515568880993e180;

    /// <summary>The angle of the point (x, y), from -pi to pi.</summary>
    public static double Of(double y, double x)
    {
        if (double.IsNaN(x) || double.IsNaN(y))
        {
            return double.NaN;
        }

        var (height, width) = (Math.Abs(y), Math.Abs(x));
        if (double.IsInfinity(height) || double.IsInfinity(width))
        {
            (height, width) = (double.IsInfinity(height) ? 1 : 0, double.IsInfinity(width) ? 1 : 0);
        }

        return Math.CopySign(OfPoint((height, 0), (width, 0), double.IsNegative(x)), y);
    }

    /// <summary>The arc sine.</summary>
    public static double Sine(double sine)
    {
        var size = Math.Abs(sine);
        return size < TinySine ? sine + (sine * sine * sine / 6)
            : size <= 1 ? Math.CopySign(OfPoint((size, 0), Other(size), false), sine)
            : double.NaN;
    }

    /// <summary>The arc cosine.</summary>
    public static double Cosine(double cosine)
    {
        var size = Math.Abs(cosine);
        return size <= 1 ? OfPoint(Other(size), (size, 0), cosine < 0) : double.NaN;
    }

    // The other leg of a right triangle with hypotenuse 1.
    private static (double High, double Low) Other(double leg)
    {
        var (square, error) = Parts.Product(leg, leg);
        var (rest, low) = Parts.FastSum(1, -square);
        low -= error;
        var root = Math.Sqrt(rest);
        var (product, productError) = Parts.Product(root, root);
        return root == 0 ? (0, 0) : (root, (rest - product - productError + low) / (2 * root));
    }

    // The angle of a point above the x axis, or on it.
    private static double OfPoint((double High, double Low) height, (double High, double Low) width, bool isLeft)
    {
        var isSteep = height.High > width.High;
        var (small, large) = isSteep ? (width, height) : (height, width);
        var tangent = large.High == 0 ? 0 : small.High / large.High;
        var angle = tangent < TinyTangent ? (tangent, 0) : Flat(small, large, tangent);
        if (!isSteep && !isLeft)
        {
            return angle.High;
        }

        var turns = isSteep ? 1 : 2;
        var (high, low) = isSteep && isLeft ? angle : (-angle.High, -angle.Low);
        var (sum, lost) = Parts.FastSum(turns * ElementaryTables.QuarterTurnHigh, high);
        return sum + (lost + (turns * ElementaryTables.QuarterTurnLow) + low);
    }

    private static (double High, double Low) Flat((double High, double Low) y, (double High, double Low) x, double tangent)
    {
        if (x.High is > Large or < 1 / Large)
        {
            var scale = x.High > 1 ? 1 / Nearer : Nearer;
            (x, y) = ((x.High * scale, x.Low * scale), (y.High * scale, y.Low * scale));
        }

        var j = (int)((tangent * 64) + 0.5);
        var slope = j / 64.0;
        var first = Parts.First(x.High);
        var (above, lost) = Parts.Sum(y.High, -slope * first);
        (above, var lostAgain) = Parts.Sum(above, -slope * (x.High - first));
        var numerator = Parts.FastSum(above, lost + lostAgain + (y.Low - (slope * x.Low)));

        first = Parts.First(y.High);
        (var along, lost) = Parts.Sum(x.High, slope * first);
        (along, lostAgain) = Parts.Sum(along, slope * (y.High - first));
        var (u, rest) = Parts.Quotient(numerator, (along, lost + lostAgain + (x.Low + (slope * y.Low))));

        var z = u * u;
        var series = u * z * ((-1.0 / 3) + (z * (0.2 - (z * ((1.0 / 7) - (z * (1.0 / 9)))))));
        (var sum, lost) = Parts.FastSum(ElementaryTables.Arcs[2 * j], u);
        return Parts.FastSum(sum, lost + (ElementaryTables.Arcs[(2 * j) + 1] + rest + series));
    }
}
