using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the rational B-spline surface of IGES (entity 128).</summary>
internal static class IgesSplineSurface
{
    /// <summary>Reads the surface of an entity, in millimeters.</summary>
    /// <param name="file">The file.</param>
    /// <param name="entity">An entity of type 128.</param>
    /// <param name="outer">Transform of the parent entity.</param>
    /// <exception cref="InputException">The entity is broken.</exception>
    public static SplineSurface Read(IgesFile file, IgesEntity entity, IgesTransform outer)
    {
        var map = outer.After(IgesTransform.Of(file, entity));
        var parameters = file.ParametersOf(entity);
        var (k1, k2) = (parameters.Int("K1", 1, ExchangeLimits.MaxPoles), parameters.Int("K2", 1, ExchangeLimits.MaxPoles));
        var (m1, m2) = (parameters.Int("M1", 1, KnotVector.MaxDegree), parameters.Int("M2", 1, KnotVector.MaxDegree));
        for (var i = 1; i <= 5; i++)
        {
            parameters.Int($"PROP{i}");
        }

        parameters.Need((4L * (k1 + 1L) * (k2 + 1L)) + k1 + k2 + m1 + m2 + 4, "knots, weights and poles");
        var knotsU = parameters.Reals("the knots along u", k1 + m1 + 2);
        var knotsV = parameters.Reals("the knots along v", k2 + m2 + 2);
        var weights = new double[(k1 + 1) * (k2 + 1)];
        var poles = new Point3[weights.Length];
        for (var j = 0; j <= k2; j++)
        {
            for (var i = 0; i <= k1; i++)
            {
                weights[(i * (k2 + 1)) + j] = parameters.Real("a weight");
            }
        }

        for (var j = 0; j <= k2; j++)
        {
            for (var i = 0; i <= k1; i++)
            {
                poles[(i * (k2 + 1)) + j] = map.Map(
                    new(parameters.Real("a pole"), parameters.Real("a pole"), parameters.Real("a pole")), file.MillimetersPerUnit);
            }
        }

        try
        {
            return Cut(new(new(m1, knotsU), new(m2, knotsV), poles, weights), parameters);
        }
        catch (GeometryException e)
        {
            throw file.Fail("bad-surface", $"{entity}: {e.Message}", entity.Line);
        }
    }

    // The last parameters define the used part of the knot range, which is nearly always all of it.
    private static SplineSurface Cut(SplineSurface whole, IgesParameters parameters)
    {
        if (parameters.Left < 4)
        {
            return whole;
        }

        var (u, v) = (whole.KnotsU, whole.KnotsV);
        var (u0, u1) = (Math.Max(u.Start, parameters.Real("U(0)")), Math.Min(u.End, parameters.Real("U(1)")));
        var (v0, v1) = (Math.Max(v.Start, parameters.Real("V(0)")), Math.Min(v.End, parameters.Real("V(1)")));
        var all = u0 == u.Start && u1 == u.End && v0 == v.Start && v1 == v.End;
        return all || !(u0 < u1 && v0 < v1) ? whole : whole.Between(u0, u1, v0, v1);
    }
}
