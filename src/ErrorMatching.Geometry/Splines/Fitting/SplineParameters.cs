namespace ErrorMatching.Geometry;

/// <summary>Parameters from 0 to 1 for fitting a curve or a surface to points (The NURBS Book, sections 9.2.1 and 9.2.5).</summary>
public static class SplineParameters
{
    /// <summary>Parameters proportional to the chords between the points.</summary>
    /// <param name="points">At least two points in order; neighbors differ.</param>
    /// <exception cref="GeometryException"><see cref="GeometryError.TooFewPoints"/>, <see cref="GeometryError.NotFinite"/>, or
    /// <see cref="GeometryError.CoincidentPoints"/> if neighbors coincide.</exception>
    public static double[] ChordLength(ReadOnlySpan<Point3> points) => Of(points, 1);

    /// <summary>Parameters proportional to the square roots of the chords, for curves with sharp turns.</summary>
    /// <inheritdoc cref="ChordLength"/>
    public static double[] Centripetal(ReadOnlySpan<Point3> points) => Of(points, 0.5);

    /// <summary>Parameters of both directions of a grid, proportional to the chords, averaged over the lines of each direction.</summary>
    /// <param name="points">The points, v varying fastest.</param>
    /// <param name="countU">Points along u, at least two.</param>
    /// <param name="countV">Points along v, at least two.</param>
    /// <exception cref="GeometryException">As for <see cref="ChordLength"/>; the count is not the product; or neighbors on a line
    /// coincide, unless the whole line is one point (a pole of the surface).</exception>
    public static (double[] U, double[] V) OfGrid(ReadOnlySpan<Point3> points, int countU, int countV)
    {
        if (points.Length != countU * countV)
        {
            throw new GeometryException(GeometryError.BadPoles, $"{points.Length} points for a grid of {countU} x {countV}");
        }

        return (Mean(points, countU, countV, countV, 1), Mean(points, countV, countU, 1, countV));
    }

    internal static void CheckRising(ReadOnlySpan<double> parameters, int count)
    {
        if (parameters.Length != count)
        {
            throw new GeometryException(GeometryError.BadKnots, $"{parameters.Length} parameters for {count} points");
        }

        for (var i = 0; i < count; i++)
        {
            if (!double.IsFinite(parameters[i]) || (i > 0 && !(parameters[i] > parameters[i - 1])))
            {
                throw new GeometryException(GeometryError.BadKnots, $"parameter {i + 1} is not larger than the one before it");
            }
        }
    }

    /// <summary>The mean of the parameters of all lines of one direction.</summary>
    private static double[] Mean(ReadOnlySpan<Point3> points, int count, int lines, int step, int nextLine)
    {
        var mean = new double[count];
        var used = 0;
        var line = new Point3[count];
        for (var k = 0; k < lines; k++)
        {
            for (var i = 0; i < count; i++)
            {
                line[i] = points[(k * nextLine) + (i * step)];
            }

            if (Array.TrueForAll(line, p => p == line[0]))
            {
                continue;
            }

            used++;
            var own = ChordLength(line);
            for (var i = 0; i < count; i++)
            {
                mean[i] += own[i];
            }
        }

        if (used == 0)
        {
            throw new GeometryException(GeometryError.CoincidentPoints, "all points of the grid's lines coincide: they span no surface");
        }

        for (var i = 0; i < count; i++)
        {
            mean[i] = i == count - 1 ? 1 : mean[i] / used;
        }

        return mean;
    }

    private static double[] Of(ReadOnlySpan<Point3> points, double power)
    {
        if (points.Length < 2)
        {
            throw new GeometryException(GeometryError.TooFewPoints, $"{points.Length} points; a curve needs at least two");
        }

        var result = new double[points.Length];
        for (var i = 1; i < points.Length; i++)
        {
            var chord = (points[i] - points[i - 1]).Length;
            if (!double.IsFinite(chord))
            {
                throw new GeometryException(GeometryError.NotFinite, $"point {i} or {i + 1} has a coordinate that is no finite number");
            }

            if (chord <= Intersect.DefaultTolerance)
            {
                throw new GeometryException(GeometryError.CoincidentPoints, $"points {i} and {i + 1} of the curve coincide");
            }

            result[i] = result[i - 1] + Elementary.Pow(chord, power);
        }

        for (var i = 1; i < result.Length; i++)
        {
            result[i] = i == result.Length - 1 ? 1 : result[i] / result[^1];
        }

        return result;
    }
}
