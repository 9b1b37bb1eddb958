using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Detects surfaces that a file displays at another place than they are defined: members of a subfigure (308) that an instance
/// (408) moves or scales.</summary>
internal static class IgesPlacedParts
{
    private const int MostMembers = 100_000;

    /// <summary>Refuses a displaced surface.</summary>
    /// <param name="file">The file.</param>
    /// <param name="surface">The surface that was chosen.</param>
    /// <exception cref="InputException">The surface is displaced, or an entity that could displace it is broken.</exception>
    public static void ThrowIfMoved(IgesFile file, IgesEntity surface)
    {
        var definitions = file.Entities.Where(e => e.Type == 308 && Members(file, e).Contains(surface.Sequence))
            .Select(e => e.Sequence)
            .ToHashSet();
        foreach (var instance in definitions.Count == 0 ? [] : file.Entities.Where(e => e.Type == 408))
        {
            var parameters = file.ParametersOf(instance);
            var definition = parameters.Int("the subfigure");
            var (x, y, z) = (parameters.Real("the place"), parameters.Real("the place"), parameters.Real("the place"));
            var scale = parameters.Left == 0 ? 1 : parameters.Real("the scale");
            if (definitions.Contains(definition) && ((x, y, z) != (0, 0, 0) || scale is not (0 or 1) || instance.Transform != 0))
            {
                throw file.Fail(
                    "assembly",
                    $"{surface} is a member of the subfigure at D{definition}, which {instance} moves or scales; that is not followed: "
                        + $"export the part by itself, in the coordinates in which it is cut",
                    surface.Line);
            }
        }
    }

    private static List<int> Members(IgesFile file, IgesEntity definition)
    {
        var parameters = file.ParametersOf(definition);
        parameters.Int("the depth");
        parameters.Text("the name");
        var count = parameters.Int("the number of members", 0, MostMembers);
        parameters.Need(count, "the members");
        var members = new List<int>();
        for (var i = 0; i < count; i++)
        {
            members.Add(parameters.Int("a member"));
        }

        return members;
    }
}
