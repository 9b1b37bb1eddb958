using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Converts the models of a grid to a B-spline surface: exactly if splines, otherwise within <see cref="ToleranceMm"/>.</summary>
internal static class ModelSurface
{
    /// <summary>Largest distance of a coordinate from its model, in millimeters: a thousandth of a micrometer.</summary>
    public const double ToleranceMm = 1e-6;

    private const int MostPieces = 64;

    public static SplineSurface Fit(PlacedGrid grid, FieldModel[] models)
    {
        if (Array.TrueForAll(models, m => m.IsSpline))
        {
            return Through(grid, models, Knots(models, 1, alongU: true), Knots(models, 1, alongU: false));
        }

        var (piecesU, piecesV) = (Pieces(models, alongU: true), Pieces(models, alongU: false));
        while (true)
        {
            var surface = Through(grid, models, Knots(models, piecesU, alongU: true), Knots(models, piecesV, alongU: false));
            if ((piecesU >= MostPieces && piecesV >= MostPieces) || Farthest(grid, models, surface) <= ToleranceMm)
            {
                return surface;
            }

            (piecesU, piecesV) = (More(piecesU), More(piecesV));
        }
    }

    private static int More(int pieces) => Math.Min(MostPieces, (pieces * 4 / 3) + 1);

    /// <summary>Number of pieces that a spline needs along one direction, checked on a few cross lines.</summary>
    private static int Pieces(FieldModel[] models, bool alongU)
    {
        ReadOnlySpan<double> lines = [-0.9, -0.35, 0.2, 0.75];
        for (var pieces = 4; ; pieces = More(pieces))
        {
            var knots = Knots(models, pieces, alongU);
            var worst = 0.0;
            foreach (var model in models)
            {
                foreach (var line in lines)
                {
                    worst = Math.Max(worst, Miss(knots, t => alongU ? model.At(t, line) : model.At(line, t)));
                }
            }

            if (worst <= ToleranceMm / 4 || pieces >= MostPieces)
            {
                return pieces;
            }
        }
    }

    private static double Miss(KnotVector knots, Func<double, double> function)
    {
        var places = Greville(knots);
        var curve = SplineCurveFit.LeastSquares(Array.ConvertAll(places, t => new Point3(function(t), 0, 0)), places, knots);
        return Between(places).Max(t => Math.Abs(curve.PointAt(t).X - function(t)));
    }

    private static double Farthest(PlacedGrid grid, FieldModel[] models, SplineSurface surface)
    {
        var (us, vs) = (Between(Greville(surface.KnotsU)), Between(Greville(surface.KnotsV)));
        return us.Max(u => vs.Max(v => (surface.PointAt(u, v) - Place(grid, models, grid.U.ToUnit(u), grid.V.ToUnit(v))).Length));
    }

    /// <summary>Interpolates the models at as many places as the surface has poles.</summary>
    private static SplineSurface Through(PlacedGrid grid, FieldModel[] models, KnotVector knotsU, KnotVector knotsV)
    {
        var (us, vs) = (Greville(knotsU), Greville(knotsV));
        var points = new Point3[us.Length * vs.Length];
        for (var k = 0; k < points.Length; k++)
        {
            points[k] = Place(grid, models, us[k / vs.Length], vs[k % vs.Length]);
        }

        var fitted = SplineSurfaceFit.LeastSquares(points, us, vs, knotsU, knotsV);
        return new(Scaled(knotsU, grid.U), Scaled(knotsV, grid.V), fitted.Poles);
    }

    private static Point3 Place(PlacedGrid grid, FieldModel[] models, double u, double v)
    {
        var place = grid.Base.Middle + (grid.Base.AlongU * u) + (grid.Base.AlongV * v);
        for (var c = 0; c < models.Length; c++)
        {
            place += grid.Directions[c] * models[c].At(u, v);
        }

        return new(place.X, place.Y, place.Z);
    }

    /// <summary>Knots from -1 to 1 where the models' pieces meet, and more between them to reach the required number of pieces.</summary>
    private static KnotVector Knots(FieldModel[] models, int pieces, bool alongU)
    {
        var degree = models.Max(m => alongU ? m.DegreeU : m.DegreeV);
        var joins = models.SelectMany(m => alongU ? m.JoinsU : m.JoinsV)
            .GroupBy(j => j.At, j => j.Smoothness)
            .OrderBy(g => g.Key)
            .Select(g => (At: g.Key, Times: degree - g.Min()))
            .ToList();
        double[] ends = [-1, .. joins.Select(j => j.At), 1];
        var values = new List<double>(Enumerable.Repeat(-1.0, degree + 1));
        for (var k = 0; k + 1 < ends.Length; k++)
        {
            var parts = Math.Max(1, (int)Math.Ceiling(pieces * (ends[k + 1] - ends[k]) / 2));
            values.AddRange(Enumerable.Range(1, parts - 1).Select(i => ends[k] + ((ends[k + 1] - ends[k]) * i / parts)));
            values.AddRange(Enumerable.Repeat(ends[k + 1], k < joins.Count ? joins[k].Times : degree + 1));
        }

        return new(degree, values.ToArray());
    }

    private static KnotVector Scaled(KnotVector knots, ParameterRange range)
    {
        var values = knots.Values.ToArray();
        return new(knots.Degree, Array.ConvertAll(values, range.FromUnit));
    }

    private static double[] Greville(KnotVector knots) => [.. Enumerable.Range(0, knots.PoleCount).Select(knots.Greville)];

    private static double[] Between(double[] places) => [.. places.Zip(places.Skip(1), (a, b) => (a + b) / 2)];
}
