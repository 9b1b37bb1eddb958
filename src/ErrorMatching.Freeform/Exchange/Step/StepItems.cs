using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Finds the surfaces of a STEP file, from its representations through solids and shells down to faces.</summary>
internal sealed class StepItems
{
    private const int MaxItems = 1_000_000;

    private static readonly HashSet<string> Surfaces = new(StringComparer.Ordinal)
    {
        "ADVANCED_FACE", "FACE_SURFACE", "B_SPLINE_SURFACE_WITH_KNOTS", "B_SPLINE_SURFACE", "BEZIER_SURFACE", "UNIFORM_SURFACE",
        "QUASI_UNIFORM_SURFACE", "PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE",
        "SPHERICAL_SURFACE", "TOROIDAL_SURFACE", "SURFACE_OF_REVOLUTION", "SURFACE_OF_LINEAR_EXTRUSION", "OFFSET_SURFACE",
        "RECTANGULAR_TRIMMED_SURFACE", "CURVE_BOUNDED_SURFACE",
    };

    private readonly HashSet<long> _seen = [];
    private readonly List<StepItem> _items = [];
    private readonly double? _unitMm;

    private StepItems(double? unitMm) => _unitMm = unitMm;

    /// <summary>Returns the surfaces in file order.</summary>
    /// <param name="file">The file.</param>
    /// <param name="unitMm">Millimeters per unit, whatever the file says; null to take what it says.</param>
    /// <exception cref="InputException">The file is broken, or places parts in an assembly.</exception>
    public static IReadOnlyList<StepItem> Of(StepFile file, double? unitMm = null)
    {
        var found = new StepItems(unitMm);
        foreach (var instance in file.Where(k => k.EndsWith("REPRESENTATION", StringComparison.Ordinal)))
        {
            if (instance.Records is [{ Values: [_, { Kind: StepValueKind.List }, { Kind: StepValueKind.Reference }, ..] } record])
            {
                foreach (var item in record.Instances(1))
                {
                    found.Visit(item, record, 0, "");
                }
            }
        }

        return found._items;
    }

    /// <summary>Millimeters per unit by what the file itself says where it has its first surface; null if it does not say.</summary>
    public static double? StatedUnit(StepFile file)
    {
        try
        {
            return Of(file) is [var first, ..] ? first.MillimetersPerUnit : null;
        }
        catch (InputException)
        {
            return null;
        }
    }

    private void Visit(StepInstance item, StepRecord representation, int depth, string parents)
    {
        if (!IsContainer(item.Keyword) && !item.Records.Any(r => Surfaces.Contains(r.Keyword)))
        {
            return;
        }

        if (!_seen.Add(item.Id))
        {
            return;
        }

        if (depth > ExchangeLimits.MaxDepth || _seen.Count > MaxItems)
        {
            throw item.Records[0].Fail(
                "too-deep", $"shells refer to one another deeper than {ExchangeLimits.MaxDepth}, or there are more than {MaxItems} faces");
        }

        if (!IsContainer(item.Keyword))
        {
            _items.Add(new(item, _unitMm ?? StepUnit.Millimeters(representation.Instance(2)))
            {
                IsOfSolid = parents is "MANIFOLD_SOLID_BREP/CLOSED_SHELL" or "BREP_WITH_VOIDS/CLOSED_SHELL",
            });
            return;
        }

        foreach (var value in item.Records[0].Values.Skip(1))
        {
            var inside = value.Kind == StepValueKind.List ? value.Items : [value];
            foreach (var part in inside.Where(p => p.Kind == StepValueKind.Reference))
            {
                Visit(
                    item.Records[0].Instance(part, 1),
                    representation,
                    depth + 1,
                    depth == 0 ? item.Keyword : depth == 1 ? $"{parents}/{item.Keyword}" : "");
            }
        }
    }

    private static bool IsContainer(string keyword) =>
        keyword is "SHELL_BASED_SURFACE_MODEL" or "FACE_BASED_SURFACE_MODEL" or "MANIFOLD_SOLID_BREP" or "BREP_WITH_VOIDS" or "FACETED_BREP"
        or "OPEN_SHELL"
            or "CLOSED_SHELL"
            or "ORIENTED_OPEN_SHELL"
            or "ORIENTED_CLOSED_SHELL"
            or "CONNECTED_FACE_SET"
            or "CONNECTED_FACE_SUB_SET"
            or "GEOMETRIC_SET"
            or "GEOMETRIC_CURVE_SET";
}
