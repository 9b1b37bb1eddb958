using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>A grid of points with parameters from 0 to 1, as the basis of every fit.</summary>
/// <remarks>Parameters are proportional to the chords projected along the coordinate axis that the surface faces. A height that is
/// polynomial over a design plane then stays polynomial, where true chords would distort it. If a projected chord is shorter than half its
/// true length, because the surface is steep or closed, true chords are used for all.</remarks>
internal sealed class FitGrid
{
    /// <summary>Number of places on each curve of a ragged grid at which the distances between curves are measured.</summary>
    private const int Places = 11;

    private FitGrid(Point3[][] curves, double[][] us, double[] vs, bool isRectangular, double lengthU, double lengthV) =>
        (Curves, CurveUs, Vs, IsRectangular, LengthU, LengthV) = (curves, us, vs, isRectangular, lengthU, lengthV);

    public Point3[][] Curves { get; }

    /// <summary>The parameters u of the points of each curve; equal for all curves of a rectangular grid.</summary>
    public double[][] CurveUs { get; }

    public double[] Vs { get; }

    /// <summary>True if the points form curves in both directions.</summary>
    public bool IsRectangular { get; }

    /// <summary>Mean length of the curves along u in millimeters.</summary>
    public double LengthU { get; }

    /// <summary>Mean length across the curves in millimeters.</summary>
    public double LengthV { get; }

    public double[] Us => CurveUs.MaxBy(u => u.Length)!;

    /// <summary>The points of a rectangular grid, v varying fastest.</summary>
    public Point3[] ByV()
    {
        var points = new Point3[Us.Length * Vs.Length];
        for (var k = 0; k < points.Length; k++)
        {
            points[k] = Curves[k % Vs.Length][k / Vs.Length];
        }

        return points;
    }

    /// <summary>All points curve by curve, each with its parameters.</summary>
    public (Point3[] Points, double[] Us, double[] Vs) Scattered() => (
        [.. Curves.SelectMany(c => c)],
        [.. CurveUs.SelectMany(u => u)],
        [.. Curves.SelectMany((c, j) => Enumerable.Repeat(Vs[j], c.Length))]);

    /// <summary>Assigns parameters to a grid.</summary>
    /// <exception cref="GeometryException">There are fewer than two curves, or a curve has fewer than two points; neighbors coincide; or a
    /// coordinate is not finite.</exception>
    public static FitGrid Of(PointGrid grid)
    {
        if (grid.Curves.Count < 2 || grid.Curves.Any(c => c.Count < 2))
        {
            throw new GeometryException(
                GeometryError.TooFewPoints,
                $"{ReportNumber.Count(grid.Curves.Count, "curve")} with {ReportNumber.Count(grid.Points.Count(), "point")}; "
                    + $"a surface needs at least two curves with at least two "
                    + $"points each");
        }

        Point3[][] curves = [.. grid.Curves.Select(c => c.Select(p => p.Position).ToArray())];
        return grid.IsRectangular ? Rectangular(curves) : Ragged(curves);
    }

    private static FitGrid Rectangular(Point3[][] curves)
    {
        var (count, lines) = (curves[0].Length, curves.Length);
        var points = new Point3[count * lines];
        for (var k = 0; k < points.Length; k++)
        {
            points[k] = curves[k % lines][k / lines];
        }

        var columns = Columns(curves);
        var (us, vs) = SplineParameters.OfGrid(Flat([.. curves, .. columns])(points), count, lines);
        return new(curves, [.. curves.Select(_ => us)], vs, true, MeanLength(curves), MeanLength(columns));
    }

    private static FitGrid Ragged(Point3[][] curves)
    {
        var flat = Flat(curves);
        double[][] us = [.. curves.Select(c => SplineParameters.ChordLength(flat(c)))];
        Point3[][] evenly = [
            .. curves.Select((c, j) => SplineCurveFit.Interpolate(c, us[j])).Select(
                s => Enumerable.Range(0, Places).Select(k => s.PointAt(k / (Places - 1.0))).ToArray())];
        var across = Columns(evenly);
        var vs = SplineParameters.OfGrid(Flat([.. evenly, .. across])(across.SelectMany(c => c).ToArray()), Places, curves.Length).V;
        return new(curves, us, vs, false, MeanLength(curves), MeanLength(across));
    }

    /// <summary>The projection for the parameters: along the axis that the surface faces, or none.</summary>
    private static Func<Point3[], Point3[]> Flat(Point3[][] lines)
    {
        var (x, y, z) = (0.0, 0.0, 0.0);
        for (var k = 1; k < lines.Length; k++)
        {
            // Twice the area between two lines, from the diagonals of their ends.
            var area = (lines[k][^1] - lines[k - 1][0]).Cross(lines[k][0] - lines[k - 1][^1]);
            (x, y, z) = (x + Math.Abs(area.X), y + Math.Abs(area.Y), z + Math.Abs(area.Z));
        }

        Func<Point3, Point3> drop = z >= x && z >= y ? p => p with { Z = 0 } : y >= x ? p => p with { Y = 0 } : p => p with { X = 0 };
        var isFlat = lines.All(l => l.Zip(l.Skip(1), (a, b) => (drop(b) - drop(a)).Length >= (b - a).Length / 2).All(far => far));
        return isFlat ? points => Array.ConvertAll(points, p => drop(p)) : points => points;
    }

    private static Point3[][] Columns(Point3[][] curves) =>
        [.. Enumerable.Range(0, curves[0].Length).Select(i => curves.Select(c => c[i]).ToArray())];

    private static double MeanLength(Point3[][] lines) => lines.Average(l => l.Zip(l.Skip(1), (a, b) => (b - a).Length).Sum());
}
