using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Which faces the shape aspects of a STEP file are (ISO 10303-41, -47): each aspect by what it identifies, and by the aspects
/// that it is made of.</summary>
internal sealed class StepAspects
{
    // Of all aspects together. Composites of composites could name each face again and again.
    private const int MaxFaces = 2_000_000;

    private readonly StepFile _file;
    private readonly Dictionary<long, List<StepRecord>> _usages = [];
    private readonly Dictionary<long, List<long>> _parts = [];
    private readonly Dictionary<long, AspectShape> _known = [];
    private readonly HashSet<long> _open = [];
    private int _faces;

    /// <summary>Indexes the aspects of a file.</summary>
    public StepAspects(StepFile file)
    {
        _file = file;
        foreach (var id in file.Ids(k => k is "GEOMETRIC_ITEM_SPECIFIC_USAGE" or "ITEM_IDENTIFIED_REPRESENTATION_USAGE"))
        {
            if (Tried(id) is { Values: [_, _, { Kind: StepValueKind.Reference } of, _, _, ..] } usage)
            {
                Add(_usages, (long)of.Number, usage);
            }
        }

        foreach (var id in file.Ids(k => k == "SHAPE_ASPECT_RELATIONSHIP"))
        {
            if (Tried(id) is
                { Values: [_, _, { Kind: StepValueKind.Reference } whole, { Kind: StepValueKind.Reference } part, ..] })
            {
                Add(_parts, (long)whole.Number, (long)part.Number);
            }
        }
    }

    /// <summary>What an aspect is.</summary>
    /// <param name="aspect">A shape aspect, a dimension of one, or the shape of the whole part.</param>
    /// <exception cref="InputException">It is broken, is made of itself, or there are too many faces.</exception>
    public AspectShape Of(StepInstance aspect) => Of(aspect, 0);

    private AspectShape Of(StepInstance aspect, int depth)
    {
        if (_known.TryGetValue(aspect.Id, out var known))
        {
            return known;
        }

        var owner = aspect.Records[0];
        if (depth > ExchangeLimits.MaxDepth || !_open.Add(aspect.Id))
        {
            throw owner.Fail("too-deep", depth > ExchangeLimits.MaxDepth
                ? $"shape aspects refer to one another deeper than {ExchangeLimits.MaxDepth}"
                : "a shape aspect that is made of itself");
        }

        try
        {
            return _known[aspect.Id] = Read(aspect, depth);
        }
        finally
        {
            _open.Remove(aspect.Id);
        }
    }

    private AspectShape Read(StepInstance aspect, int depth)
    {
        if (aspect.Keyword == "PRODUCT_DEFINITION_SHAPE")
        {
            return AspectShape.Whole;
        }

        var (faces, others) = (new HashSet<long>(), new List<string>());
        foreach (var usage in _usages.GetValueOrDefault(aspect.Id) ?? [])
        {
            foreach (var item in Items(usage.At(4)).Where(i => i.Kind == StepValueKind.Reference))
            {
                var instance = usage.Instance(item, 4);
                if (StepFace.IsFace(instance))
                {
                    faces.Add(instance.Id);
                }
                else
                {
                    others.Add(instance.ToString());
                }
            }
        }

        // Of a limited stretch of faces nothing says here where it ends; a derived aspect is a center, which has no surface.
        if (aspect.Records.FirstOrDefault(r => r.Keyword is "BETWEEN_SHAPE_ASPECT"
            || r.Keyword is "CENTRE_OF_SYMMETRY" or "APEX" or "GEOMETRIC_ALIGNMENT" or "GEOMETRIC_INTERSECTION" or "PARALLEL_OFFSET"
                or "PERPENDICULAR_TO" or "TANGENT" or "EXTENSION" or "DERIVED_SHAPE_ASPECT") is { } odd)
        {
            others.Add(odd.ToString());
        }

        var inner = _parts.GetValueOrDefault(aspect.Id)?.Select(p => _file.At(p)).OfType<StepInstance>() ?? [];
        if (aspect.Records.FirstOrDefault(r => r.Keyword is "DIMENSIONAL_SIZE" or "ANGULAR_SIZE" or "DIMENSIONAL_SIZE_WITH_PATH"
            && r.Values.Count >= 2) is { } size)
        {
            inner = inner.Append(size.Instance(0));
        }

        // A dimension that is a datum feature itself is applied to itself.
        foreach (var part in inner.Where(i => i.Find("DATUM") is null && i.Id != aspect.Id))
        {
            var shape = Of(part, depth + 1);
            faces.UnionWith(shape.Faces);
            others.AddRange(shape.Others);
        }

        _faces += faces.Count + others.Count;
        return _faces <= MaxFaces
            ? new([.. faces.Order()], [.. others.Distinct(StringComparer.Ordinal)], false)
            : throw aspect.Records[0].Fail("too-large", string.Create(
                CultureInfo.InvariantCulture, $"more than {MaxFaces} faces in all shape aspects together"));
    }

    private StepRecord? Tried(long id)
    {
        try
        {
            return _file.At(id)!.Records[0];
        }
        catch (InputException)
        {
            return null;
        }
    }

    // A reference, several in parentheses, or several in a set with a type.
    private static IEnumerable<StepValue> Items(StepValue value) =>
        value.Kind is StepValueKind.List or StepValueKind.Typed ? value.Items.SelectMany(Items) : [value];

    private static void Add<T>(Dictionary<long, List<T>> to, long key, T value)
    {
        if (!to.TryGetValue(key, out var list))
        {
            to[key] = list = [];
        }

        list.Add(value);
    }
}

/// <summary>What a shape aspect is.</summary>
/// <param name="Faces">The numbers of its faces, in order.</param>
/// <param name="Others">What else it is.</param>
/// <param name="IsWhole">True for the whole part.</param>
internal sealed record AspectShape(IReadOnlyList<long> Faces, IReadOnlyList<string> Others, bool IsWhole)
{
    public static AspectShape Whole { get; } = new([], [], true);
}
