using System.Globalization;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;

namespace ErrorMatching.Jobs;

/// <summary>A feature of the mating boundary, as typed.</summary>
public sealed record FeatureDraft
{
    /// <summary>The key of its name.</summary>
    public const string NameKey = "name";

    /// <summary>The key of its points.</summary>
    public const string PointsKey = "points";

    /// <summary>The key of the blocks that cut it.</summary>
    public const string BlocksKey = "blocks";

    /// <summary>The key of its limits: a word, or the lower and the upper limit.</summary>
    public const string ToleranceKey = "toleranceMm";

    /// <summary>The key of the lower limit.</summary>
    public const string LowerKey = ToleranceKey + "[0]";

    /// <summary>The key of the upper limit.</summary>
    public const string UpperKey = ToleranceKey + "[1]";

    /// <summary>The key of the plane of its points.</summary>
    public const string PlaneKey = "plane";

    /// <summary>The word for stated limits.</summary>
    public const string Stated = "stated";

    private const string KindKey = "kind";

    private static readonly SchemaPlace Place = MatingJob.Schema.Root.Member(MatingDraft.FeaturesKey).Item;

    /// <summary>All its keys but those of its points.</summary>
    [JsonRequired]
    public DraftDocument Document { get; init; } = DraftDocument.Empty;

    /// <summary>Its key points in the order of cutting, in one list per number in <see cref="FeatureKind.LeastPoints"/>.</summary>
    public IReadOnlyList<IReadOnlyList<PointDraft>> Flanks { get; init; } = [[]];

    /// <summary>The text of a key; empty if it has none.</summary>
    public string this[string key] => Document["$." + key];

    /// <summary>Its kind.</summary>
    /// <exception cref="ArgumentException">There is no such kind.</exception>
    [JsonIgnore]
    public FeatureKind Kind
    {
        get => this[KindKey] is { Length: > 0 } word ? FeatureKinds.Of(word) : FeatureKinds.All[0];
        init => Document = With(KindKey, value.Word).Document;
    }

    /// <summary>Its name.</summary>
    [JsonIgnore]
    public string Name
    {
        get => this[NameKey];
        init => Document = With(NameKey, value).Document;
    }

    /// <summary>Selectors of the blocks that cut it, separated by commas.</summary>
    [JsonIgnore]
    public string Blocks
    {
        get => this[BlocksKey];
        init => Document = With(BlocksKey, value).Document;
    }

    /// <summary>The individual block selectors.</summary>
    [JsonIgnore]
    public IReadOnlyList<string> BlockList => DraftList.Blocks(Blocks);

    /// <summary><c>stated</c> if <see cref="Lower"/> and <see cref="Upper"/> apply, otherwise <c>chain:worst-case</c> or
    /// <c>chain:rss</c>. Another word takes the limits away.</summary>
    [JsonIgnore]
    public string Tolerance
    {
        get => Document.Count("$." + ToleranceKey) == 0 && this[ToleranceKey] is { Length: > 0 } word ? word : Stated;
        init => Document = value == Tolerance ? Document : With(ToleranceKey, value == Stated ? "" : value).Document;
    }

    /// <summary>Lower limit of the deviation, mm; empty if the limits are not stated.</summary>
    [JsonIgnore]
    public string Lower
    {
        get => this[LowerKey];
        init => Document = With(LowerKey, value).Document;
    }

    /// <summary>Upper limit of the deviation, mm; empty if the limits are not stated.</summary>
    [JsonIgnore]
    public string Upper
    {
        get => this[UpperKey];
        init => Document = With(UpperKey, value).Document;
    }

    /// <summary>The plane of its points: <c>XY</c>, <c>ZX</c> or <c>YZ</c>.</summary>
    [JsonIgnore]
    public string Plane
    {
        get => this[PlaneKey] is { Length: > 0 } plane ? plane : "XY";
        init => Document = With(PlaneKey, value).Document;
    }

    /// <summary>All its points in the order of cutting.</summary>
    [JsonIgnore]
    public IEnumerable<PointDraft> Points => Flanks.SelectMany(f => f);

    /// <summary>False if it is from an external file and of no kind, or with a wrong number of lists, or with a null entry.</summary>
    [JsonIgnore]
    internal bool IsWhole =>
        (this[KindKey].Length == 0 || FeatureKinds.Find(this[KindKey]) is not null)
        && Flanks.Count == Kind.LeastPoints.Count
        && Flanks.All(k => k is not null && !k.Contains(null!));

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
            Name = name,
            Kind = kind,
            Flanks = [
                .. kind.LeastPoints.Select(
                    c => (IReadOnlyList<PointDraft>)[.. Enumerable.Range(0, c).Select(_ => new PointDraft(PointLabel.Of(next++)))])],
        };
    }

    /// <summary>The feature with another text for a key.</summary>
    public FeatureDraft With(string key, string text) => this with { Document = Document.With(Place, "$." + key, text) };

    /// <summary>The feature with another one's limits, or their source.</summary>
    internal FeatureDraft WithLimitsOf(FeatureDraft other) =>
        this with { Document = Document.With(Place, "$." + ToleranceKey, other.Document) };

    /// <summary>A feature of the job's file, with its points from their own file.</summary>
    /// <param name="item">The feature.</param>
    /// <param name="pointOf">The point with a label.</param>
    internal static FeatureDraft Read(JsonItem item, Func<string, PointDraft> pointOf)
    {
        var points = item[PointsKey];
        var document = (JsonObject)JsonNode.Parse(item.ToJson())!;
        document[PointsKey] = new JsonArray();
        return new()
        {
            Document = new(document),
            Flanks = FeatureKinds.Of(item[KindKey].Text).LeastPoints.Count > 1 ? [.. points.Items.Select(Points)] : [Points(points)],
        };

        IReadOnlyList<PointDraft> Points(JsonItem list) => [.. list.Items.SelectMany(i => LabelRange.Expand(i.Text)).Select(pointOf)];
    }

    /// <summary>The feature in the job's file, apart from what typed texts mean.</summary>
    internal JsonObject Write()
    {
        var feature = With(KindKey, Kind.Word).Document.Copy();
        JsonNode[] flanks = [.. Flanks.Select(f => new JsonArray([.. f.Select(p => JsonValue.Create(p.Label.Trim()))]))];
        DraftDocument.Put(feature, Place, PointsKey, flanks.Length > 1 ? new JsonArray(flanks) : flanks[0]);
        return feature;
    }
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
