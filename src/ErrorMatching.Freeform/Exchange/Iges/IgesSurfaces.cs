using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The surfaces of an IGES file.</summary>
internal sealed class IgesSurfaces
{
    private readonly IgesFile _file;
    private readonly IReadOnlyList<IgesEntity> _candidates;

    /// <summary>Finds the surfaces of a file.</summary>
    /// <exception cref="FreeformException">There is none that is read.</exception>
    public IgesSurfaces(IgesFile file)
    {
        _file = file;
        _candidates = [.. file.Entities.Where(e => IsSurface(e.Type) && !e.Dependent && !e.Blanked)];
        if (_candidates.Count == 0)
        {
            throw None();
        }
    }

    /// <summary>The surface of a name or number.</summary>
    /// <param name="entity">Name or number from 1; null for the only one.</param>
    public ReadSurface Read(string? entity)
    {
        var names = _candidates.Select(c => IgesName.Of(_file, c)).ToList();
        var index = SurfaceChoice.Of(_file.Name, names, entity);
        var chosen = _candidates[index];
        return new(SurfaceChoice.NameOf(names, index), IgesSplineSurface.Read(_file, chosen, IgesTransform.Identity), SurfaceRegion.Whole);
    }

    private static bool IsSurface(int type) => type is 128;

    private FreeformException None()
    {
        var found = _file.Entities.GroupBy(e => e.Type).OrderBy(g => g.Key).Take(20).Select(g => $"{g.Key} ({g.Count()}, first at D{g.First().Sequence})");
        return _file.Fail("no-surface", $"no surface that is read: 128 is. It has entities of type {string.Join(", ", found)}", _file.Entities[0].Line);
    }
}
