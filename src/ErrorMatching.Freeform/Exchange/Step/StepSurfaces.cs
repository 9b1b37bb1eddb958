using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The surfaces of a STEP file.</summary>
internal sealed class StepSurfaces
{
    private readonly StepFile _file;
    private readonly IReadOnlyList<StepItem> _items;

    /// <summary>Finds the surfaces of a file.</summary>
    /// <exception cref="InputException">There are no surfaces.</exception>
    public StepSurfaces(StepFile file)
    {
        _file = file;
        _items = StepItems.Of(file);
        if (_items.Count == 0)
        {
            throw InputException.At(
                "no-surface",
                file.Name,
                "no face and no surface in any representation: is it an assembly without its parts, or a wire frame? Export the surface "
                    + "or the solid itself (AP203, AP214, AP242)");
        }

        StepAssembly.ThrowIfMoved(file);
    }

    /// <summary>Reads a surface by name or number.</summary>
    /// <param name="entity">Name or number from 1; null for the only one.</param>
    public ReadSurface Read(string? entity)
    {
        var names = _items.Select(NameOf).ToList();
        return Read(SurfaceChoice.Choose(_file.Name, names, entity, Read));

        ReadSurface Read(int index) => StepFace.Read(_items[index], SurfaceChoice.NameOf(names, index));
    }

    // An unnamed face takes the name of its surface.
    private static string NameOf(StepItem item)
    {
        var name = item.Instance.Name;
        return name.Length > 0 || !StepFace.IsFace(item.Instance) ? name : item.Instance.Records[0].Instance(2).Name;
    }
}
