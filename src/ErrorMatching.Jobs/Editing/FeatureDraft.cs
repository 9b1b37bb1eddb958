using System.Globalization;
using System.Text.Json.Serialization;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>A feature of the mating boundary, as typed.</summary>
public sealed record FeatureDraft
{
    /// <summary>Its kind.</summary>
    public FeatureKind Kind { get; init; } = FeatureKinds.All[0];

    /// <summary>Its name.</summary>
    public string Name { get; init; } = "";

    /// <summary>Its key points in the order of cutting, in one list per number in <see cref="FeatureKind.LeastPoints"/>.</summary>
    public IReadOnlyList<IReadOnlyList<PointDraft>> Flanks { get; init; } = [[]];

    /// <summary>Selectors of the blocks that cut it, separated by commas.</summary>
    public string Blocks { get; init; } = "";

    /// <summary>The individual block selectors.</summary>
    [JsonIgnore]
    public IReadOnlyList<string> BlockList => DraftList.Blocks(Blocks);

    /// <summary><c>stated</c> if <see cref="Lower"/> and <see cref="Upper"/> apply, otherwise <c>chain:worst-case</c> or
    /// <c>chain:rss</c>.</summary>
    public string Tolerance { get; init; } = Stated;

    /// <summary>Lower limit of the deviation, mm.</summary>
    public string Lower { get; init; } = "";

    /// <summary>Upper limit of the deviation, mm.</summary>
    public string Upper { get; init; } = "";

    /// <summary>The plane of its points: <c>XY</c>, <c>ZX</c> or <c>YZ</c>.</summary>
    public string Plane { get; init; } = "XY";

    /// <summary>The texts of the keys that only its kind has (<see cref="FeatureKind.Keys"/>).</summary>
    public IReadOnlyDictionary<string, string> Keys { get; init; } = new Dictionary<string, string>();

    /// <summary>The word for stated limits.</summary>
    public const string Stated = "stated";

    /// <summary>All its points in the order of cutting.</summary>
    [JsonIgnore]
    public IEnumerable<PointDraft> Points => Flanks.SelectMany(f => f);

    /// <summary>A new feature with its kind's minimum number of points, with labels that are unused in the draft.</summary>
    /// <param name="kind">Its kind.</param>
    /// <param name="name">Its name.</param>
    /// <param name="draft">The draft that it will be added to.</param>
    public static FeatureDraft New(FeatureKind kind, string name, MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(kind);
        ArgumentNullException.ThrowIfNull(draft);
        var next = draft.NextLabel;
        return new()
        {
            Kind = kind,
            Name = name,
            Flanks = [
                .. kind.LeastPoints.Select(
                    c => (IReadOnlyList<PointDraft>)[.. Enumerable.Range(0, c).Select(_ => new PointDraft(PointLabel.Of(next++)))])],
            Keys = kind.Keys.ToDictionary(k => k.Name, k => k.Default, StringComparer.Ordinal),
        };
    }

    /// <summary>The text of a key of its kind.</summary>
    public string Key(string name) => Keys[name];

    /// <summary>The feature with another text for a key of its kind.</summary>
    public FeatureDraft WithKey(string name, string text) =>
        this with { Keys = Kind.Keys.ToDictionary(k => k.Name, k => k.Name == name ? text : Keys[k.Name], StringComparer.Ordinal) };
}

/// <summary>A theoretical key point, as typed.</summary>
/// <param name="Label">Its label.</param>
/// <param name="X">Coordinate along the first axis, mm.</param>
/// <param name="Y">Coordinate along the second axis, mm.</param>
/// <param name="Z">Coordinate along the third axis, mm; empty for points of a plane.</param>
public sealed record PointDraft(string Label, string X = "", string Y = "", string Z = "");

/// <summary>Numeric point labels.</summary>
internal static class PointLabel
{
    /// <summary>The label of a number.</summary>
    public static string Of(int number) => number.ToString(CultureInfo.InvariantCulture);

    /// <summary>The number at the start of a label; 0 if there is none.</summary>
    public static int NumberOf(string label)
    {
        var digits = label.AsSpan(0, label.AsSpan().IndexOfAnyExceptInRange('0', '9') is var end and >= 0 ? end : label.Length);
        return int.TryParse(digits, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number < int.MaxValue / 2
            ? number
            : 0;
    }
}
