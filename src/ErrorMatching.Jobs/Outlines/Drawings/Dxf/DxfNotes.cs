using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>Counts what is passed over, for one sentence for each reason.</summary>
internal sealed class DxfNotes
{
    private readonly SortedDictionary<DxfNote, (int Count, string First)> _counts = [];
    private readonly Dictionary<string, int> _kinds = new(StringComparer.Ordinal);
    private readonly Dictionary<string, int> _layers = new(StringComparer.Ordinal);
    private int _clips;

    /// <summary>Counts an entity.</summary>
    public void Count(DxfNote note, DxfEntity entity) =>
        _counts[note] = _counts.TryGetValue(note, out var known) ? (known.Count + 1, known.First) : (1, entity.Label);

    /// <summary>Counts entities of a kind that has no curve.</summary>
    public void Kind(string kind, int count) => Count(_kinds, kind, count);

    /// <summary>Counts an entity on a layer that is off or frozen.</summary>
    public void Hidden(string layer) => Count(_layers, layer, 1);

    /// <summary>Counts a clip of a block.</summary>
    public void Clip() => _clips++;

    /// <summary>The kinds without a curve in words; empty if there are none.</summary>
    public string Kinds() => Named(_kinds, (count, name) => string.Create(CultureInfo.InvariantCulture, $"{count} {name}"));

    /// <summary>The sentences.</summary>
    public List<string> ToList()
    {
        List<string> all = [];
        if (_kinds.Count > 0)
        {
            all.Add($"Passed over as no curves: {Kinds()}.");
        }

        if (_layers.Count > 0)
        {
            var total = _layers.Values.Sum();
            var names = Named(_layers, (_, name) => DrawingLimits.Quote(name));
            all.Add(string.Create(
                CultureInfo.InvariantCulture, $"Passed over on layers that are off or frozen: {Entities(total)} ({names})."));
        }

        foreach (var (note, (count, first)) in _counts)
        {
            all.Add(Sentence(note, count, first));
        }

        if (_clips > 0)
        {
            all.Add(string.Create(
                CultureInfo.InvariantCulture, $"The drawing clips inserted blocks ({_clips} SPATIAL_FILTER); they are read in full."));
        }

        return all;
    }

    private static string Sentence(DxfNote note, int count, string first)
    {
        var entities = $"{Entities(count)} (first: {first})";
        return note switch
        {
            DxfNote.Paper => $"Passed over in paper space: {entities}.",
            DxfNote.Invisible => $"Passed over as invisible: {entities}.",
            DxfNote.NoLength => $"Passed over as shorter than 0.000001 mm: {Many(count, "curve")} (first: {first}).",
            DxfNote.NoSize => $"Passed over, because a radius or an axis is 0: {entities}.",
            DxfNote.Tilted => $"Passed over, because their extrusion is not along Z: {entities}.",
            DxfNote.Sloped => $"Projected onto XY, because Z changes along them: {entities}.",
            DxfNote.Wide => $"Read as their center lines, because they have a width: {entities}.",
            DxfNote.Approximated => $"Splines that the file has as straight pieces: {entities}.",
            DxfNote.Mesh => $"Passed over as meshes: {entities}.",
            _ => $"Passed over, because their blocks are in other files: {entities}.",
        };
    }

    private static string Entities(int count) => Many(count, "entit", "y", "ies");

    private static string Many(int count, string word, string one = "", string many = "s") =>
        string.Create(CultureInfo.InvariantCulture, $"{count} {word}{(count == 1 ? one : many)}");

    private static void Count(Dictionary<string, int> counts, string name, int count)
    {
        var key = counts.Count < DxfLimits.MaxNamed || counts.ContainsKey(name) ? name : "";
        counts[key] = counts.GetValueOrDefault(key) + count;
    }

    private static string Named(Dictionary<string, int> counts, Func<int, string, string> show) =>
        string.Join(", ", counts.Select(c => c.Key.Length > 0
            ? show(c.Value, c.Key)
            : string.Create(CultureInfo.InvariantCulture, $"{c.Value} others")));
}

/// <summary>What a reader does not take as it is.</summary>
internal enum DxfNote
{
    /// <summary>Entities in paper space.</summary>
    Paper,

    /// <summary>Entities that are not shown.</summary>
    Invisible,

    /// <summary>Curves that are points.</summary>
    NoLength,

    /// <summary>Circles and ellipses without a size.</summary>
    NoSize,

    /// <summary>Planar entities in a plane that is not parallel to XY.</summary>
    Tilted,

    /// <summary>Curves whose points differ in Z.</summary>
    Sloped,

    /// <summary>Polylines with a width.</summary>
    Wide,

    /// <summary>Polylines that a CAD system computed from a spline.</summary>
    Approximated,

    /// <summary>Meshes of POLYLINE.</summary>
    Mesh,

    /// <summary>Blocks in other files.</summary>
    External,
}
