using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The surfaces of an IGES file: B-splines (128) and surfaces that convert exactly (bounded 108, 118, 120, 122), untrimmed or
/// trimmed (144, 143).</summary>
internal sealed class IgesSurfaces
{
    private readonly IgesFile _file;
    private readonly IgesCurves _curves;
    private readonly IReadOnlyList<IgesEntity> _candidates;

    /// <summary>Finds the surfaces of a file.</summary>
    /// <exception cref="InputException">There are no surfaces.</exception>
    public IgesSurfaces(IgesFile file)
    {
        (_file, _curves) = (file, new(file));
        _candidates = [.. file.Entities.Where(e => IsSurface(e) && !e.Dependent && !e.Blanked)];
        if (_candidates.Count == 0)
        {
            throw None();
        }
    }

    /// <summary>Reads a surface by name or number.</summary>
    /// <param name="entity">Name or number from 1; null for the only one.</param>
    /// <exception cref="InputException">The surface does not exist, is broken, or is of an unsupported kind.</exception>
    public ReadSurface Read(string? entity)
    {
        var names = _candidates.Select(c => IgesName.Of(_file, c)).ToList();
        return Read(names, SurfaceChoice.Choose(_file.Name, names, entity, i => Read(names, i)));
    }

    private ReadSurface Read(List<string> names, int index)
    {
        var chosen = _candidates[index];
        IgesPlacedParts.ThrowIfMoved(_file, chosen);
        var (spline, region) = chosen.Type switch
        {
            144 or 143 => Trimmed(chosen),
            108 => Plane(chosen, IgesTransform.Identity, null, [IgesPlane.BoundaryOf(_file, chosen)]),
            _ => (Spline(chosen, IgesTransform.Identity), SurfaceRegion.Whole),
        };
        return new(SurfaceChoice.NameOf(names, index), spline, region);
    }

    private (SplineSurface Spline, SurfaceRegion Region) Trimmed(IgesEntity entity)
    {
        var map = IgesTransform.Of(_file, entity);
        var parameters = _file.ParametersOf(entity);
        int basis;
        var pointers = new List<int>();
        var bordered = false;
        if (entity.Type == 144)
        {
            basis = parameters.Int("the surface");
            bordered = parameters.Int("whether it has an outer boundary", 0, 1) == 0;
            var holes = parameters.Int("the number of inner boundaries", 0, ExchangeLimits.MaxCurves);
            var outer = parameters.Int("the outer boundary");
            if (!bordered)
            {
                pointers.Add(outer);
            }

            Pointers(parameters, holes, pointers);
        }
        else
        {
            parameters.Int("the kind of the boundaries");
            basis = parameters.Int("the surface");
            Pointers(parameters, parameters.Int("the number of boundaries", 1, ExchangeLimits.MaxCurves), pointers);
        }

        var surface = _file.At(basis, entity, "the surface");
        if (surface.Type == 108)
        {
            return Plane(surface, map, entity, pointers);
        }

        var spline = Spline(surface, map);
        var tracer = new RegionTracer(SurfaceMap.Of(spline), Failing(entity));
        Trace(entity, map, surface.Type == 128, pointers, tracer);
        List<IReadOnlyList<Point2>> loops = bordered && pointers.Count > 0 ? [RegionLimits.Border(spline)] : [];
        loops.AddRange(tracer.Loops);
        return (spline, RegionLimits.Of(spline, loops, Failing(entity)));
    }

    private (SplineSurface Spline, SurfaceRegion Region) Plane(
        IgesEntity plane, IgesTransform outer, IgesEntity? trimmed, List<int> pointers)
    {
        var patch = IgesPlane.Read(_file, plane, outer);
        var fail = Failing(trimmed ?? plane);
        var tracer = new RegionTracer(patch.Map, fail);
        if (trimmed is not null)
        {
            Trace(trimmed, outer, hasParameters: false, pointers, tracer);
        }
        else
        {
            foreach (var curve in _curves.InSpace(
                _file.At(pointers[0], plane, "the closed curve"), outer.After(IgesTransform.Of(_file, plane))))
            {
                tracer.Space(curve);
            }

            tracer.Close();
        }

        return patch.Inside(tracer.Loops, fail);
    }

    private void Trace(IgesEntity entity, IgesTransform map, bool hasParameters, List<int> pointers, RegionTracer tracer)
    {
        var limits = new IgesLimits(_file, _curves);
        foreach (var pointer in pointers)
        {
            limits.Trace(_file.At(pointer, entity, "a boundary"), map, hasParameters, tracer);
        }
    }

    private SplineSurface Spline(IgesEntity entity, IgesTransform outer) => entity.Type switch
    {
        128 => IgesSplineSurface.Read(_file, entity, outer),
        118 or 120 or 122 => new IgesSweptSurfaces(_file, _curves).Read(entity, outer),
        _ =>
            throw _file.Fail(
                "not-read",
                $"{entity}: this kind of surface is not read; 128 is, 144 and 143 with it, and 108, 118, 120 and 122 where they are "
                    + $"exactly a B-spline. Export surfaces as B-splines (128)",
                entity.Line),
    };

    private Func<string, string, InputException> Failing(IgesEntity entity) =>
        (code, problem) => _file.Fail(code, $"{entity}: {problem}", entity.Line);

    private static void Pointers(IgesParameters parameters, int count, List<int> pointers)
    {
        parameters.Need(count, "the boundaries");
        for (var i = 0; i < count; i++)
        {
            pointers.Add(parameters.Int("a boundary"));
        }
    }

    // An unbounded plane is a drawing aid, not a surface of the piece.
    private static bool IsSurface(IgesEntity entity) => entity.Type switch
    {
        108 => entity.Form == 1,
        114 or 118 or 120 or 122 or 128 or 140 or 143 or 144 or 190 or 192 or 194 or 196 or 198 => true,
        _ => false,
    };

    private InputException None()
    {
        var found = _file.Entities.GroupBy(e => e.Type)
            .OrderBy(g => g.Key)
            .Take(20)
            .Select(g => $"{g.Key} ({g.Count()}, first at D{g.First().Sequence})");
        return _file.Fail(
            "no-surface",
            $"no surface that stands by itself and is shown; 128 or 144 is expected. Faces of solids (510) and parts placed elsewhere "
                + $"(408) are not read: export surfaces. The file has entities {string.Join(", ", found)}",
            _file.Entities[0].Line);
    }
}
