using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Reads the boundaries of a surface in an IGES file: curves on a surface (142) and boundaries (141).</summary>
/// <param name="file">The file.</param>
/// <param name="curves">Its curves.</param>
internal sealed class IgesLimits(IgesFile file, IgesCurves curves)
{
    private const int PreferSpace = 2;

    /// <summary>Follows a closed boundary.</summary>
    /// <param name="boundary">An entity of type 142 or 141.</param>
    /// <param name="outer">Transform of the parent entity.</param>
    /// <param name="hasParameters">False if the surface's parameters differ from those of the file, so that only curves in space define
    /// the boundary.</param>
    /// <param name="tracer">Receives the loop.</param>
    public void Trace(IgesEntity boundary, IgesTransform outer, bool hasParameters, RegionTracer tracer)
    {
        var map = outer.After(IgesTransform.Of(file, boundary));
        switch (boundary.Type)
        {
            case 142:
                CurveOnSurface(boundary, map, hasParameters, tracer);
                break;
            case 141:
                Boundary(boundary, map, hasParameters, tracer);
                break;
            default:
                throw file.Fail("not-read", $"{boundary} as the boundary of a surface; 142 or 141 is expected", boundary.Line);
        }

        tracer.Close();
    }

    private void CurveOnSurface(IgesEntity boundary, IgesTransform map, bool hasParameters, RegionTracer tracer)
    {
        var parameters = file.ParametersOf(boundary);
        parameters.Int("how the curve was made");
        parameters.Int("the surface");
        var (flat, space, preferred) = (
            parameters.Int("the curve of parameters"), parameters.Int("the curve in space"), parameters.Int("the preferred curve", 0, 3));
        if (flat != 0 && hasParameters && !(preferred == PreferSpace && space != 0))
        {
            Follow(curves.OfParameters(file.At(flat, boundary, "the curve of parameters")), tracer.Parameters);
            return;
        }

        if (space == 0)
        {
            throw file.Fail(
                "not-read",
                $"{boundary} has no curve in space, and its curve of parameters is none of a B-spline surface. Export the surface as a "
                    + $"B-spline (128)",
                boundary.Line);
        }

        Follow(curves.InSpace(file.At(space, boundary, "the curve in space"), map), tracer.Space);
    }

    private void Boundary(IgesEntity boundary, IgesTransform map, bool hasParameters, RegionTracer tracer)
    {
        var parameters = file.ParametersOf(boundary);
        var both = parameters.Int("the kind of the boundary", 0, 1) == 1;
        var preferred = parameters.Int("the preferred curves", 0, 3);
        parameters.Int("the surface");
        var count = parameters.Int("the number of curves", 1, ExchangeLimits.MaxCurves);
        for (var i = 0; i < count; i++)
        {
            var (space, sense, flats) = (
                parameters.Int("a curve in space"),
                parameters.Int("its sense", 1, 2),
                parameters.Int("the number of its curves of parameters", 0, ExchangeLimits.MaxCurves));
            var pointers = new List<int>();
            for (var k = 0; k < flats; k++)
            {
                pointers.Add(parameters.Int("a curve of parameters"));
            }

            if (both && flats > 0 && hasParameters && preferred != PreferSpace)
            {
                // These curves already follow the direction of the boundary.
                foreach (var pointer in pointers)
                {
                    Follow(curves.OfParameters(file.At(pointer, boundary, "a curve of parameters")), tracer.Parameters);
                }
            }
            else
            {
                var parts = curves.InSpace(file.At(space, boundary, "a curve in space"), map);
                Follow(sense == 1 ? parts : parts.Reverse().Select(c => c.Reverse()), tracer.Space);
            }
        }
    }

    private static void Follow(IEnumerable<SplineCurve> parts, Action<SplineCurve> along)
    {
        foreach (var part in parts)
        {
            along(part);
        }
    }
}
