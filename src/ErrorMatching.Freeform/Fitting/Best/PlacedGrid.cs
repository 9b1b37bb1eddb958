using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A grid of points with parameters: heights over a plane, or three coordinates over chord lengths.</summary>
/// <param name="U">Range of the first parameter.</param>
/// <param name="V">Range of the second parameter.</param>
/// <param name="Base">The part known without a fit, linear in the parameters from -1 to 1: the place at the middle, and its change to the
/// end of each parameter.</param>
/// <param name="Directions">The direction of each set of values.</param>
/// <param name="Values">The values over the parameters, one set per direction.</param>
internal sealed record PlacedGrid(
    ParameterRange U, ParameterRange V, (Vector3 Middle, Vector3 AlongU, Vector3 AlongV) Base, Vector3[] Directions, FieldData[] Values)
{
    /// <summary>A direction within this angle (in radians) of an axis is set to the axis, because grids are meant to be straight.</summary>
    private const double Straight = 0.02;

    /// <summary>Largest distance of a rim point inside the parallelogram, as a share of the line spacing.</summary>
    private const double Rim = 0.25;

    /// <summary>Sine of the least angle between the sides of a parallelogram, and between the surface and the height axis.</summary>
    private const double LeastSine = 0.3;

    public static PlacedGrid Of(PointGrid grid) =>
        OverPlane(grid, Largest) ?? OverPlane(grid, normal => normal.Normalize()) ?? OverChords(grid);

    /// <summary>Heights along an axis selected by the mean normal; null if they are not heights or do not fill a parallelogram.</summary>
    private static PlacedGrid? OverPlane(PointGrid grid, Func<Vector3, Vector3> choose)
    {
        var curves = grid.Curves;
        var along = Mean(curves.Select(c => c[^1].Position - c[0].Position));
        var across = Mean([curves[^1][0].Position - curves[0][0].Position, curves[^1][^1].Position - curves[0][^1].Position]);
        var normal = along.Cross(across);
        if (!(normal.Length > LeastSine * along.Length * across.Length))
        {
            return null;
        }

        var axis = choose(normal);
        if (Math.Abs(normal.Dot(axis)) < LeastSine * normal.Length)
        {
            return null;
        }

        var (a, b) = (Flat(along, axis), Flat(across, axis));
        var area = a.Cross(b).Dot(axis);
        if (Math.Abs(area) < LeastSine * a.Length * b.Length)
        {
            return null;
        }

        (a, b) = (a.Normalize(), b.Normalize());
        area = a.Cross(b).Dot(axis);
        var points = grid.Points.ToArray();
        var places = Array.ConvertAll(points, p => new Vector3(p.Position.X, p.Position.Y, p.Position.Z));
        var u = Array.ConvertAll(places, p => p.Cross(b).Dot(axis) / area);
        var v = Array.ConvertAll(places, p => a.Cross(p).Dot(axis) / area);
        var (rangeU, rangeV) = (ParameterRange.Of(u), ParameterRange.Of(v));
        var data = Data(points, u, v, rangeU, rangeV, Array.ConvertAll(places, p => p.Dot(axis)));
        if (!IsUnfolded(data))
        {
            return null;
        }

        var middle = (a * rangeU.FromUnit(0)) + (b * rangeV.FromUnit(0));
        return new(rangeU, rangeV, (middle, a * ((rangeU.High - rangeU.Low) / 2), b * ((rangeV.High - rangeV.Low) / 2)), [axis], [data]);
    }

    private static PlacedGrid OverChords(PointGrid grid)
    {
        var (_, u, v) = FitGrid.Of(grid).Scattered();
        var points = grid.Points.ToArray();
        var range = new ParameterRange(0, 1);
        FieldData Values(Func<Point3, double> of) => Data(points, u, v, range, range, Array.ConvertAll(points, p => of(p.Position)));
        return new(
            range, range, default, [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1)], [Values(p => p.X), Values(p => p.Y), Values(p => p.Z)]);
    }

    private static FieldData Data(
        GridPoint[] points, double[] u, double[] v, ParameterRange rangeU, ParameterRange rangeV, double[] values) =>
        new(
        Array.ConvertAll(points, p => p.I),
        Array.ConvertAll(points, p => p.J),
        Array.ConvertAll(u, rangeU.ToUnit),
        Array.ConvertAll(v, rangeV.ToUnit),
        values);

    /// <summary>True if the points ascend in both directions and the rim points are on the rim of the parallelogram.</summary>
    private static bool IsUnfolded(FieldData data)
    {
        var curves = data.Curves;
        var rimV = Rim * 2 / (curves.Length - 1);
        for (var j = 0; j < curves.Length; j++)
        {
            var curve = curves[j];
            var rimU = Rim * 2 / (curve.Length - 1);
            for (var k = 0; k < curve.Length; k++)
            {
                if ((k > 0 && !(data.U[curve[k]] > data.U[curve[k - 1]]))
                    || (j == 0 && data.V[curve[k]] > -1 + rimV)
                    || (j == curves.Length - 1 && data.V[curve[k]] < 1 - rimV))
                {
                    return false;
                }
            }

            if (data.U[curve[0]] > -1 + rimU
                || data.U[curve[^1]] < 1 - rimU
                || (j > 0 && !(curve.Min(k => data.V[k]) > curves[j - 1].Min(k => data.V[k]))))
            {
                return false;
            }
        }

        return true;
    }

    private static Vector3 Mean(IEnumerable<Vector3> vectors)
    {
        var all = vectors.ToArray();
        return all.Aggregate(Vector3.Zero, (a, b) => a + b) * (1.0 / all.Length);
    }

    private static Vector3 Largest(Vector3 n)
    {
        var (x, y, z) = (Math.Abs(n.X), Math.Abs(n.Y), Math.Abs(n.Z));
        return z >= x && z >= y ? new(0, 0, 1) : x >= y ? new(1, 0, 0) : new(0, 1, 0);
    }

    /// <summary>A direction without its component along the axis, set to a coordinate axis if close to one.</summary>
    private static Vector3 Flat(Vector3 v, Vector3 axis)
    {
        var flat = v - (axis * v.Dot(axis));
        var main = Largest(flat);
        var part = main * flat.Dot(main);
        return (flat - part).Length <= Straight * flat.Length ? part : flat;
    }
}
