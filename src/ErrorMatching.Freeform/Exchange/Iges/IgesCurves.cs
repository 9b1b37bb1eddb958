using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads curves of an IGES file as B-splines: 126, lines 110, arcs 100, ellipses 104, polylines 106, composites 102.</summary>
/// <param name="file">The file.</param>
internal sealed class IgesCurves(IgesFile file)
{
    private const double FullTurn = 1e-9;

    private int _count;
    private long _poles;

    /// <summary>Returns the curves of an entity in order, in space.</summary>
    /// <param name="entity">The entity.</param>
    /// <param name="outer">Transform of the parent entity.</param>
    public IEnumerable<SplineCurve> InSpace(IgesEntity entity, IgesTransform outer) => Read(entity, outer, file.MillimetersPerUnit, 0);

    /// <summary>Returns the curves of an entity in order, in the parameters of a surface, which have no unit.</summary>
    /// <param name="entity">The entity.</param>
    public IEnumerable<SplineCurve> OfParameters(IgesEntity entity) => Read(entity, IgesTransform.Identity, 1, 0);

    /// <summary>Returns the only curve of an entity, in space.</summary>
    /// <exception cref="InputException">The entity is a chain of curves, or not a supported curve.</exception>
    public SplineCurve One(IgesEntity entity, IgesTransform outer) => InSpace(entity, outer).ToList() is [var only]
        ? only
        : throw file.Fail("not-read", $"{entity} joins several curves; one is expected of which a surface is made", entity.Line);

    private List<SplineCurve> Read(IgesEntity entity, IgesTransform outer, double scale, int depth)
    {
        if (depth > ExchangeLimits.MaxDepth || ++_count > ExchangeLimits.MaxCurves)
        {
            throw file.Fail(
                "too-deep",
                $"{entity}: curves that refer to one another deeper than {ExchangeLimits.MaxDepth}, or more than "
                    + $"{ExchangeLimits.MaxCurves} of them",
                entity.Line);
        }

        var map = outer.After(IgesTransform.Of(file, entity));
        var parameters = file.ParametersOf(entity);
        try
        {
            List<SplineCurve> read = entity.Type switch
            {
                100 => [Arc(parameters, map, scale)],
                102 => Chain(entity, parameters, map, scale, depth),
                104 => [Ellipse(parameters, map, scale)],
                106 => [Polyline(entity, parameters, map, scale)],
                110 => [Line(parameters, map, scale)],
                126 => [Spline(parameters, map, scale)],
                _ =>
                    throw file.Fail(
                        "not-read",
                        $"{entity} as a curve: 100, 102, 104 (ellipses), 106, 110 and 126 are read. Export curves as B-splines (126)",
                        entity.Line),
            };
            _poles += entity.Type == 102 ? 0 : read[0].Poles.Length;
            return _poles <= ExchangeLimits.MaxPoles
                ? read
                : throw file.Fail("too-large", $"{entity}: curves of more than {ExchangeLimits.MaxPoles} poles", entity.Line);
        }
        catch (GeometryException e)
        {
            throw file.Fail("bad-curve", $"{entity}: {e.Message}", entity.Line);
        }
    }

    private List<SplineCurve> Chain(IgesEntity entity, IgesParameters parameters, IgesTransform map, double scale, int depth)
    {
        var count = parameters.Int("the number of curves", 1, ExchangeLimits.MaxCurves);
        parameters.Need(count, "the curves");
        var pointers = new int[count];
        for (var i = 0; i < count; i++)
        {
            pointers[i] = parameters.Int("a curve");
        }

        var curves = new List<SplineCurve>();
        foreach (var pointer in pointers)
        {
            // A point (116) may mark a place between curves.
            var part = file.At(pointer, entity, "a curve");
            if (part.Type != 116)
            {
                curves.AddRange(Read(part, map, scale, depth + 1));
            }
        }

        return curves;
    }

    private static SplineCurve Line(IgesParameters parameters, IgesTransform map, double scale)
    {
        var p = parameters.Reals("the ends of the line", 6);
        return Polygon([map.Map(new(p[0], p[1], p[2]), scale), map.Map(new(p[3], p[4], p[5]), scale)]);
    }

    // Counterclockwise in its plane; a full circle if start and end coincide.
    private static SplineCurve Arc(IgesParameters parameters, IgesTransform map, double scale)
    {
        var p = parameters.Reals("height, center, start and end of the arc", 7);
        var (x, y) = (p[3] - p[1], p[4] - p[2]);
        var radius = Math.Sqrt((x * x) + (y * y));
        var sweep = Elementary.Atan2((x * (p[6] - p[2])) - (y * (p[5] - p[1])), (x * (p[5] - p[1])) + (y * (p[6] - p[2])));
        if (!(radius > 0))
        {
            throw parameters.Fail("bad-curve", "an arc of radius 0");
        }

        return Mapped(
            SplineArc.Of(new(p[1], p[2], p[0]), new(x, y, 0), new(-y, x, 0), 0, sweep > FullTurn ? sweep : sweep + Math.Tau), map, scale);
    }

    // a x^2 + b x y + c y^2 + d x + e y + f = 0 at a height. The axes are those of the matrix ((a, b/2), (b/2, c)).
    private static SplineCurve Ellipse(IgesParameters parameters, IgesTransform map, double scale)
    {
        var p = parameters.Reals("coefficients, height, start and end of the conic", 11);
        var (a, b, c, d, e, f) = (p[0], p[1], p[2], p[3], p[4], p[5]);
        var det = (4 * a * c) - (b * b);
        if (!(det > 1e-12 * ((a * a) + (c * c))))
        {
            throw parameters.Fail("not-read", "a parabola or hyperbola, which is not read: export curves as B-splines (126)");
        }

        var (x0, y0) = (((b * e) - (2 * c * d)) / det, ((b * d) - (2 * a * e)) / det);
        var level = -(f + (((d * x0) + (e * y0)) / 2));
        var (sin, cos) = Elementary.SinCos(0.5 * Elementary.Atan2(b, a - c));
        var (along, across) = (
            level / ((a * cos * cos) + (b * cos * sin) + (c * sin * sin)), level / ((a * sin * sin) - (b * cos * sin) + (c * cos * cos)));
        if (!(along > 0 && across > 0))
        {
            throw parameters.Fail("bad-curve", "a conic without points");
        }

        var (first, second) = (Math.Sqrt(along), Math.Sqrt(across));
        double Angle(double x, double y) =>
            Elementary.Atan2((-((x - x0) * sin) + ((y - y0) * cos)) / second, (((x - x0) * cos) + ((y - y0) * sin)) / first);
        var (from, to) = (Angle(p[7], p[8]), Angle(p[9], p[10]));
        var sweep = to - from;
        sweep -= Math.Tau * Math.Floor(sweep / Math.Tau);
        return Mapped(
            SplineArc.Of(
                new(x0, y0, p[6]),
                new(first * cos, first * sin, 0),
                new(-second * sin, second * cos, 0),
                from,
                from + (sweep > FullTurn ? sweep : Math.Tau)),
            map,
            scale);
    }

    private static SplineCurve Mapped(SplineCurve curve, IgesTransform map, double scale) =>
        new(curve.Knots, curve.Poles.ToArray().Select(q => map.Map(new(q.X, q.Y, q.Z), scale)).ToArray(), curve.Weights);

    private SplineCurve Polyline(IgesEntity entity, IgesParameters parameters, IgesTransform map, double scale)
    {
        var flat = parameters.Int("the kind of the points", 1, 2) == 1;
        var count = parameters.Int("the number of points", 2, ExchangeLimits.MaxLoopPoints);
        var height = flat ? parameters.Real("the height") : 0;
        if (entity.Form is not (11 or 12 or 63))
        {
            throw file.Fail("not-read", $"{entity} of form {entity.Form} as a curve; forms 11, 12 and 63 are polylines", entity.Line);
        }

        var points = new List<Point3>();
        parameters.Need(count * (flat ? 2L : 3L), "the points");
        for (var i = 0; i < count; i++)
        {
            points.Add(map.Map(
                new(parameters.Real("a point"), parameters.Real("a point"), flat ? height : parameters.Real("a point")), scale));
        }

        return Polygon(points);
    }

    private static SplineCurve Spline(IgesParameters parameters, IgesTransform map, double scale)
    {
        var (k, m) = (parameters.Int("K", 1, ExchangeLimits.MaxPoles), parameters.Int("M", 1, KnotVector.MaxDegree));
        for (var i = 1; i <= 4; i++)
        {
            parameters.Int($"PROP{i}");
        }

        var knots = new KnotVector(m, parameters.Reals("the knots", k + m + 2));
        var weights = parameters.Reals("the weights", k + 1);
        parameters.Need(3L * (k + 1), "the poles");
        var poles = new Point3[k + 1];
        for (var i = 0; i <= k; i++)
        {
            poles[i] = map.Map(new(parameters.Real("a pole"), parameters.Real("a pole"), parameters.Real("a pole")), scale);
        }

        var curve = new SplineCurve(knots, poles, weights);
        if (parameters.Left < 2)
        {
            return curve;
        }

        var (from, to) = (Math.Max(parameters.Real("V(0)"), knots.Start), Math.Min(parameters.Real("V(1)"), knots.End));
        return from < to && (from > knots.Start || to < knots.End) ? curve.Between(from, to) : curve;
    }

    // Merges consecutive points at the same place.
    private static SplineCurve Polygon(List<Point3> points) =>
        new(KnotVector.Clamped(1, Enumerable.Range(0, points.Count).Select(i => (double)i).ToArray()), points.ToArray());
}
