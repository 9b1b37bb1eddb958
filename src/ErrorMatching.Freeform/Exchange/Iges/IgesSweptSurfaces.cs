using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads swept surfaces of IGES as exact B-splines: ruled 118, of revolution 120, tabulated cylinder 122.</summary>
/// <param name="file">The file.</param>
/// <param name="curves">Its curves.</param>
internal sealed class IgesSweptSurfaces(IgesFile file, IgesCurves curves)
{
    /// <summary>Reads the surface of an entity in millimeters.</summary>
    /// <param name="entity">An entity of type 118, 120 or 122.</param>
    /// <param name="outer">Transform of the parent entity.</param>
    /// <exception cref="InputException">The entity is broken, or not exactly a B-spline.</exception>
    public SplineSurface Read(IgesEntity entity, IgesTransform outer)
    {
        var map = outer.After(IgesTransform.Of(file, entity));
        var parameters = file.ParametersOf(entity);
        try
        {
            return entity.Type switch
            {
                118 => Ruled(entity, parameters, map),
                120 => Revolved(entity, parameters, map),
                _ => Tabulated(entity, parameters, map),
            };
        }
        catch (GeometryException e)
        {
            throw file.Fail("bad-surface", $"{entity}: {e.Message}", entity.Line);
        }
    }

    private SplineSurface Ruled(IgesEntity entity, IgesParameters parameters, IgesTransform map)
    {
        var (first, second, reversed) = (
            parameters.Int("the first curve"), parameters.Int("the second curve"), parameters.Int("the direction", 0, 1) == 1);
        var rails = new[]
        {
            first,
            second
        }.Select(p => curves.One(file.At(p, entity, "a rail"), map)).Select(c => c.Clamp().Reparametrize(0, 1)).ToArray();
        if (entity.Form != 1 && rails.Any(r => r.Knots.PoleCount != 2))
        {
            throw file.Fail(
                "not-read",
                $"{entity} of form {entity.Form}: its rails are joined by their lengths, which no B-spline does exactly. Export the "
                    + $"surface as a B-spline (128)",
                entity.Line);
        }

        var common = SplineCurve.Compatible([rails[0], reversed ? rails[1].Reverse() : rails[1]]);
        return Between(common[0], common[1]);
    }

    // The directrix, and a copy whose start is at the given point.
    private SplineSurface Tabulated(IgesEntity entity, IgesParameters parameters, IgesTransform map)
    {
        var pointer = parameters.Int("the directrix");
        var end = map.Map(
            new(
                parameters.Real("the end of the generatrix"),
                parameters.Real("the end of the generatrix"),
                parameters.Real("the end of the generatrix")),
            file.MillimetersPerUnit);
        var directrix = curves.One(file.At(pointer, entity, "the directrix"), map).Clamp();
        var by = end - directrix.PointAt(directrix.Knots.Start);
        return Between(directrix, new(directrix.Knots, directrix.Poles.ToArray().Select(p => p + by).ToArray(), directrix.Weights));
    }

    // The NURBS Book, section 8.5: each pole follows an arc about the axis; weights multiply.
    private SplineSurface Revolved(IgesEntity entity, IgesParameters parameters, IgesTransform map)
    {
        var (axisPointer, generatrixPointer, from, to) = (
            parameters.Int("the axis"),
            parameters.Int("the generatrix"),
            parameters.Real("the first angle"),
            parameters.Real("the last angle"));
        if (!(to > from && to - from <= Math.Tau * (1 + 1e-9)))
        {
            throw parameters.Fail("bad-surface", "angles of revolution that do not rise by a turn at most");
        }

        var axis = curves.One(file.At(axisPointer, entity, "the axis"), map);
        var origin = axis.PointAt(axis.Knots.Start);
        var along = (axis.PointAt(axis.Knots.End) - origin).Normalize();
        var generatrix = curves.One(file.At(generatrixPointer, entity, "the generatrix"), map);
        var poles = new List<Point3>();
        var weights = new List<double>();
        KnotVector? knots = null;
        for (var i = 0; i < generatrix.Poles.Length; i++)
        {
            var d = generatrix.Poles[i] - origin;
            var foot = along * d.Dot(along);
            var x = d - foot;
            var center = origin + foot;
            var arc = SplineArc.Of(new(center.X, center.Y, center.Z), x, along.Cross(x), from, to);
            knots ??= arc.Knots;
            poles.AddRange(arc.Poles);
            foreach (var w in arc.Weights.IsEmpty ? Enumerable.Repeat(1.0, arc.Poles.Length).ToArray() : arc.Weights.ToArray())
            {
                weights.Add(w * (generatrix.IsRational ? generatrix.Weights[i] : 1));
            }
        }

        return new(generatrix.Knots, knots!, poles.ToArray(), weights.ToArray());
    }

    private static SplineSurface Between(SplineCurve first, SplineCurve second)
    {
        var poles = new List<Point3>();
        var weights = new List<double>();
        for (var i = 0; i < first.Poles.Length; i++)
        {
            poles.AddRange([first.Poles[i], second.Poles[i]]);
            weights.AddRange([first.IsRational ? first.Weights[i] : 1, second.IsRational ? second.Weights[i] : 1]);
        }

        return new(first.Knots, KnotVector.Clamped(1, [0, 1]), poles.ToArray(), weights.ToArray());
    }
}
