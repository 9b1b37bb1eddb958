using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the B-spline surfaces of STEP: with knots, rational, Bezier (ISO 10303-42, b_spline_surface and its subtypes).</summary>
internal static class StepSplineSurface
{
    /// <summary>Reads the surface of an instance in millimeters; null if it is not a B-spline surface.</summary>
    /// <exception cref="InputException">The instance is broken.</exception>
    public static SplineSurface? Read(StepInstance instance, double millimetersPerUnit)
    {
        // A simple instance lists the attributes of its supertypes first, starting with the name. A complex instance lists the attributes
        // of each type separately.
        var simple = instance.Records is [var only] && only.Keyword is "B_SPLINE_SURFACE_WITH_KNOTS" or "BEZIER_SURFACE"
            ? instance.Records[0]
            : null;
        var shape = simple ?? instance.Find("B_SPLINE_SURFACE");
        if (shape is null || (simple is null && instance.Records.Count == 1))
        {
            return null;
        }

        var first = simple is null ? 0 : 1;
        var (degreeU, degreeV) = (shape.Int(first, 1, KnotVector.MaxDegree), shape.Int(first + 1, 1, KnotVector.MaxDegree));
        var rows = shape.List(first + 2);
        var countV = rows is [{ Kind: StepValueKind.List, Items.Count: var n }, ..]
            ? n
            : throw shape.Fail("bad-value", "no lists of poles; rows of references to points are expected");
        if ((long)rows.Count * countV > ExchangeLimits.MaxPoles || rows.Any(r => r.Kind != StepValueKind.List || r.Items.Count != countV))
        {
            throw shape.Fail("bad-value", $"rows of poles of different lengths, or more than {ExchangeLimits.MaxPoles} poles");
        }

        var poles = new Point3[rows.Count * countV];
        for (var i = 0; i < poles.Length; i++)
        {
            var p = shape.Coordinates(rows[i / countV].Items[i % countV], first + 2, "CARTESIAN_POINT") * millimetersPerUnit;
            poles[i] = new(p.X, p.Y, p.Z);
        }

        var knots = simple is { Keyword: "B_SPLINE_SURFACE_WITH_KNOTS" } ? simple : instance.Find("B_SPLINE_SURFACE_WITH_KNOTS");
        var own = knots == simple ? 8 : 0;
        try
        {
            var (u, v) = knots is not null ? (StepKnots.Of(knots, degreeU, own, own + 2), StepKnots.Of(knots, degreeV, own + 1, own + 3))
                : instance.Find("BEZIER_SURFACE") is not null ? (KnotVector.Clamped(degreeU, [0, 1]), KnotVector.Clamped(degreeV, [0, 1]))
                : throw shape.Fail(
                    "not-read", $"a B-spline surface of the form {instance.Keyword}; B_SPLINE_SURFACE_WITH_KNOTS is expected");
            return new(u, v, poles, Weights(instance, countV, poles.Length));
        }
        catch (GeometryException e)
        {
            throw shape.Fail("bad-surface", e.Message);
        }
    }

    private static double[] Weights(StepInstance instance, int countV, int count)
    {
        if (instance.Find("RATIONAL_B_SPLINE_SURFACE") is not { } rational)
        {
            return [];
        }

        var weights = new List<double>();
        foreach (var row in rational.List(0))
        {
            if (row.Kind != StepValueKind.List || row.Items.Count != countV || weights.Count >= count)
            {
                throw rational.Fail("bad-value", "weights that are not in rows; rows as of the poles are expected");
            }

            weights.AddRange(rational.Reals(row.Items, 0));
        }

        return weights.Count == count
            ? [.. weights]
            : throw rational.Fail("bad-value", $"{weights.Count} weights for {count} poles; one for each is expected");
    }
}
